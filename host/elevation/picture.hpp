#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/math.hpp"
#include "elevation/raster.hpp"
#include "geo/place.hpp"

/// Pictures of land from files: orthophotos, satellite pictures and maps.
namespace aerostat::elevation {

using glm::vec4;

/// What a user says of a picture. It wins over what the file says.
struct PictureOptions {
  std::string crs;  // empty: as the file says
  /// The outer corners of the picture in the north-west and in the south-east.
  std::optional<std::array<geo::Place, 2>> corners;

  bool operator==(const PictureOptions&) const = default;
};

/// The most pixels of a PNG or JPEG, which have to be in memory as a whole, and the most bytes of
/// such a file.
inline constexpr std::uint64_t kMostPixelsInMemory = std::uint64_t{1} << 27;
inline constexpr std::uint64_t kMostPictureBytes = std::uint64_t{1} << 30;

/// The albedo of white. Fresh snow has about as much, and no ground has more. A colour is decoded
/// by the curve of sRGB and multiplied by this. Photographs of land are exposed so that the ground
/// is at a tenth to a third of white, which is about its albedo, so that nothing else is needed.
inline constexpr float kWhiteAlbedo = 0.85f;

/// A picture in a file, with its overviews as levels. It may be read from any thread.
class Picture {
 public:
  virtual ~Picture() = default;

  /// What is known of the picture. It always has a place, whose system is empty only if the file
  /// does not say any.
  const RasterInfo& info() const { return info_; }

  /// Returns the width and height of each level in pixels. The first one is the picture itself, and
  /// its overviews follow, finest first.
  const std::vector<std::array<int, 2>>& levels() const { return levels_; }

  /// Reads a window of a level, row by row: the albedo as linear red, green and blue, multiplied by
  /// the opacity, and the opacity from 0 to 1. The window must lie in the level. Throws
  /// Error{bad_data} with the file's name if the file is damaged.
  virtual void read(int level, const Window& window, vec4* pixels) const = 0;

 protected:
  Picture(RasterInfo info, std::vector<std::array<int, 2>> levels)
      : info_(std::move(info)), levels_(std::move(levels)) {}

  RasterInfo info_;
  std::vector<std::array<int, 2>> levels_;
};

/// Opens a GeoTIFF, PNG or JPEG file. Throws Error{io} if it cannot be read, and Error{bad_data}
/// with the file's name, what was found and which option helps.
std::unique_ptr<Picture> open_picture(const std::filesystem::path& path,
                                      const PictureOptions& options);

/// Returns the albedo of a share of white, from 0 to 1, that is coded as sRGB.
float albedo_of_srgb(double share);

/// These functions open a file of one kind. Its place is still missing unless the tags give it.
std::unique_ptr<Picture> open_tiff_picture(const std::filesystem::path& path,
                                           const PictureOptions& options);
std::unique_ptr<Picture> open_image_picture(const std::filesystem::path& path,
                                            const PictureOptions& options);

/// Sets the place of a picture from the corners of the user, or else from the files beside it,
/// unless it has one. Throws Error{bad_data}, which names the options, if there is none.
void set_picture_place(RasterInfo& info, const PictureOptions& options);

}  // namespace aerostat::elevation

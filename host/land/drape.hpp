#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "elevation/picture.hpp"
#include "land/land.hpp"
#include "land/nested_levels.hpp"

/// A picture over the land.
namespace aerostat::land {

using glm::vec4;

/// The least and the most texels along a side of a level, and the most levels. Together they bound
/// the memory of a drape, whatever the size of its file: 4 bytes a texel, 192 MiB in all.
inline constexpr int kLeastDrapeSide = 256, kMostDrapeSide = 2048, kMostDrapeLevels = 12;

/// What is asked of a drape.
struct DrapeOptions {
  std::filesystem::path file;
  elevation::PictureOptions picture;
  LandPoint middle;      // the middle of the local frame
  double reach_m = 0.0;  // half of the side of the square around it that is looked at
  /// By how much the picture's light and shade are taken out, 0 to 1. More than 0 needs the land
  /// below.
  double lift_shadows = 0.0;
  std::shared_ptr<const Land> land{};

  bool operator==(const DrapeOptions&) const = default;
};

/// A picture in the local frame, in levels of detail: squares around one point, with the same
/// number of texels each. Each is twice as wide as the one before, so that what is near the point
/// is as fine as in the file and the whole land is covered. Texels are means over the picture's
/// pixels by area and opacity. It never changes and may be used from any thread.
class Drape {
 public:
  /// Reads the picture once for each level, as far as it lies within reach. Throws the errors of
  /// open_picture(), and Error{bad_data} if the picture lies elsewhere or its system is unknown.
  explicit Drape(const DrapeOptions& options);

  int side() const { return levels_.side; }
  int levels() const { return levels_.levels; }
  /// The width of a texel of the first level in metres.
  double texel_m() const { return levels_.texel_m; }
  /// The middle of all levels, in metres to the east and to the south.
  const dvec2& middle() const { return levels_.middle; }

  /// The texels, level by level and row by row from the north-west. The lowest byte is red, and
  /// green, blue and opacity follow. A byte of colour is 255 times the square root of the albedo
  /// multiplied by the opacity, and the last byte is 255 times the opacity.
  const std::vector<std::uint32_t>& texels() const { return levels_.texels; }

  /// Returns the albedo multiplied by the opacity, and the opacity, at a point of the local frame,
  /// filtered over a footprint in metres. Kernels compute the same.
  vec4 at(double east_m, double south_m, double footprint_m) const;

  /// Sentences for the user on what was guessed about the file, which name it.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  /// Takes the picture's own light and shade out.
  void lift(const DrapeOptions& options);

  std::vector<std::string> notes_;
  NestedLevels levels_;
};

/// Returns a texel that holds an albedo multiplied by the opacity, and the opacity.
std::uint32_t packed_texel(const vec4& colour);
/// Returns the colour of a texel.
vec4 colour_of_texel(std::uint32_t texel);

}  // namespace aerostat::land

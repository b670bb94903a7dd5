#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "aerostat/export.hpp"

namespace aerostat {

/// A rendered picture with its radiance and layers that tell what each pixel shows. Row 0 is at
/// the top. A film is cheap to copy. The arrays live as long as any copy of the film.
class AEROSTAT_API Film {
 public:
  /// Makes a film without pixels.
  Film();

  int width() const;
  int height() const;

  /// Returns linear Rec. 709 radiance, as three floats for each pixel: red, green and blue.
  std::span<const float> radiance() const;
  /// Returns the share of each pixel's samples that hit something, 0 to 1.
  std::span<const float> alpha() const;
  /// Returns the distance along the ray to the nearest sample in metres, or infinity for sky.
  std::span<const float> distance_m() const;
  /// Returns the share of light that surfaces reflect, as three floats for each pixel, averaged
  /// over the samples. Sky counts as 0. It is empty if the session keeps no guides.
  std::span<const float> albedo() const;
  /// Returns the unit normals in world space, as three floats for each pixel, averaged over the
  /// samples. Sky counts as 0. It is empty if the session keeps no guides.
  std::span<const float> normal() const;
  /// Returns the number of the object that the nearest sample hit, or 0 for sky.
  std::span<const std::uint32_t> object_id() const;

  /// Returns the film with less noise in its radiance, as Open Image Denoise 2 finds it. That
  /// library is loaded at the first call, from the folder in AEROSTAT_OIDN_DIR if that is set.
  /// Throws Error{no_device} if it is missing, Error{usage} if the film has no albedos and normals,
  /// and Error{exhausted} if memory does not suffice.
  Film denoised() const;

  /// Returns the picture with the exposure, white balance and tone mapping that the scene asks
  /// for, as three bytes of sRGB for each pixel.
  std::vector<std::uint8_t> to_rgb8() const;
  /// Returns the bytes of a PNG file with the picture of `to_rgb8`. Throws Error{usage} for more
  /// pixels than a PNG can hold.
  std::vector<std::uint8_t> to_png() const;
  /// Returns the bytes of an OpenEXR file with the radiance and all layers.
  std::vector<std::uint8_t> to_exr() const;

  /// Writes a PNG or an OpenEXR file, chosen by the ending of the name. The file is written whole
  /// or not at all. Throws Error{usage} for any other ending, and Error{io} if the file cannot be
  /// written.
  void save(const std::filesystem::path& path) const;

  struct AEROSTAT_HIDDEN State;  ///< internal
  explicit Film(std::shared_ptr<const State> state);

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace aerostat

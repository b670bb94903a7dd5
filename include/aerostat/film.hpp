#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "aerostat/export.hpp"

namespace aerostat {

/// A rendered picture: the light as it was measured, and what each pixel shows. Row 0 is at the
/// top. Cheap to copy; the arrays live as long as any copy does.
class AEROSTAT_API Film {
 public:
  /// A film without pixels.
  Film();

  int width() const;
  int height() const;

  /// Linear Rec. 709 radiance: three floats a pixel, red, green and blue.
  std::span<const float> radiance() const;
  /// Share of a pixel's samples that met something, 0 to 1.
  std::span<const float> alpha() const;
  /// Metres along the ray to the nearest sample; infinite where there is only sky.
  std::span<const float> distance_m() const;
  /// Unit normal in world space of the nearest sample, three floats a pixel; 0 for sky.
  std::span<const float> normal() const;
  /// Number of the object that the nearest sample met; 0 for sky.
  std::span<const std::uint32_t> object_id() const;

  /// Exposed, white balanced and tone mapped as the scene asks: three bytes a pixel, sRGB.
  std::vector<std::uint8_t> to_rgb8() const;
  /// The bytes of a PNG file of `to_rgb8`. Throws Error{usage} for more pixels than a PNG can hold.
  std::vector<std::uint8_t> to_png() const;
  /// The bytes of an OpenEXR file with the light and all layers.
  std::vector<std::uint8_t> to_exr() const;

  /// Writes a PNG or an OpenEXR file, by the ending of the name. The file is written whole or not
  /// at all. Throws Error{usage} for another ending, and Error{io} if it cannot be written.
  void save(const std::filesystem::path& path) const;

  struct AEROSTAT_HIDDEN State;  ///< internal
  explicit Film(std::shared_ptr<const State> state);

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace aerostat

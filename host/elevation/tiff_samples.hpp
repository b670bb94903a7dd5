#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aerostat::elevation {

/// The types of samples in TIFF files. `bit` is that of masks.
enum class TiffSample {
  bit,
  uint8,
  int8,
  uint16,
  int16,
  uint32,
  int32,
  uint64,
  int64,
  float16,
  float24,
  float32,
  float64
};

const char* name_of(TiffSample type);
int bits_of(TiffSample type);
bool is_float(TiffSample type);
/// Returns the lowest and the highest value that a type is meant to store: 0 and 1 for floats.
double lowest_of(TiffSample type);
double highest_of(TiffSample type);

/// The value that marks samples without a height, as text. Integers of 64 bits would lose digits as
/// a double.
struct Nodata {
  std::string text;
  /// Returns whether a sample of a type can have this value.
  bool fits(TiffSample type) const;
};

/// How samples become heights in metres: (sample * scale + offset) * metres_per_unit.
struct HeightRule {
  TiffSample type = TiffSample::uint8;
  std::optional<Nodata> nodata;
  double scale = 1.0, offset = 0.0, metres_per_unit = 1.0;
};

/// Turns `count` samples into heights. They are `stride` samples apart, in this machine's order of
/// bytes. A sample becomes NaN if it is the nodata value in the type of the file, or if it is no
/// number or beyond 1e30, as the marks of voids are that got lost between types.
void samples_to_heights(const HeightRule& rule, const std::uint8_t* samples, std::size_t stride,
                        std::size_t count, float* heights);

/// Undoes the predictor of TIFF for floating point numbers (Adobe Photoshop TIFF Technical Note 3,
/// 2005) in a row of `count` samples of `sample_bytes` bytes: differences of bytes are summed up,
/// and the bytes of each sample, of which all first ones come first, are gathered in this machine's
/// order. `scratch` is memory for a row.
void undo_float_predictor(std::uint8_t* row, std::size_t count, std::size_t sample_bytes,
                          std::vector<std::uint8_t>& scratch);

}  // namespace aerostat::elevation

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "elevation/bytes.hpp"
#include "elevation/raster.hpp"

namespace aerostat::elevation {

enum class SampleType { uint8, int8, uint16, int16, uint32, int32, float32, float64 };

/// Returns the type that a name such as "int16" stands for.
std::optional<SampleType> sample_type_of(std::string_view name);
const char* name_of(SampleType type);
int bytes_of(SampleType type);

/// Where the samples of a raster lie in a file without compression.
struct SampleLayout {
  SampleType type = SampleType::int16;
  bool big_endian = false;
  std::uint64_t first = 0;       // the place in bytes of the first sample of the first row
  std::uint64_t row_stride = 0;  // bytes from a row to the next
  /// Stored values that are voids. No number and infinity are voids in any case.
  std::vector<double> voids;
  double scale = 1.0, offset_m = 0.0;  // metres are scale * stored + offset_m
};

/// A raster whose rows lie in a file without compression.
class SampleRaster final : public Raster {
 public:
  /// All rows must lie in `bytes`.
  SampleRaster(RasterInfo info, std::shared_ptr<const ByteSource> bytes, SampleLayout layout);

  void read(const Window& window, float* heights) const override;

 private:
  std::shared_ptr<const ByteSource> bytes_;
  SampleLayout layout_;
};

}  // namespace aerostat::elevation

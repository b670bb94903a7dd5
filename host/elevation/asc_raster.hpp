#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "elevation/block_cache.hpp"
#include "elevation/bytes.hpp"
#include "elevation/raster.hpp"
#include "elevation/words.hpp"

namespace aerostat::elevation {

/// The heights behind the header of an ESRI grid. A large file is not kept in memory: its first
/// reading only finds where bands of rows begin, and windows read their bands again.
class AscBody {
 public:
  /// Takes the size, unit and name from `info`. `mark` is the value of voids.
  AscBody(const RasterInfo& info, double mark) : info_(info), mark_(mark) {}

  /// Reads the next `count` heights. Throws Error{bad_data} if there are fewer, or other words.
  /// `first` is the number of the first one, for messages.
  void read(Words& words, std::size_t first, std::size_t count, float* heights);

  bool all_whole() const { return all_whole_; }
  bool has_comma() const { return has_comma_; }
  bool has_mark() const { return has_mark_; }

 private:
  const RasterInfo& info_;
  double mark_;
  bool all_whole_ = true, has_comma_ = false, has_mark_ = false;
};

/// An ESRI grid whose heights stay in the file.
class AscRaster final : public Raster {
 public:
  /// Band number k begins at the byte begins[k] and has `band_rows` rows, or fewer at the end.
  AscRaster(RasterInfo info, std::shared_ptr<const ByteSource> bytes, double mark, int band_rows,
            std::vector<std::uint64_t> begins);
  ~AscRaster() override;

  void read(const Window& window, float* heights) const override;

 private:
  BlockCache::Block band(int number) const;

  std::shared_ptr<const ByteSource> bytes_;
  double mark_;
  int band_rows_;
  std::vector<std::uint64_t> begins_;
  std::uint64_t file_;
};

}  // namespace aerostat::elevation

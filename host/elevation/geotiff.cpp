#include "elevation/geotiff.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "elevation/block_cache.hpp"
#include "elevation/geotiff_info.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

/// A directory from which several threads read blocks, each by a handle of its own.
class BlockReader {
 public:
  BlockReader(std::shared_ptr<const OpenFile> file, TiffPage page)
      : file_(std::move(file)), page_(std::move(page)) {
    undoes_predictor_ = has_float_predictor(TiffHandle(file_, page_.directory).get());
  }

  const TiffLayout& layout() const { return page_.layout; }

  /// Decodes a block and turns its samples into heights. A block that the file leaves out has the
  /// nodata value or, without any, zeros.
  BlockCache::Block block(int column, int row, const HeightRule& rule) const {
    std::unique_ptr<TiffHandle> handle = take();
    BlockCache::Block result = decode(*handle, column, row, rule);
    give_back(std::move(handle));
    return result;
  }

 private:
  std::unique_ptr<TiffHandle> take() const {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<TiffHandle> handle = std::move(idle_.back());
        idle_.pop_back();
        return handle;
      }
    }
    return open();
  }

  /// Opens a handle. Where this program undoes the predictor, libtiff is told that there is none.
  std::unique_ptr<TiffHandle> open() const {
    auto handle = std::make_unique<TiffHandle>(file_, page_.directory);
    if (has_float_predictor(handle->get())) {
      TIFFSetField(handle->get(), TIFFTAG_PREDICTOR, PREDICTOR_NONE);
    }
    return handle;
  }

  /// Returns whether blocks have the predictor for floating point numbers and this program undoes
  /// it, which it does several times as fast as libtiff.
  bool has_float_predictor(TIFF* tiff) const {
    const TiffLayout& l = page_.layout;
    const bool is_float = l.sample == TiffSample::float32 || l.sample == TiffSample::float64;
    if (!is_float || l.stride() != 1 || TIFFIsByteSwapped(tiff) != 0) return false;
    std::uint16_t predictor = PREDICTOR_NONE;
    return TIFFGetField(tiff, TIFFTAG_PREDICTOR, &predictor) != 0 &&
           predictor == PREDICTOR_FLOATINGPOINT;
  }

  void give_back(std::unique_ptr<TiffHandle> handle) const {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(handle));
  }

  BlockCache::Block decode(const TiffHandle& handle, int column, int row,
                           const HeightRule& rule) const;
  std::shared_ptr<std::vector<float>> decode_band(const TiffHandle& handle, int column, int row,
                                                  int band, const HeightRule& rule) const;

  std::shared_ptr<const OpenFile> file_;
  TiffPage page_;
  bool undoes_predictor_ = false;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<TiffHandle>> idle_;
};

BlockCache::Block BlockReader::decode(const TiffHandle& handle, int column, int row,
                                      const HeightRule& rule) const {
  const std::shared_ptr<std::vector<float>> heights = decode_band(handle, column, row, 0, rule);
  if (page_.layout.opacity <= 0) return heights;
  // What is transparent has no height.
  HeightRule as_stored;
  as_stored.type = page_.layout.sample;
  const auto opacity = decode_band(handle, column, row, page_.layout.opacity, as_stored);
  for (std::size_t i = 0; i < heights->size(); ++i) {
    if ((*opacity)[i] == 0.0f) (*heights)[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return heights;
}

std::shared_ptr<std::vector<float>> BlockReader::decode_band(const TiffHandle& handle, int column,
                                                             int row, int band,
                                                             const HeightRule& rule) const {
  const TiffLayout& l = page_.layout;
  TIFF* const tiff = handle.get();
  const int first_row = row * l.block_height;
  const int rows = l.tiled ? l.block_height : std::min(l.block_height, l.height - first_row);
  const std::uint32_t number =
      static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(l.blocks_across()) +
      static_cast<std::uint32_t>(column) +
      (l.bands_apart ? static_cast<std::uint32_t>(band * l.blocks_across() * l.blocks_down()) : 0);
  const std::size_t first_byte =
      l.bands_apart ? 0 : static_cast<std::size_t>(band * bits_of(l.sample) / 8);
  const std::size_t width = static_cast<std::size_t>(l.block_width);
  auto heights = std::make_shared<std::vector<float>>(width * static_cast<std::size_t>(rows));
  int failed = 0;
  if (TIFFGetStrileByteCountWithErr(tiff, number, &failed) == 0 && failed == 0) {
    const float none = rule.nodata ? std::numeric_limits<float>::quiet_NaN()
                                   : static_cast<float>(rule.offset * rule.metres_per_unit);
    std::fill(heights->begin(), heights->end(), none);
    return heights;
  }
  const std::uint64_t row_bits =
      std::uint64_t{width} * static_cast<std::uint64_t>(bits_of(l.sample) * l.stride());
  const std::size_t row_bytes = static_cast<std::size_t>((row_bits + 7) / 8);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(l.block_bytes));
  const tmsize_t wanted = static_cast<tmsize_t>(row_bytes * static_cast<std::size_t>(rows));
  const tmsize_t got =
      l.tiled ? TIFFReadEncodedTile(tiff, number, bytes.data(), static_cast<tmsize_t>(bytes.size()))
              : TIFFReadEncodedStrip(tiff, number, bytes.data(), wanted);
  if (failed != 0 || got < wanted) {
    refuse(handle.path(),
           fmt::format("the file is damaged: the {} at column {}, row {} cannot be read ({})",
                       l.tiled ? "tile" : "strip", column * l.block_width, first_row,
                       handle.complaint().empty() ? "it is too short" : handle.complaint()));
  }
  std::vector<std::uint8_t> scratch;
  for (std::size_t j = 0; j < static_cast<std::size_t>(rows); ++j) {
    if (undoes_predictor_) {
      undo_float_predictor(bytes.data() + j * row_bytes, width,
                           static_cast<std::size_t>(bits_of(l.sample) / 8), scratch);
    }
    samples_to_heights(rule, bytes.data() + j * row_bytes + first_byte,
                       static_cast<std::size_t>(l.stride()), width, heights->data() + j * width);
  }
  return heights;
}

constexpr std::uint64_t kLargeBlock = std::uint64_t{16} << 20;  // bytes

/// A level of detail: samples, and the mask that tells which of them count.
struct Level {
  std::unique_ptr<BlockReader> samples;
  std::unique_ptr<BlockReader> mask;
};

class GeoTiffRaster final : public Raster {
 public:
  GeoTiffRaster(const std::shared_ptr<const OpenFile>& file, const TiffPages& pages,
                GeoTiffInfo about)
      : Raster(std::move(about.info)), rule_(std::move(about.rule)), file_(BlockCache::new_file()) {
    add_level(file, pages, pages.main);
    for (const TiffPage& page : pages.overviews) add_level(file, pages, page);
  }
  ~GeoTiffRaster() override { BlockCache::shared().drop(file_); }

  std::vector<double> overview_factors() const override {
    std::vector<double> factors;
    for (std::size_t i = 1; i < levels_.size(); ++i) {
      factors.push_back(static_cast<double>(info_.width) / levels_[i].samples->layout().width);
    }
    return factors;
  }

  std::array<int, 2> overview_size(int overview) const override {
    const TiffLayout& layout = levels_.at(static_cast<std::size_t>(overview) + 1).samples->layout();
    return {layout.width, layout.height};
  }

  void read(const Window& window, float* heights) const override { read_level(0, window, heights); }

  void read_overview(int overview, const Window& window, float* heights) const override {
    read_level(static_cast<std::size_t>(overview) + 1, window, heights);
  }

 private:
  void add_level(const std::shared_ptr<const OpenFile>& file, const TiffPages& pages,
                 const TiffPage& page) {
    Level level;
    level.samples = std::make_unique<BlockReader>(file, page);
    for (const TiffPage& mask : pages.masks) {
      if (mask.layout.width != page.layout.width || mask.layout.height != page.layout.height ||
          mask.layout.bands != 1) {
        continue;
      }
      level.mask = std::make_unique<BlockReader>(file, mask);
    }
    levels_.push_back(std::move(level));
  }

  void read_level(std::size_t number, const Window& window, float* heights) const;
  void copy_blocks(const BlockReader& reader, int layer, const HeightRule& rule,
                   const Window& window, float* heights) const;

  HeightRule rule_;
  std::uint64_t file_ = 0;  // in the cache of blocks
  mutable std::mutex large_block_;
  std::vector<Level> levels_;
};

/// Reads a window block by block. `layer` is the number of the directory in the cache.
void GeoTiffRaster::copy_blocks(const BlockReader& reader, int layer, const HeightRule& rule,
                                const Window& window, float* heights) const {
  const TiffLayout& l = reader.layout();
  const int last_row = window.row + window.height - 1,
            last_column = window.column + window.width - 1;
  for (int row = window.row / l.block_height; row <= last_row / l.block_height; ++row) {
    for (int column = window.column / l.block_width; column <= last_column / l.block_width;
         ++column) {
      const BlockCache::Key key{file_, layer,
                                static_cast<std::uint64_t>(row) * l.blocks_across() + column};
      // Several threads must not decode the same large block, for all of them would hold it.
      std::unique_lock<std::mutex> alone(large_block_, std::defer_lock);
      if (l.block_bytes > kLargeBlock) alone.lock();
      BlockCache::Block block = BlockCache::shared().find(key);
      if (!block) {
        block = reader.block(column, row, rule);
        BlockCache::shared().put(key, block);
      }
      const int left = std::max(window.column, column * l.block_width);
      const int right = std::min(last_column, (column + 1) * l.block_width - 1);
      const int top = std::max(window.row, row * l.block_height);
      const int bottom = std::min(last_row, (row + 1) * l.block_height - 1);
      for (int j = top; j <= bottom; ++j) {
        const float* const from = block->data() +
                                  static_cast<std::size_t>(j - row * l.block_height) *
                                      static_cast<std::size_t>(l.block_width) +
                                  (left - column * l.block_width);
        std::copy_n(
            from, right - left + 1,
            heights +
                static_cast<std::size_t>(j - window.row) * static_cast<std::size_t>(window.width) +
                (left - window.column));
      }
    }
  }
}

void GeoTiffRaster::read_level(std::size_t number, const Window& window, float* heights) const {
  const Level& level = levels_.at(number);
  if (window.width <= 0 || window.height <= 0) return;
  const int layer = 2 * static_cast<int>(number);
  copy_blocks(*level.samples, layer, rule_, window, heights);
  if (!level.mask) return;
  const std::size_t count =
      static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
  std::vector<float> mask(count);
  HeightRule rule;
  rule.type = level.mask->layout().sample;
  copy_blocks(*level.mask, layer + 1, rule, window, mask.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (mask[i] == 0.0f) heights[i] = std::numeric_limits<float>::quiet_NaN();
  }
}

bool is_tiff(std::span<const std::uint8_t> head, const std::filesystem::path&) {
  if (head.size() < 8) return false;
  const bool little = head[0] == 'I' && head[1] == 'I' && head[3] == 0;
  const bool big = head[0] == 'M' && head[1] == 'M' && head[2] == 0;
  const int version = little ? head[2] : head[3];
  return (little || big) && (version == 42 || version == 43);
}

std::unique_ptr<Raster> open_geotiff(const std::filesystem::path& path,
                                     const OpenOptions& options) {
  return open_geotiff_for(path, {path, "GeoTIFF", false, {}}, options);
}

}  // namespace

const Format kGeoTiffFormat{"GeoTIFF", is_tiff, open_geotiff};

std::unique_ptr<Raster> open_geotiff_for(const std::filesystem::path& path,
                                         const ConvertedFile& original,
                                         const OpenOptions& options) {
  const auto file = std::make_shared<const OpenFile>(path, original.path);
  TiffHandle handle(file);
  const TiffPages pages = pages_of(handle, options.codes ? refusal_of_codes : refusal_of_heights);
  GeoTiffInfo about = geotiff_info(handle, pages, options);
  about.info.format = original.format;
  about.info.notes.insert(about.info.notes.begin(), original.notes.begin(), original.notes.end());
  if (original.is_depth) about.rule.metres_per_unit = -about.rule.metres_per_unit;
  return std::make_unique<GeoTiffRaster>(file, pages, std::move(about));
}

}  // namespace aerostat::elevation

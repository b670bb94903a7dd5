#include "elevation/asc_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

[[noreturn]] void refuse_value(const RasterInfo& info, std::size_t index, std::string_view word) {
  const auto width = static_cast<std::size_t>(info.width);
  if (word.empty()) {
    refuse(info.path, fmt::format("it has {} heights, and the header promises {} x {}; the file "
                                  "is cut short",
                                  index, info.width, info.height));
  }
  refuse(info.path,
         fmt::format("row {}, column {} has \"{}\"; a height is expected", index / width + 1,
                     index % width + 1, std::string(word.substr(0, 40))));
}

}  // namespace

void AscBody::read(Words& words, std::size_t first, std::size_t count, float* heights) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view word = words.next();
    double value = plain_number(word);
    if (std::isnan(value) && !is_void_word(word)) {
      const std::optional<double> number = number_of(word);
      if (!number) refuse_value(info_, first + i, word);
      value = *number;
    }
    if (is_no_height(value) || is_mark(value, mark_)) {
      has_mark_ |= value == mark_;
      heights[i] = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    all_whole_ &= value == std::floor(value);
    has_comma_ |= word.find(',') != std::string_view::npos;
    heights[i] = static_cast<float>(value * info_.metres_per_unit);
  }
}

AscRaster::AscRaster(RasterInfo info, std::shared_ptr<const ByteSource> bytes, double mark,
                     int band_rows, std::vector<std::uint64_t> begins)
    : Raster(std::move(info)),
      bytes_(std::move(bytes)),
      mark_(mark),
      band_rows_(band_rows),
      begins_(std::move(begins)),
      file_(BlockCache::new_file()) {}

AscRaster::~AscRaster() {
  BlockCache::shared().drop(file_);
}

BlockCache::Block AscRaster::band(int number) const {
  const BlockCache::Key key{file_, 0, static_cast<std::uint64_t>(number)};
  if (BlockCache::Block block = BlockCache::shared().find(key)) return block;
  const int first_row = number * band_rows_;
  const int rows = std::min(band_rows_, info_.height - first_row);
  const auto width = static_cast<std::size_t>(info_.width);
  std::vector<float> heights(width * static_cast<std::size_t>(rows));
  Words words(*bytes_, begins_[static_cast<std::size_t>(number)]);
  AscBody(info_, mark_)
      .read(words, width * static_cast<std::size_t>(first_row), heights.size(), heights.data());
  auto block = std::make_shared<const std::vector<float>>(std::move(heights));
  BlockCache::shared().put(key, block);
  return block;
}

void AscRaster::read(const Window& window, float* heights) const {
  const int end = window.row + window.height;
  for (int row = window.row; row < end;) {
    const int number = row / band_rows_;
    const BlockCache::Block block = band(number);
    for (; row < end && row / band_rows_ == number; ++row) {
      const std::size_t first = static_cast<std::size_t>(row - number * band_rows_) *
                                    static_cast<std::size_t>(info_.width) +
                                static_cast<std::size_t>(window.column);
      heights =
          std::copy_n(block->begin() + static_cast<std::ptrdiff_t>(first), window.width, heights);
    }
  }
}

}  // namespace aerostat::elevation

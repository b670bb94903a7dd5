// Pictures in GeoTIFF files, cloud optimised ones too.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "elevation/geotiff_info.hpp"
#include "elevation/picture.hpp"
#include "elevation/reading.hpp"
#include "elevation/tiff_tags.hpp"

namespace aerostat::elevation {
namespace {

using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Returns why a picture of this layout is not read, or an empty text.
std::string refusal_of_picture(const TiffLayout& layout) {
  if (layout.sample != TiffSample::uint8 && layout.sample != TiffSample::uint16) {
    return fmt::format("its samples are {}; a picture has unsigned ones of 8 or 16 bits a band",
                       name_of(layout.sample));
  }
  const bool is_jpeg = layout.compression == COMPRESSION_JPEG;
  switch (layout.photometric) {
    case PHOTOMETRIC_MINISBLACK:
      return "";
    case PHOTOMETRIC_RGB:
      if (layout.bands < 3) return "it is said to be in colours, and has less than three bands";
      return "";
    case PHOTOMETRIC_PALETTE:
      if (layout.sample != TiffSample::uint8) return "its palette is not one of 8 bits";
      return "";
    case PHOTOMETRIC_YCBCR:
      if (is_jpeg && layout.bands >= 3) return "";
      break;
    default:
      break;
  }
  return fmt::format(
      "its colours are of a kind that is not read (number {}); \"gdal_translate -co "
      "PHOTOMETRIC=RGB\" makes a file that can be read",
      layout.photometric);
}

/// The blocks of a directory. The last one that was decoded is kept, because a file may be a single
/// strip.
class Blocks {
 public:
  Blocks(const std::shared_ptr<const OpenFile>& file, const TiffPage& page)
      : layout_(page.layout), handle_(file, page.directory) {
    if (layout_.photometric == PHOTOMETRIC_YCBCR) {
      TIFFSetField(handle_.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    }
  }

  const TiffLayout& layout() const { return layout_; }
  std::size_t row_bytes() const {
    return (static_cast<std::size_t>(layout_.block_width) *
                static_cast<std::size_t>(bits_of(layout_.sample) * layout_.stride()) +
            7) /
           8;
  }

  /// Returns the samples of a block, or null if the file leaves it out. It may be called from any
  /// thread.
  Bytes block(int column, int row, int band) const {
    const std::lock_guard lock(mutex_);
    std::uint32_t number =
        static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(layout_.blocks_across()) +
        static_cast<std::uint32_t>(column);
    if (layout_.bands_apart) {
      number += static_cast<std::uint32_t>(band) *
                static_cast<std::uint32_t>(layout_.blocks_across() * layout_.blocks_down());
    }
    if (!last_ || number != last_number_) last_ = decode(number, row);
    last_number_ = number;
    return last_;
  }

 private:
  Bytes decode(std::uint32_t number, int row) const {
    TIFF* const tiff = handle_.get();
    int failed = 0;
    if (TIFFGetStrileByteCountWithErr(tiff, number, &failed) == 0 && failed == 0) return nullptr;
    const int rows =
        layout_.tiled ? layout_.block_height
                      : std::min(layout_.block_height, layout_.height - row * layout_.block_height);
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(layout_.block_bytes);
    const auto wanted = static_cast<tmsize_t>(row_bytes() * static_cast<std::size_t>(rows));
    const auto size = static_cast<tmsize_t>(bytes->size());
    const tmsize_t got = layout_.tiled ? TIFFReadEncodedTile(tiff, number, bytes->data(), size)
                                       : TIFFReadEncodedStrip(tiff, number, bytes->data(), wanted);
    if (failed != 0 || got < wanted) {
      refuse(handle_.path(),
             fmt::format("the file is damaged: its block {} cannot be read ({})", number,
                         handle_.complaint().empty() ? "it is too short" : handle_.complaint()));
    }
    return bytes;
  }

  TiffLayout layout_;
  TiffHandle handle_;
  mutable std::mutex mutex_;
  mutable std::uint32_t last_number_ = 0;
  mutable Bytes last_;
};

/// How samples become colours.
struct ColourRule {
  std::vector<float> albedo;                  // by the stored value
  std::vector<std::array<float, 3>> palette;  // by the stored value; empty: bands are colours
  int colours = 3;                            // bands that are colours: 1 or 3
  int opacity = 0;                            // the band that is the opacity; 0: none
  bool is_multiplied = false;                 // colours are multiplied by the opacity
  int most = 255;                             // the stored value of white
  std::optional<int> nodata;
};

ColourRule colour_rule(const TiffHandle& handle, const TiffLayout& layout) {
  TIFF* const tiff = handle.get();
  ColourRule rule;
  rule.most = layout.sample == TiffSample::uint16 ? 65535 : 255;
  for (int i = 0; i <= rule.most; ++i) {
    rule.albedo.push_back(albedo_of_srgb(static_cast<double>(i) / rule.most));
  }
  rule.opacity = layout.opacity;
  const int bands = layout.opacity > 0 ? layout.opacity : layout.bands;
  rule.colours = bands >= 3 && layout.photometric != PHOTOMETRIC_PALETTE ? 3 : 1;
  std::uint16_t count = 0;
  std::uint16_t* meanings = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &count, &meanings) != 0 && count > 0) {
    rule.is_multiplied = meanings[0] == EXTRASAMPLE_ASSOCALPHA;
  }
  std::array<std::uint16_t*, 3> map{};
  if (layout.photometric == PHOTOMETRIC_PALETTE &&
      TIFFGetField(tiff, TIFFTAG_COLORMAP, &map[0], &map[1], &map[2]) != 0) {
    for (int i = 0; i < 256; ++i) {
      std::array<float, 3> colour{};
      for (std::size_t k = 0; k < 3; ++k) colour[k] = albedo_of_srgb(map[k][i] / 65535.0);
      rule.palette.push_back(colour);
    }
  }
  if (const auto nodata = number_of(text_of(handle, kTagGdalNodata))) {
    if (*nodata >= 0.0 && *nodata <= rule.most) rule.nodata = static_cast<int>(*nodata);
  }
  return rule;
}

/// Returns the colour of a pixel, multiplied by its opacity, from its bands.
vec4 colour_of(const ColourRule& rule, const std::array<int, 4>& bands) {
  if (rule.nodata && bands[0] == *rule.nodata &&
      (rule.colours == 1 || (bands[1] == *rule.nodata && bands[2] == *rule.nodata))) {
    return vec4(0.0f);
  }
  const float opacity =
      rule.opacity > 0 ? static_cast<float>(bands[3]) / static_cast<float>(rule.most) : 1.0f;
  if (!rule.palette.empty()) {
    const std::array<float, 3>& c = rule.palette[static_cast<std::size_t>(bands[0])];
    return vec4(opacity * vec3(c[0], c[1], c[2]), opacity);
  }
  vec3 colour(0.0f);
  for (int k = 0; k < 3; ++k) {
    int value = bands[static_cast<std::size_t>(rule.colours == 3 ? k : 0)];
    if (rule.is_multiplied && bands[3] > 0) {
      value = static_cast<int>(
          std::min<std::int64_t>(rule.most, std::int64_t{value} * rule.most / bands[3]));
    }
    colour[k] = rule.albedo[static_cast<std::size_t>(value)];
  }
  return vec4(opacity * colour, opacity);
}

int sample_at(const std::uint8_t* samples, std::size_t number, bool is_word) {
  if (!is_word) return samples[number];
  std::uint16_t value = 0;
  std::memcpy(&value, samples + 2 * number, sizeof value);
  return value;
}

class TiffPicture final : public Picture {
 public:
  TiffPicture(RasterInfo info, const std::vector<std::array<int, 2>>& levels, ColourRule rule)
      : Picture(std::move(info), levels), rule_(std::move(rule)) {}

  void add_level(std::unique_ptr<Blocks> colours, std::unique_ptr<Blocks> mask) {
    colours_.push_back(std::move(colours));
    masks_.push_back(std::move(mask));
  }

  void read(int level, const Window& window, vec4* pixels) const override {
    const auto number = static_cast<std::size_t>(level);
    for_each_block(*colours_.at(number), window, [&](int column, int row, const Window& part) {
      copy_colours(*colours_[number], column, row, part, window, pixels);
    });
    if (!masks_[number]) return;
    for_each_block(*masks_[number], window, [&](int column, int row, const Window& part) {
      apply_mask(*masks_[number], column, row, part, window, pixels);
    });
  }

 private:
  /// Calls `use` for each block that a window touches, with the part of the level that both share.
  template <typename Use>
  static void for_each_block(const Blocks& blocks, const Window& window, const Use& use) {
    const TiffLayout& l = blocks.layout();
    const int end_row = window.row + window.height, end_column = window.column + window.width;
    for (int row = window.row / l.block_height; row * l.block_height < end_row; ++row) {
      for (int column = window.column / l.block_width; column * l.block_width < end_column;
           ++column) {
        const int left = std::max(window.column, column * l.block_width);
        const int top = std::max(window.row, row * l.block_height);
        use(column, row,
            Window{left, top, std::min(end_column, (column + 1) * l.block_width) - left,
                   std::min(end_row, (row + 1) * l.block_height) - top});
      }
    }
  }

  static vec4* target(const Window& window, const Window& part, int j, vec4* pixels) {
    return pixels +
           static_cast<std::size_t>(part.row + j - window.row) *
               static_cast<std::size_t>(window.width) +
           (part.column - window.column);
  }

  void copy_colours(const Blocks& blocks, int column, int row, const Window& part,
                    const Window& window, vec4* pixels) const {
    const TiffLayout& l = blocks.layout();
    const bool is_word = l.sample == TiffSample::uint16;
    const std::array<int, 4> numbers{0, 1, 2, rule_.opacity};
    std::array<Bytes, 4> bands;
    for (std::size_t k = 0; k < 4; ++k) {
      const bool is_used = k == 3 ? rule_.opacity > 0 : static_cast<int>(k) < rule_.colours;
      if (is_used) bands[k] = blocks.block(column, row, l.bands_apart ? numbers[k] : 0);
    }
    for (int j = 0; j < part.height; ++j) {
      vec4* to = target(window, part, j, pixels);
      const std::size_t line =
          static_cast<std::size_t>(part.row + j - row * l.block_height) * blocks.row_bytes();
      for (int i = 0; i < part.width; ++i) {
        const auto at = static_cast<std::size_t>(part.column + i - column * l.block_width) *
                        static_cast<std::size_t>(l.stride());
        std::array<int, 4> values{};
        for (std::size_t k = 0; k < 4; ++k) {
          if (!bands[k]) continue;
          const std::size_t band = l.bands_apart ? 0 : static_cast<std::size_t>(numbers[k]);
          values[k] = sample_at(bands[k]->data() + line, at + band, is_word);
        }
        to[i] = bands[0] ? colour_of(rule_, values) : vec4(0.0f);
      }
    }
  }

  static void apply_mask(const Blocks& blocks, int column, int row, const Window& part,
                         const Window& window, vec4* pixels) {
    const TiffLayout& l = blocks.layout();
    const Bytes mask = blocks.block(column, row, 0);
    for (int j = 0; j < part.height; ++j) {
      vec4* to = target(window, part, j, pixels);
      const std::size_t line =
          static_cast<std::size_t>(part.row + j - row * l.block_height) * blocks.row_bytes();
      for (int i = 0; i < part.width; ++i) {
        const auto at = static_cast<std::size_t>(part.column + i - column * l.block_width);
        bool is_seen = false;
        if (mask && l.sample == TiffSample::bit) {
          is_seen = ((*mask)[line + at / 8] >> (7 - at % 8) & 1) != 0;
        } else if (mask) {
          is_seen = (*mask)[line + at] != 0;
        }
        if (!is_seen) to[i] = vec4(0.0f);
      }
    }
  }

  ColourRule rule_;
  std::vector<std::unique_ptr<Blocks>> colours_, masks_;
};

std::unique_ptr<Blocks> mask_of(const std::shared_ptr<const OpenFile>& file, const TiffPages& pages,
                                const TiffLayout& layout) {
  for (const TiffPage& mask : pages.masks) {
    const TiffLayout& m = mask.layout;
    const bool is_read = m.sample == TiffSample::bit || m.sample == TiffSample::uint8;
    if (m.width != layout.width || m.height != layout.height || m.bands != 1 || !is_read) continue;
    return std::make_unique<Blocks>(file, mask);
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<Picture> open_tiff_picture(const std::filesystem::path& path,
                                           const PictureOptions& options) {
  const auto file = std::make_shared<const OpenFile>(path, path);
  TiffHandle handle(file);
  TiffPages pages = pages_of(handle, refusal_of_picture);
  const TiffLayout& main = pages.main.layout;
  RasterInfo info;
  info.path = path;
  info.format = "GeoTIFF";
  info.sample_type = name_of(main.sample);
  info.width = main.width;
  info.height = main.height;
  double vertical_unit = 0.0;
  OpenOptions said;
  said.crs = options.crs;
  if (!options.corners) set_place(handle, said, info, vertical_unit);
  set_picture_place(info, options);
  ColourRule rule = colour_rule(handle, main);
  std::vector<TiffPage> all{pages.main};
  all.insert(all.end(), pages.overviews.begin(), pages.overviews.end());
  std::vector<std::array<int, 2>> sizes;
  for (const TiffPage& page : all) sizes.push_back({page.layout.width, page.layout.height});
  auto picture = std::make_unique<TiffPicture>(std::move(info), sizes, std::move(rule));
  for (const TiffPage& page : all) {
    picture->add_level(std::make_unique<Blocks>(file, page), mask_of(file, pages, page.layout));
  }
  return picture;
}

}  // namespace aerostat::elevation

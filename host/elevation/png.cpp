#include "elevation/png.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "elevation/bytes.hpp"
#include "elevation/images.hpp"
#include "elevation/reading.hpp"
#include "elevation/sample_raster.hpp"
#include "elevation/web_tile.hpp"
#include "image/decode.hpp"

namespace aerostat::elevation {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;
constexpr std::array<std::uint8_t, 8> kMark{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

bool is_png(Bytes head, const std::filesystem::path&) {
  return head.size() >= kMark.size() && std::equal(kMark.begin(), kMark.end(), head.begin());
}

std::unique_ptr<Raster> open_png(const std::filesystem::path& path, const OpenOptions& options) {
  return read_png(read_whole(path, kMostBytes), side_files_of(path), path, options);
}

bool is_lossy_picture(Bytes head, const std::filesystem::path&) {
  const auto starts = [&](std::size_t at, std::string_view mark) {
    return head.size() >= at + mark.size() &&
           std::equal(mark.begin(), mark.end(), head.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  };
  return starts(0, "\xff\xd8\xff") || (starts(0, "RIFF") && starts(8, "WEBP"));
}

std::unique_ptr<Raster> refuse_lossy_picture(const std::filesystem::path& path,
                                             const OpenOptions&) {
  refuse(path,
         "it is a JPEG or WebP picture, whose compression damages heights; a PNG is expected");
}

std::uint32_t number_at(Bytes bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 |
         std::uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
}

/// The header of a PNG file (its chunk IHDR).
struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bits = 0, colour = 0;
};

/// Checks the frame of the file, which stb does not: all pieces are there and have the right sums.
PngHeader check_pieces(Bytes bytes, const std::filesystem::path& path) {
  PngHeader header;
  std::size_t at = kMark.size();
  for (bool is_first = true;; is_first = false) {
    if (bytes.size() < at || bytes.size() - at < 12) refuse(path, "the PNG file is cut short");
    const std::size_t length = number_at(bytes, at);
    if (length > bytes.size() - at - 12) refuse(path, "the PNG file is cut short");
    const Bytes piece = bytes.subspan(at + 4, length + 4);
    const std::string_view name(reinterpret_cast<const char*>(piece.data()), 4);
    const auto sum = crc32(0, piece.data(), static_cast<uInt>(piece.size()));
    if (sum != number_at(bytes, at + 8 + length)) {
      refuse(path, fmt::format("the PNG file is damaged: a checksum at byte {} is wrong", at));
    }
    if (is_first && (name != "IHDR" || length != 13)) refuse(path, "the PNG file has no header");
    if (is_first) {
      header = {number_at(piece, 4), number_at(piece, 8), piece[12], piece[13]};
    }
    if (name == "IEND") return header;
    at += length + 12;
  }
}

/// The decoded samples, row by row, of 8 or 16 bits.
struct Pixels {
  int channels = 0;
  std::span<const std::uint8_t> bytes;
  std::span<const std::uint16_t> words;
  std::unique_ptr<std::uint8_t, image::FreeMemory> bytes_owner;
  std::unique_ptr<std::uint16_t, image::FreeMemory> words_owner;
};

Pixels decode(Bytes bytes, const PngHeader& header, const std::filesystem::path& path) {
  const std::uint64_t samples = std::uint64_t{header.width} * header.height;
  // Deflate makes at most 1032 bytes of one, and a byte holds at most 8 pixels.
  if (samples > (bytes.size() + 1) * 1032 * 8) {
    refuse(path, fmt::format("the PNG file has {} bytes, too few for {} x {} pixels", bytes.size(),
                             header.width, header.height));
  }
  Pixels pixels;
  if (header.bits == 16) {
    auto image = image::decode_16_bits(bytes, "PNG", path);
    pixels.channels = image.channels;
    pixels.words_owner = std::move(image.samples);
  } else {
    auto image = image::decode_8_bits(bytes, image::Channels::own, "PNG", path);
    pixels.channels = image.channels;
    pixels.bytes_owner = std::move(image.samples);
  }
  const std::size_t values =
      static_cast<std::size_t>(samples) * static_cast<std::size_t>(pixels.channels);
  if (pixels.words_owner) pixels.words = {pixels.words_owner.get(), values};
  if (pixels.bytes_owner) pixels.bytes = {pixels.bytes_owner.get(), values};
  return pixels;
}

bool is_grey(const Pixels& pixels) {
  if (pixels.channels < 3) return true;
  const auto step = static_cast<std::size_t>(pixels.channels);
  for (std::size_t i = 0; i + 2 < pixels.bytes.size(); i += step) {
    if (pixels.bytes[i] != pixels.bytes[i + 1] || pixels.bytes[i] != pixels.bytes[i + 2]) {
      return false;
    }
  }
  for (std::size_t i = 0; i + 2 < pixels.words.size(); i += step) {
    if (pixels.words[i] != pixels.words[i + 1] || pixels.words[i] != pixels.words[i + 2]) {
      return false;
    }
  }
  return true;
}

/// Takes the first channel, as stored. Pixels that are fully transparent become `mark`.
template <typename T>
std::vector<std::uint8_t> first_channel(std::span<const T> values, int channels, T mark) {
  const auto step = static_cast<std::size_t>(channels);
  const bool has_opacity = channels == 2 || channels == 4;
  std::vector<std::uint8_t> bytes(values.size() / step * sizeof(T));
  for (std::size_t i = 0; i < values.size() / step; ++i) {
    const bool is_void = has_opacity && values[i * step + step - 1] == 0;
    const T value = is_void ? mark : values[i * step];
    std::memcpy(bytes.data() + i * sizeof(T), &value, sizeof(T));
  }
  return bytes;
}

/// Returns a value that no opaque pixel has, or 0.
template <typename T>
T free_value(std::span<const T> values, int channels) {
  std::vector<bool> taken(std::size_t{std::numeric_limits<T>::max()} + 1);
  const auto step = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i + step <= values.size(); i += step) {
    if (values[i + step - 1] != 0) taken[values[i]] = true;
  }
  const auto found = std::find(taken.begin(), taken.end(), false);
  return found == taken.end() ? T{0} : static_cast<T>(found - taken.begin());
}

template <typename T>
std::unique_ptr<Raster> grey_raster(RasterInfo info, std::span<const T> values, int channels,
                                    const HeightScale& scale, const OpenOptions& options) {
  SampleLayout layout;
  layout.type = sizeof(T) == 2 ? SampleType::uint16 : SampleType::uint8;
  layout.big_endian = std::endian::native == std::endian::big;
  layout.row_stride = sizeof(T) * static_cast<std::uint64_t>(info.width);
  layout.scale = scale.scale;
  layout.offset_m = scale.offset_m;
  if (options.nodata) layout.voids.push_back(*options.nodata);
  T mark{0};
  if (channels == 2 || channels == 4) {
    mark = free_value(values, channels);
    layout.voids.push_back(mark);
  }
  return std::make_unique<SampleRaster>(
      std::move(info), memory_bytes(first_channel(values, channels, mark)), std::move(layout));
}

std::unique_ptr<Raster> open_grey(RasterInfo info, const Pixels& pixels, const SideFiles& beside,
                                  const OpenOptions& options) {
  const bool is_word = pixels.bytes.empty();
  info.format = is_word ? "grey PNG of 16 bits" : "grey PNG of 8 bits";
  info.sample_type = is_word ? "uint16" : "uint8";
  const HeightScale scale = height_scale_of(info, options, 0.0, is_word ? 65535.0 : 255.0, false);
  set_image_place(info, options, beside);
  const bool is_coarse = std::all_of(pixels.words.begin(), pixels.words.end(),
                                     [](std::uint16_t word) { return word % 257 == 0; });
  if (is_coarse) {
    info.notes.push_back(fmt::format(
        "The image holds 256 different values at most, so that its heights come in steps of {:.3g} "
        "m.",
        scale.scale * (is_word ? 257.0 : 1.0)));
  }
  if (is_word) return grey_raster(std::move(info), pixels.words, pixels.channels, scale, options);
  return grey_raster(std::move(info), pixels.bytes, pixels.channels, scale, options);
}

TileEncoding choose_encoding(RasterInfo& info, const Pixels& pixels, const OpenOptions& options) {
  if (pixels.bytes.empty()) {
    refuse(info.path, "it is a colour PNG of 16 bits; heights in colours have 8 bits a channel");
  }
  std::optional<TileEncoding> encoding = encoding_of(options.encoding);
  if (!encoding && !options.encoding.empty()) {
    refuse(info.path, fmt::format("the encoding \"{}\" is unknown; \"terrarium\" or "
                                  "\"terrain-rgb\" is expected",
                                  options.encoding));
  }
  if (!encoding) {
    encoding = guess_encoding(pixels.bytes, pixels.channels, info.width);
    if (!encoding) {
      refuse(info.path,
             "its colours are no heights in a known encoding; /terrain/encoding names one, "
             "\"terrarium\" or \"terrain-rgb\", and a grey image may hold heights as it is");
    }
    info.notes.push_back(fmt::format(
        "The colours were read as heights in the encoding {}, because this gives heights that the "
        "Earth has.",
        encoding->name));
  }
  if (options.image_heights_m) {
    const HeightScale scale = height_scale_of(info, options, 0.0, 16777215.0, false);
    encoding->base_m = scale.offset_m;
    encoding->step_m = scale.scale;
  }
  return *encoding;
}

std::unique_ptr<Raster> tile_raster(RasterInfo info, const Pixels& pixels, const SideFiles& beside,
                                    const OpenOptions& options) {
  info.format = "PNG with heights in colours";
  info.sample_type = "float32";
  const TileEncoding encoding = choose_encoding(info, pixels, options);
  const std::optional<TileNumber> tile = tile_number_of(info.path);
  const bool is_tile = info.width == info.height && (info.width == 256 || info.width == 512);
  if (tile && is_tile && !beside.world && !options.cell_m) {
    info.georeference = place_of_tile(*tile, info.width);
    if (!options.crs.empty()) info.georeference->crs = options.crs;
    info.notes.push_back(
        fmt::format("The place is that of the web map's tile {}/{}/{}, which the name gives.",
                    tile->z, tile->x, tile->y));
  } else if (!beside.world && !options.cell_m) {
    refuse(info.path,
           "its place is not known; a name of the form ZOOM/X/Y.png or ZOOM_X_Y.png for 256 or 512 "
           "pixels a side gives it, and /terrain/cell_m uses the image without a place");
  } else {
    set_image_place(info, options, beside);
  }
  return std::make_unique<MemoryRaster>(std::move(info),
                                        tile_heights(pixels.bytes, pixels.channels, encoding));
}

}  // namespace

const Format kPngFormat{"PNG", is_png, open_png};
const Format kLossyPictureFormat{"JPEG or WebP", is_lossy_picture, refuse_lossy_picture};

std::unique_ptr<Raster> read_png(Bytes bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options) {
  if (!is_png(bytes, path)) refuse(path, "the mark of a PNG file was expected");
  const PngHeader header = check_pieces(bytes, path);
  require_size(path, header.width, header.height, false);
  RasterInfo info;
  info.path = path;
  info.width = static_cast<int>(header.width);
  info.height = static_cast<int>(header.height);
  const Pixels pixels = decode(bytes, header, path);
  if (options.encoding.empty() && is_grey(pixels)) {
    return open_grey(std::move(info), pixels, beside, options);
  }
  if (pixels.channels < 3) {
    refuse(path, fmt::format("it is a grey PNG; a colour image is expected for the encoding {}",
                             options.encoding));
  }
  return tile_raster(std::move(info), pixels, beside, options);
}

}  // namespace aerostat::elevation

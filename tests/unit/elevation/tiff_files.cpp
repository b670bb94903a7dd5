#include "tiff_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include <tiffio.h>

namespace aerostat::elevation {
namespace {

void set_numbers(TIFF* tiff, std::uint32_t tag, const std::vector<double>& values) {
  if (values.empty()) return;
  TIFFSetField(tiff, tag, static_cast<std::uint32_t>(values.size()), values.data());
}

void set_text(TIFF* tiff, std::uint32_t tag, const std::string& text) {
  if (!text.empty()) TIFFSetField(tiff, tag, text.c_str());
}

/// Tells libtiff the types of the tags that it does not know.
void declare_tags(TIFF* tiff) {
  static char name[] = "of GeoTIFF";
  static const TIFFFieldInfo kFields[] = {{33550, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name},
                                          {33922, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name},
                                          {34264, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name},
                                          {34735, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, name},
                                          {34736, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name},
                                          {34737, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name},
                                          {42112, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name},
                                          {42113, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name}};
  TIFFMergeFieldInfo(tiff, kFields, 8);
}

void set_tags(TIFF* tiff, const TiffPageSpec& page) {
  declare_tags(tiff);
  const std::vector<std::pair<std::uint32_t, int>> shorts = {
      {TIFFTAG_BITSPERSAMPLE, page.bits},      {TIFFTAG_SAMPLEFORMAT, page.format},
      {TIFFTAG_SAMPLESPERPIXEL, page.bands},   {TIFFTAG_PLANARCONFIG, page.bands_apart ? 2 : 1},
      {TIFFTAG_PHOTOMETRIC, page.photometric}, {TIFFTAG_COMPRESSION, page.compression}};
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, page.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, page.height);
  TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, page.subfile);
  for (const auto& [tag, value] : shorts) TIFFSetField(tiff, tag, value);
  if (page.predictor != 1) TIFFSetField(tiff, TIFFTAG_PREDICTOR, page.predictor);
  if (page.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, page.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, page.tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, page.rows_per_strip);
  }
  if (page.last_is_opacity) {
    std::vector<std::uint16_t> meanings(static_cast<std::size_t>(page.bands - 1));
    meanings.back() = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, page.bands - 1, meanings.data());
  }
  if (page.photometric == PHOTOMETRIC_PALETTE) {
    std::vector<std::uint16_t> map(256);
    TIFFSetField(tiff, TIFFTAG_COLORMAP, map.data(), map.data(), map.data());
  }
  set_numbers(tiff, 33550, page.pixel_scale);
  set_numbers(tiff, 33922, page.tiepoints);
  set_numbers(tiff, 34264, page.transformation);
  set_numbers(tiff, 34736, page.geo_doubles);
  set_text(tiff, 34737, page.geo_texts);
  set_text(tiff, 42112, page.metadata);
  set_text(tiff, 42113, page.nodata);
  if (!page.geo_keys.empty()) {
    std::vector<std::uint16_t> keys{1, 1, 0, static_cast<std::uint16_t>(page.geo_keys.size() / 4)};
    keys.insert(keys.end(), page.geo_keys.begin(), page.geo_keys.end());
    TIFFSetField(tiff, 34735, static_cast<std::uint32_t>(keys.size()), keys.data());
  }
  if (page.subfiles > 0) {
    const std::vector<toff_t> offsets(static_cast<std::size_t>(page.subfiles));
    TIFFSetField(tiff, TIFFTAG_SUBIFD, page.subfiles, offsets.data());
  }
}

/// Puts a sample into a block. Masks have samples of one bit.
void put_sample(const TiffPageSpec& page, double value, std::vector<std::uint8_t>& block,
                std::size_t row_bytes, int i, int j) {
  std::uint8_t* const row = block.data() + static_cast<std::size_t>(j) * row_bytes;
  if (page.bits == 1) {
    if (value != 0.0) row[i / 8] = static_cast<std::uint8_t>(row[i / 8] | 0x80 >> i % 8);
    return;
  }
  const std::vector<std::uint8_t> bytes = sample_bytes(value, page.bits, page.format);
  std::copy(bytes.begin(), bytes.end(), row + static_cast<std::size_t>(i) * bytes.size());
}

void write_blocks(TIFF* tiff, const TiffPageSpec& page) {
  const int side_x = page.tile > 0 ? page.tile : page.width;
  const int side_y = page.tile > 0 ? page.tile : page.rows_per_strip;
  const int across = (page.width + side_x - 1) / side_x, down = (page.height + side_y - 1) / side_y;
  const int stride = page.bands_apart ? 1 : page.bands;
  const std::size_t row_bytes = (static_cast<std::size_t>(side_x * stride * page.bits) + 7) / 8;
  for (int plane = 0; plane < (page.bands_apart ? page.bands : 1); ++plane) {
    for (int block = 0; block < std::min(across * down, page.first_missing_block); ++block) {
      const int first_x = block % across * side_x, first_y = block / across * side_y;
      const int rows = page.tile > 0 ? side_y : std::min(side_y, page.height - first_y);
      std::vector<std::uint8_t> bytes(row_bytes * static_cast<std::size_t>(rows));
      for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < side_x; ++i) {
          // What lies beyond the image must not be seen.
          const int x = first_x + i, y = first_y + j;
          const bool seen = x < page.width && y < page.height;
          for (int band = 0; band < stride; ++band) {
            const auto& value = plane == 0 && band == 0 ? page.value : page.other;
            put_sample(page, seen ? value(x, y) : 99.0, bytes, row_bytes, i * stride + band, j);
          }
        }
      }
      const auto number = static_cast<std::uint32_t>(plane * across * down + block);
      const auto size = static_cast<tmsize_t>(bytes.size());
      const tmsize_t done = page.tile > 0 ? TIFFWriteEncodedTile(tiff, number, bytes.data(), size)
                                          : TIFFWriteEncodedStrip(tiff, number, bytes.data(), size);
      if (done < 0) throw std::runtime_error("a block cannot be written");
    }
  }
}

}  // namespace

std::vector<std::uint8_t> sample_bytes(double value, int bits, int format) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(bits / 8));
  const auto store = [&bytes](auto sample) {
    std::memcpy(bytes.data(), &sample, std::min(bytes.size(), sizeof sample));
  };
  if (format == 3 && bits == 64) {
    store(value);
  } else if (format == 3 && bits == 32) {
    store(static_cast<float>(value));
  } else if (format == 3) {
    // Half floats have 5 bits of exponent, those of 24 bits have 7.
    const int digits = bits == 16 ? 10 : 16, bias = bits == 16 ? 15 : 63;
    int exponent = 0;
    const double fraction = std::frexp(std::abs(value), &exponent);
    std::uint32_t pattern = 0;
    if (std::isnan(value)) {
      pattern = ((2u * static_cast<unsigned>(bias) + 1u) << digits) | 1u;
    } else if (value != 0.0) {
      pattern = static_cast<std::uint32_t>((exponent - 1 + bias) << digits) |
                static_cast<std::uint32_t>(std::ldexp(2.0 * fraction - 1.0, digits));
    }
    store(pattern | (value < 0.0 ? 1u << (bits - 1) : 0u));
  } else if (format == 1) {
    store(static_cast<std::uint64_t>(value));
  } else {
    store(static_cast<std::int64_t>(value));
  }
  return bytes;
}

void write_tiff(const std::filesystem::path& path, const std::vector<TiffPageSpec>& pages,
                const char* mode) {
  TIFFSetWarningHandler(nullptr);  // the old code of Deflate is written on purpose
  TIFF* const tiff = TIFFOpen(path.c_str(), mode);
  if (tiff == nullptr) throw std::runtime_error("the file cannot be written");
  for (const TiffPageSpec& page : pages) {
    set_tags(tiff, page);
    write_blocks(tiff, page);
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
}

TiffPageSpec page_at(int epsg, double x, double y, double cell) {
  TiffPageSpec page;
  const auto code = static_cast<std::uint16_t>(epsg);
  const bool is_geographic = epsg >= 4000 && epsg < 5000;
  const std::uint16_t type = is_geographic ? 2 : 1, key = is_geographic ? 2048 : 3072;
  page.geo_keys = {1024, 0, 1, type, 1025, 0, 1, 1, key, 0, 1, code};
  page.pixel_scale = {cell, cell, 0.0};
  page.tiepoints = {0.0, 0.0, 0.0, x, y, 0.0};
  return page;
}

}  // namespace aerostat::elevation

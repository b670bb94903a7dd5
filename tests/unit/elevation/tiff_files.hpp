#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Small TIFF files for tests, written by libtiff.
namespace aerostat::elevation {

/// One directory of a file.
struct TiffPageSpec {
  int width = 37, height = 29;
  int bits = 32;
  int format = 3;  // SAMPLEFORMAT_: 1 unsigned, 2 signed, 3 floating point, 5 and 6 complex
  int bands = 1;
  bool last_is_opacity = false;
  bool bands_apart = false;
  int tile = 0;            // side of the tiles; 0: strips
  int rows_per_strip = 8;  // of strips
  int compression = 1;
  int predictor = 1;
  int photometric = 1;  // MINISBLACK
  unsigned subfile = 0;
  /// The value of a sample in column i and row j.
  std::function<double(int i, int j)> value = [](int i, int j) { return 3.0 * i + 2.0 * j; };
  /// The value of the samples of all other bands.
  std::function<double(int i, int j)> other = [](int, int) { return 99.0; };
  /// Blocks from this number on are left out.
  int first_missing_block = 1 << 30;
  // Tags of GeoTIFF and GDAL; those that are empty are not written.
  std::vector<double> pixel_scale, tiepoints, transformation, geo_doubles;
  std::vector<std::uint16_t> geo_keys;  // without the header of four numbers
  std::string geo_texts, metadata, nodata;
  int subfiles = 0;  // how many of the pages that follow are its overviews
};

/// Writes a file. `mode` is that of TIFFOpen: "w" with "b" for big-endian and "8" for BigTIFF.
void write_tiff(const std::filesystem::path& path, const std::vector<TiffPageSpec>& pages,
                const char* mode = "w");

/// Returns a page that lies in a system of EPSG, with the corner of its first sample at (x, y).
TiffPageSpec page_at(int epsg, double x, double y, double cell);

/// Returns the bytes of a sample as they are stored.
std::vector<std::uint8_t> sample_bytes(double value, int bits, int format);

}  // namespace aerostat::elevation

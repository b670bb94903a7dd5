// The writer of GeoTIFF files, by OGC 19-008 (GeoTIFF 1.1).
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <tiffio.h>

#include "core/error.hpp"
#include "elevation/geokeys.hpp"
#include "elevation/tiff_tags.hpp"
#include "geo/transform.hpp"
#include "map/own_grid.hpp"

namespace aerostat::map {
namespace {

constexpr std::uint32_t kRowsOfStrip = 64;

/// A file in memory that libtiff writes to.
struct MemoryFile {
  std::vector<std::uint8_t> bytes;
  std::size_t position = 0;

  static MemoryFile& of(thandle_t handle) { return *static_cast<MemoryFile*>(handle); }

  static tmsize_t read(thandle_t handle, void* data, tmsize_t count) {
    MemoryFile& file = of(handle);
    const std::size_t left = file.bytes.size() - std::min(file.position, file.bytes.size());
    const std::size_t taken = std::min(left, static_cast<std::size_t>(count));
    std::memcpy(data, file.bytes.data() + file.position, taken);
    file.position += taken;
    return static_cast<tmsize_t>(taken);
  }

  static tmsize_t write(thandle_t handle, void* data, tmsize_t count) {
    MemoryFile& file = of(handle);
    const auto size = static_cast<std::size_t>(count);
    file.bytes.resize(std::max(file.bytes.size(), file.position + size));
    std::memcpy(file.bytes.data() + file.position, data, size);
    file.position += size;
    return count;
  }

  static toff_t seek(thandle_t handle, toff_t offset, int whence) {
    MemoryFile& file = of(handle);
    const std::size_t start = whence == SEEK_SET   ? 0
                              : whence == SEEK_CUR ? file.position
                                                   : file.bytes.size();
    file.position = start + offset;
    return file.position;
  }

  static toff_t size(thandle_t handle) { return of(handle).bytes.size(); }
  static int close(thandle_t) { return 0; }
};

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

void require(bool done) {
  if (!done) throw Error(ErrorKind::internal, "the TIFF encoder failed");
}

/// Makes libtiff know the tags of GeoTIFF.
void declare_tags(TIFF* tiff) {
  static const TIFFFieldInfo kFields[] = {
      {elevation::kTagPixelScale, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1,
       const_cast<char*>("ModelPixelScale")},
      {elevation::kTagTiepoints, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1,
       const_cast<char*>("ModelTiepoint")},
      {elevation::kTagTransformation, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1,
       const_cast<char*>("ModelTransformation")},
      {elevation::kTagGeoKeys, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1,
       const_cast<char*>("GeoKeyDirectory")},
      {elevation::kTagGeoTexts, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0,
       const_cast<char*>("GeoAsciiParams")}};
  require(TIFFMergeFieldInfo(tiff, kFields, std::size(kFields)) == 0);
}

void set_doubles(TIFF* tiff, std::uint32_t tag, const std::vector<double>& numbers) {
  require(TIFFSetField(tiff, tag, static_cast<int>(numbers.size()), numbers.data()) == 1);
}

/// Writes where the pixels lie. Tags count from the corner of the first pixel.
void set_grid(TIFF* tiff, const elevation::Georeference& place) {
  const dvec2 a = place.per_column, b = place.per_row;
  const dvec2 corner = place.origin - 0.5 * (a + b);
  if (a.y == 0.0 && b.x == 0.0 && a.x > 0.0 && b.y < 0.0) {
    set_doubles(tiff, elevation::kTagPixelScale, {a.x, -b.y, 0.0});
    set_doubles(tiff, elevation::kTagTiepoints, {0.0, 0.0, 0.0, corner.x, corner.y, 0.0});
    return;
  }
  set_doubles(
      tiff, elevation::kTagTransformation,
      {a.x, b.x, 0.0, corner.x, a.y, b.y, 0.0, corner.y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
}

/// The keys of a coordinate reference system, in ascending order.
class KeyList {
 public:
  void add(std::uint16_t key, int value) { entries_.push_back({key, 0, 1, value}); }

  void add(std::uint16_t key, const std::string& text) {
    entries_.push_back({key, static_cast<int>(elevation::kTagGeoTexts),
                        static_cast<int>(text.size()) + 1, static_cast<int>(texts_.size())});
    texts_ += text + "|";
  }

  void write_to(TIFF* tiff) const {
    // The header gives the version of the keys, 1.1.0, and their number.
    std::vector<std::uint16_t> directory;
    for (const int number : {1, 1, 0, static_cast<int>(entries_.size())}) {
      directory.push_back(static_cast<std::uint16_t>(number));
    }
    for (const Entry& entry : entries_) {
      for (const int number : entry) directory.push_back(static_cast<std::uint16_t>(number));
    }
    require(TIFFSetField(tiff, elevation::kTagGeoKeys, static_cast<int>(directory.size()),
                         directory.data()) == 1);
    if (texts_.empty()) return;
    require(TIFFSetField(tiff, elevation::kTagGeoTexts, texts_.c_str()) == 1);
  }

 private:
  /// A key, the tag that holds its value or 0, the number of values, and the value or its place.
  using Entry = std::array<int, 4>;
  std::vector<Entry> entries_;
  std::string texts_;
};

void set_crs(TIFF* tiff, const std::string& crs) {
  if (crs.empty()) return;
  constexpr int kProjectedModel = 1, kGeographicModel = 2, kPixelIsArea = 1;
  constexpr const char* kEsriMark = "ESRI PE String = ";  // by it, readers tell WKT from a name
  const bool geographic = geo::crs_info(crs).geographic;
  const int code = geo::epsg_code(crs);
  KeyList keys;
  keys.add(elevation::kModelType, geographic ? kGeographicModel : kProjectedModel);
  keys.add(elevation::kRasterType, kPixelIsArea);
  const auto type = geographic ? elevation::kGeographicType : elevation::kProjectedType;
  keys.add(type, code > 0 && code < elevation::kUserDefined ? code : elevation::kUserDefined);
  if (code <= 0 || code >= elevation::kUserDefined) {
    keys.add(geographic ? elevation::kGeogCitation : elevation::kProjectedCitation,
             kEsriMark + geo::esri_wkt(crs));
  }
  keys.write_to(tiff);
}

void set_layout(TIFF* tiff, const MapPixels& pixels) {
  const auto set = [tiff](std::uint32_t tag, auto value) {
    require(TIFFSetField(tiff, tag, value) == 1);
  };
  set(TIFFTAG_IMAGEWIDTH, pixels.width);
  set(TIFFTAG_IMAGELENGTH, pixels.height);
  set(TIFFTAG_SAMPLESPERPIXEL, 4);
  set(TIFFTAG_BITSPERSAMPLE, 8);
  set(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
  set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  set(TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  set(TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  set(TIFFTAG_ROWSPERSTRIP, kRowsOfStrip);
  const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
  require(TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha) == 1);
}

}  // namespace

std::vector<std::uint8_t> encode_geotiff(const MapPixels& pixels,
                                         const elevation::Georeference& place) {
  MemoryFile file;
  std::unique_ptr<TIFF, CloseTiff> tiff(
      TIFFClientOpen("map", "w", &file, MemoryFile::read, MemoryFile::write, MemoryFile::seek,
                     MemoryFile::close, MemoryFile::size, nullptr, nullptr));
  require(tiff != nullptr);
  declare_tags(tiff.get());
  set_layout(tiff.get(), pixels);
  set_grid(tiff.get(), place);
  set_crs(tiff.get(), place.crs);
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(pixels.width);
  std::vector<std::uint8_t> row(row_bytes);
  for (int y = 0; y < pixels.height; ++y) {
    std::memcpy(row.data(), &pixels.rgba[static_cast<std::size_t>(y) * row_bytes], row_bytes);
    require(TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(y)) == 1);
  }
  require(TIFFFlush(tiff.get()) == 1);
  tiff.reset();
  return std::move(file.bytes);
}

}  // namespace aerostat::map

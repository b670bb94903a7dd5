#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "elevation/format.hpp"

/// Heights in GeoTIFF files, cloud optimised ones too.
namespace aerostat::elevation {

extern const Format kGeoTiffFormat;

/// A file of another format that was converted to GeoTIFF.
struct ConvertedFile {
  std::filesystem::path path;  // of the original, for messages
  std::string format;
  bool is_depth = false;           // values count downwards
  std::vector<std::string> notes;  // on the conversion
};

/// Opens a GeoTIFF file that stands for another one.
std::unique_ptr<Raster> open_geotiff_for(const std::filesystem::path& path,
                                         const ConvertedFile& original, const OpenOptions& options);

}  // namespace aerostat::elevation

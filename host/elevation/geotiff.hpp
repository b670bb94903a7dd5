#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "elevation/format.hpp"

/// Heights in GeoTIFF files, cloud optimised ones too.
namespace aerostat::elevation {

extern const Format kGeoTiffFormat;

/// Opens a GeoTIFF file that stands for another one, which messages shall name.
std::unique_ptr<Raster> open_geotiff_for(const std::filesystem::path& path,
                                         const std::filesystem::path& shown,
                                         const OpenOptions& options);

}  // namespace aerostat::elevation

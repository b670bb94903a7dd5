#pragma once

#include "elevation/format.hpp"

/// Heights in formats that only GDAL reads, by its programs, if they are installed. A file is
/// converted to a GeoTIFF file in a private folder by a process with limits of its own, which opens
/// nothing but that file.
namespace aerostat::elevation {

/// netCDF, HDF, ERDAS IMAGINE, GRIB and others, told by the first bytes of a file.
extern const Format kGdalFormat;

}  // namespace aerostat::elevation

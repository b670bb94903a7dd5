#pragma once

#include "elevation/raster.hpp"

namespace aerostat::elevation {

/// Throws Error{bad_data} if the coordinates of a raster cannot be those of its coordinate
/// reference system: metres that are said to be degrees, or degrees that are said to be metres. The
/// message names both readings and the option that helps. `crs_is_from_user` tells that this option
/// was used; then only what is impossible is refused. Rasters without a place or system pass.
void require_plausible_place(const RasterInfo& info, bool crs_is_from_user,
                             const char* option = "/terrain/crs");

}  // namespace aerostat::elevation

#pragma once

#include <string>

#include "elevation/open.hpp"
#include "elevation/raster.hpp"
#include "elevation/side_files.hpp"

/// Functions that the readers of images share. The files give neither heights in metres nor
/// distances.
namespace aerostat::elevation {

/// Metres are scale * stored + offset_m.
struct HeightScale {
  double scale = 1.0, offset_m = 0.0;
};

/// Returns how stored values from `lowest` to `highest` become metres by what the user says, and
/// sets the unit. Without a word of the user, values are metres if `may_be_metres`. Otherwise
/// throws Error{bad_data}, which names the options.
HeightScale height_scale_of(RasterInfo& info, const OpenOptions& options, double lowest,
                            double highest, bool may_be_metres);

/// Sets the place from a world file beside the file, or from the distance of samples that the user
/// gives. Throws Error{bad_data}, which names the option, if there is neither.
void set_image_place(RasterInfo& info, const OpenOptions& options, const SideFiles& beside);

/// Adds a note if no coordinate reference system is known.
void say_if_without_crs(RasterInfo& info);

}  // namespace aerostat::elevation

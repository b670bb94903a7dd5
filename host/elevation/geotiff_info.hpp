#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elevation/open.hpp"
#include "elevation/raster.hpp"
#include "elevation/tiff_handle.hpp"
#include "elevation/tiff_layout.hpp"
#include "elevation/tiff_samples.hpp"

namespace aerostat::elevation {

/// A directory of a TIFF file, and where it is in the file.
struct TiffPage {
  TiffLayout layout;
  std::uint64_t directory = 0;
};

/// The directories that make up a raster.
struct TiffPages {
  TiffPage main;
  std::vector<TiffPage> overviews;  // finest first
  std::vector<TiffPage> masks;      // in any order; each belongs to the page of its size
  int others = 0;                   // pages that are no part of the first raster
};

/// Finds the directories of a file that belong to its first raster. `handle` is of the first
/// directory. Throws Error{bad_data} if the first one cannot be read or if `refusal`, which returns
/// why a layout is not wanted or an empty text, does not want it.
TiffPages pages_of(TiffHandle& handle,
                   std::string (*refusal)(const TiffLayout& layout) = refusal_of_heights);

/// The properties of a GeoTIFF file, with the changes that the user asks for.
struct GeoTiffInfo {
  RasterInfo info;
  HeightRule rule;
};
GeoTiffInfo geotiff_info(const TiffHandle& handle, const TiffPages& pages,
                         const OpenOptions& options);

/// Sets the place of a raster from the tags of a file, or else from the files beside it. Throws
/// Error{bad_data} if the place makes no sense.
void set_place(const TiffHandle& handle, const OpenOptions& options, RasterInfo& info,
               double& vertical_unit);

}  // namespace aerostat::elevation

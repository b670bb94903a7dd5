#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "elevation/raster.hpp"
#include "image/write.hpp"
#include "land/land.hpp"
#include "map/map_view.hpp"
#include "scene/resolved_scene.hpp"
#include "world/surface.hpp"

/// Maps in the grid of the elevation data that they show.
namespace aerostat::map {

/// A part of the grid of a scene's first raster, and where it lies.
struct OwnGrid {
  elevation::Georeference georeference;  // of the part's first sample
  int width = 0, height = 0;             // samples
  land::LandPoint middle;                // the middle of the scene's local frame
  std::shared_ptr<const land::Land> land;
};

/// A picture of 8-bit RGBA, row by row from the top. Colours are not multiplied by the opacity.
struct MapPixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Returns the smallest part of the grid that holds all samples whose centres a picture of
/// `width` x `height` pixels shows. Throws Error{bad_data}, with `option` in front, if the scene is
/// not on real land or if the picture shows no sample.
OwnGrid own_grid(const scene::ResolvedScene& scene, const MapView& view, int width, int height,
                 const char* option, world::ReliefCache& reliefs);

/// Returns a map with a pixel for each sample of a grid. Its colours are interpolated by cubic
/// convolution (Keys 1981, a = -0.5), which becomes a mean over the area of a sample where the
/// picture is finer. Samples outside of the picture are transparent, and so are those that have no
/// height in the file.
MapPixels in_own_grid(const image::Pixels& picture, const MapView& view, const OwnGrid& grid);

/// Returns the bytes of a GeoTIFF file, compressed without loss (Deflate). Its coordinate reference
/// system is named by its EPSG code, or else by the WKT of ESRI's kind.
std::vector<std::uint8_t> encode_geotiff(const MapPixels& pixels,
                                         const elevation::Georeference& place);

}  // namespace aerostat::map

#pragma once

#include <array>
#include <cstddef>
#include <functional>

/// What covers the land, as rasters of land cover tell it.
namespace aerostat {

/// The classes. Water comes last, because it is no ground.
enum class CoverClass { woods, shrub, meadow, crops, bare, snow, built_up, wetland, water };

/// The number of the classes of ground.
inline constexpr std::size_t kGroundClasses = 8;

/// The share of each class of ground at a place. Their sum is 1, or less where the raster ends.
using CoverShares = std::array<float, kGroundClasses>;

/// The meaning of the codes of a raster. `automatic` goes by the codes that occur.
enum class CoverScheme { automatic, worldcover, nlcd, corine };

/// Land cover as a function of the place over the terrain, x to the east and z to the south.
struct CoverLookup {
  std::function<CoverShares(double x, double z)> at;
  float cell_m = 0.0f;  // width of the raster's cells
};

}  // namespace aerostat

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/math.hpp"
#include "elevation/raster.hpp"
#include "geo/transform.hpp"
#include "land/land.hpp"

namespace aerostat::land {

/// How messages name a raster that lies over the land.
struct OverlayWords {
  const char* what;        // "picture", for example
  const char* crs_option;  // where a scene names its coordinate reference system
};

/// Where points of the local frame lie in a raster with a place.
class Placement {
 public:
  /// Throws Error{bad_data} if the raster does not say its system, but the land does.
  Placement(const elevation::RasterInfo& info, const LandPoint& middle, const OverlayWords& words);

  /// Turns points of the local frame into columns and rows, counted from the raster's corner.
  void to_raster(std::vector<dvec2>& points) const;

  /// Returns the rectangle around the raster in the local frame: its least and its greatest
  /// coordinates.
  std::pair<dvec2, dvec2> bounds() const;

  /// Returns the width of a sample at a point of the local frame in metres.
  double sample_m(const dvec2& at) const;

 private:
  const elevation::RasterInfo& info_;
  const elevation::Georeference& grid_;
  LandPoint middle_;
  std::optional<geo::Transform> transform_;
  dvec2 shift_{0.0};
};

}  // namespace aerostat::land

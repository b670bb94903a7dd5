#pragma once

#include "core/math.hpp"
#include "scene/resolved_scene.hpp"

namespace aerostat::map {

/// Where the pixels of a map lie: metres to the east and to the north of the terrain's centre.
struct MapView {
  dvec2 corner{0.0};      // the centre of the first pixel
  dvec2 right{1.0, 0.0};  // from a pixel to the one on its right
  dvec2 down{0.0, -1.0};  // from a pixel to the one below it

  /// Returns the column and row of a point. The centres of pixels have whole numbers.
  dvec2 pixel_at(const dvec2& point) const;
};

/// Returns where the pixels of a picture lie. The picture may be the part of a larger one that
/// begins at the pixel `first`. Throws Error{bad_data} if the camera is not orthographic and
/// straight above the ground; the message begins with `option`.
MapView map_view(const scene::ResolvedScene& scene, const dvec2& first, const char* option);

}  // namespace aerostat::map

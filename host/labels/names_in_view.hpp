#pragma once

#include <optional>
#include <vector>

#include "core/math.hpp"
#include "labels/places.hpp"
#include "scene/resolved_scene.hpp"
#include "world/surface.hpp"

namespace aerostat::labels {

/// A named place as a picture shows it.
struct NameInView {
  NamedPlace named;
  double height_m = 0.0;       // above the sea: that of the file of names, or the ground's
  std::optional<dvec2> pixel;  // from the upper left corner of the whole picture; none: behind
  double distance_m = 0.0;
  bool in_picture = false;  // the pixel is one of the picture
  bool hidden = true;       // the ground rises above the line of sight, or there is no pixel
};

/// Returns where each place is seen in a scene on real land. Places without a height lie on the
/// ground, and none lies below it. A place is hidden if the ground, curved as the scene has it,
/// rises above the line of sight by more than the size of a pixel. Balloons, plants and clouds hide
/// nothing. Throws Error{bad_data} if the ground does not come from a file, or if it is unknown
/// where on the Earth the file lies.
std::vector<NameInView> names_in_view(const std::vector<NamedPlace>& places,
                                      const scene::ResolvedScene& scene,
                                      world::ReliefCache& reliefs);

}  // namespace aerostat::labels

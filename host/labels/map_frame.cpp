#include "labels/map_frame.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "labels/land_place.hpp"
#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"
#include "scene/view_axes.hpp"

namespace aerostat::labels {
namespace {

constexpr double kStraight = 1e-9;  // the sine of the largest angle to the vertical

/// Returns a vector of the world as east and north.
dvec2 on_map(const dvec3& vector) {
  return {vector.x, -vector.z};
}

}  // namespace

MapFrame map_frame(const scene::ResolvedScene& scene, const dvec2& first,
                   world::ReliefCache& reliefs) {
  const geo::Place middle = land_place(*scene, reliefs, "--world-file");
  const scene::ViewAxes axes = scene::view_axes(scene->camera);
  if (scene->camera.lens != scene::Lens::orthographic || !(axes.forward.y < 0.0) ||
      glm::length(on_map(axes.forward)) > kStraight) {
    throw Error(ErrorKind::bad_data,
                "--world-file: the picture is no map; expected /camera/lens orthographic and "
                "/camera/target straight below /camera/position");
  }
  const double pixel = scene::pixel_size(*scene).width_m;
  // Adding 0 turns -0 into 0.
  const dvec2 right = pixel * on_map(axes.right) + 0.0, down = -pixel * on_map(axes.up) + 0.0;
  const dvec2 center = on_map({scene->terrain.center.x, 0.0, scene->terrain.center.y});
  const dvec2 steps = first + 0.5 - 0.5 * dvec2(scene->image.width, scene->image.height);
  const dvec2 corner = on_map(scene.eye()) - center + steps.x * right + steps.y * down;
  return {fmt::format("{:.12g}\n{:.12g}\n{:.12g}\n{:.12g}\n{:.12g}\n{:.12g}\n", right.x, right.y,
                      down.x, down.y, corner.x, corner.y),
          fmt::format(
              "PROJCS[\"Local transverse Mercator\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\","
              "SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
              "UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
              "PARAMETER[\"latitude_of_origin\",{:.12g}],PARAMETER[\"central_meridian\",{:.12g}],"
              "PARAMETER[\"scale_factor\",1],PARAMETER[\"false_easting\",0],"
              "PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]\n",
              middle.latitude_deg, middle.longitude_deg)};
}

}  // namespace aerostat::labels

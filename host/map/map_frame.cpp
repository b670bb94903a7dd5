#include "map/map_frame.hpp"

#include <fmt/format.h>

#include "map/land_place.hpp"
#include "map/map_view.hpp"
#include "scene/scene.hpp"

namespace aerostat::map {
MapFrame map_frame(const scene::ResolvedScene& scene, const dvec2& first,
                   world::ReliefCache& reliefs) {
  const geo::Place middle = land_place(*scene, reliefs, "--world-file");
  const MapView view = map_view(scene, first, "--world-file");
  return {fmt::format("{:.12g}\n{:.12g}\n{:.12g}\n{:.12g}\n{:.12g}\n{:.12g}\n", view.right.x,
                      view.right.y, view.down.x, view.down.y, view.corner.x, view.corner.y),
          fmt::format(
              "PROJCS[\"Local transverse Mercator\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\","
              "SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
              "UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
              "PARAMETER[\"latitude_of_origin\",{:.12g}],PARAMETER[\"central_meridian\",{:.12g}],"
              "PARAMETER[\"scale_factor\",1],PARAMETER[\"false_easting\",0],"
              "PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]\n",
              middle.latitude_deg, middle.longitude_deg)};
}

}  // namespace aerostat::map

#include "map/land_place.hpp"

#include "core/error.hpp"
#include "scene/scene.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::map {

const scene::Terrain& require_real_land(const scene::Scene& scene, const std::string& option) {
  if (scene.terrain.kind != scene::TerrainKind::elevation) {
    throw Error(ErrorKind::bad_data,
                option +
                    ": the ground is made from noise and lies nowhere on the Earth; expected "
                    "a scene on real land (/terrain/source)");
  }
  return scene.terrain;
}

geo::Place land_place(const scene::Scene& scene, world::ReliefCache& reliefs,
                      const std::string& option) {
  const auto land = terrain::real_land(require_real_land(scene, option), reliefs.lands);
  if (!land->has_place()) {
    throw Error(ErrorKind::bad_data,
                option +
                    ": the elevation data do not say where on the Earth they lie; name their "
                    "coordinate reference system by /terrain/crs");
  }
  return *terrain::middle_point(scene.terrain, *land).place;
}

}  // namespace aerostat::map

#include <utility>

#include "scene/scene.hpp"
#include "terrain/terrain_mesh.hpp"
#include "world/kinds.hpp"
#include "world/sea.hpp"

namespace aerostat::world {
namespace {

Shape build(const GroupInput& input) {
  const scene::Scene& local = input.local;
  const terrain::HeightField field(local.terrain, input.request.carving, input.reliefs);
  return water_objects(local, terrain::inland_water_mesh(local.terrain, field, *input.ground));
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  return now.scene->surfaces == before.scene->surfaces;
}

}  // namespace

const GroupKind kInlandWater{
    .name = "lakes and rivers", .footing = Footing::on_ground, .build = build, .same = same};

}  // namespace aerostat::world

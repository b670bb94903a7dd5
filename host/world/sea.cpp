#include "world/sea.hpp"

#include <utility>

#include "scene/scene.hpp"
#include "terrain/terrain_mesh.hpp"
#include "world/kinds.hpp"

namespace aerostat::world {
namespace {

Shape build(const GroupInput& input) {
  const scene::Scene& local = input.local;
  return water_objects(local, terrain::water_mesh(local.terrain, local.biome.water, *input.ground));
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  const scene::Water &a = now.scene->biome.water, &b = before.scene->biome.water;
  return a.enabled == b.enabled && a.level_m == b.level_m &&
         now.scene->surfaces == before.scene->surfaces;
}

}  // namespace

Objects water_objects(const scene::Scene& scene, mesh::TriangleMesh water) {
  Objects objects;
  // The colours of the vertices of water are depths, which plain water does not show.
  if (scene.surfaces == scene::Surfaces::plain) water.colors.clear();
  if (!water.empty())
    objects.push_back({scene::ObjectId::water, scene::MaterialId::water, std::move(water)});
  return objects;
}

const GroupKind kSea{.name = "sea", .footing = Footing::on_ground, .build = build, .same = same};

}  // namespace aerostat::world

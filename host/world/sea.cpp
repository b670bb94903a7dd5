#include <utility>

#include "scene/scene.hpp"
#include "terrain/terrain_mesh.hpp"
#include "world/kinds.hpp"

namespace aerostat::world {
namespace {

Shape build(const GroupInput& input) {
  const scene::Scene& local = input.local;
  Objects objects;
  mesh::TriangleMesh water = terrain::water_mesh(local.terrain, local.biome.water, *input.ground);
  // The colours of the sea's vertices are depths, which a plain sea does not show.
  if (local.surfaces == scene::Surfaces::plain) water.colors.clear();
  if (!water.empty())
    objects.push_back({scene::ObjectId::water, scene::MaterialId::water, std::move(water)});
  return objects;
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  const scene::Water &a = now.scene->biome.water, &b = before.scene->biome.water;
  return a.enabled == b.enabled && a.level_m == b.level_m &&
         now.scene->surfaces == before.scene->surfaces;
}

}  // namespace

const GroupKind kSea{.name = "sea", .footing = Footing::on_ground, .build = build, .same = same};

}  // namespace aerostat::world

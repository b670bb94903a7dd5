#include "scene/scene.hpp"
#include "terrain/terrain_mesh.hpp"
#include "world/kinds.hpp"
#include "world/land_memory.hpp"

namespace aerostat::world {
namespace {

Shape build(const GroupInput& input) {
  require_memory_for_land(input.local);
  const scene::Terrain& terrain = input.local.terrain;
  const terrain::HeightField field(terrain, input.request.carving, input.reliefs);
  return HeightGrid{std::make_shared<const mesh::GridMesh>(terrain::terrain_mesh(terrain, field))};
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  return scene::without_drape(now.scene->terrain) == scene::without_drape(before.scene->terrain);
}

}  // namespace

const GroupKind kLand{.name = "land", .footing = Footing::ground, .build = build, .same = same};

}  // namespace aerostat::world

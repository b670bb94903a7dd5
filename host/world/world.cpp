#include "world/world.hpp"

#include <new>

#include <oneapi/tbb/parallel_invoke.h>

#include "core/error.hpp"
#include "model/balloon.hpp"
#include "terrain/terrain_mesh.hpp"
#include "world/plants.hpp"

namespace aerostat::world {
namespace {

std::shared_ptr<const Land> build_land(const scene::Scene& scene) {
  auto land = std::make_shared<Land>();
  land->ground = std::make_shared<const mesh::GridMesh>(terrain::terrain_mesh(scene.terrain));
  if (scene.biome.water.enabled) {
    auto water = terrain::water_mesh(scene.terrain, scene.biome.water, *land->ground);
    if (!water.empty()) land->objects.push_back({scene::ObjectId::water, std::move(water)});
  }
  return land;
}

model::Detail balloon_detail(const scene::Scene& scene) {
  return model::detail_for(scene.balloon, scene.camera.position, scene::pixel_size(scene));
}

bool same_balloon(const scene::Scene& a, const scene::Scene& b) {
  return a.balloon == b.balloon && balloon_detail(a) == balloon_detail(b);
}

std::shared_ptr<const Objects> build_balloon(const scene::Scene& scene) {
  auto objects = std::make_shared<Objects>();
  for (auto& part : model::balloon(scene.balloon, balloon_detail(scene))) {
    objects->push_back({part.id, std::move(part.mesh)});
  }
  return objects;
}

}  // namespace

bool same_land(const scene::Scene& a, const scene::Scene& b) {
  return a.terrain == b.terrain && a.biome.water == b.biome.water;
}

World build(const scene::Scene& scene, const World* previous, const scene::Scene* previous_scene) {
  const bool known = previous != nullptr && previous_scene != nullptr;
  World world;
  try {
    tbb::parallel_invoke(
        [&] {
          const bool same = known && same_land(scene, *previous_scene);
          world.land = same ? previous->land : build_land(scene);
          const bool grown = same && same_plants(scene, *previous_scene);
          world.plants = grown ? previous->plants : build_plants(scene, *world.land->ground);
        },
        [&] {
          if (!scene.balloon.enabled) return;
          const bool same = known && same_balloon(scene, *previous_scene);
          world.balloon = same ? previous->balloon : build_balloon(scene);
        });
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::exhausted,
                "not enough memory for the world's meshes; a smaller /terrain/cells needs less");
  }
  return world;
}

Objects as_triangles(const World& world, Grown plants) {
  Objects objects;
  if (world.land) {
    objects.push_back({scene::ObjectId::terrain, mesh::to_triangles(*world.land->ground)});
    objects.insert(objects.end(), world.land->objects.begin(), world.land->objects.end());
  }
  if (world.balloon) objects.insert(objects.end(), world.balloon->begin(), world.balloon->end());
  if (world.plants && plants == Grown::included) append_as_triangles(*world.plants, objects);
  return objects;
}

}  // namespace aerostat::world

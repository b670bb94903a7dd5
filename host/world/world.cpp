#include "world/world.hpp"

#include <algorithm>
#include <new>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "model/balloon.hpp"
#include "scene/local_frame.hpp"
#include "terrain/terrain_mesh.hpp"
#include "world/land_memory.hpp"
#include "world/plants.hpp"

namespace aerostat::world {
namespace {

constexpr double kCoarseEnvelope_m = 0x1p-5, kCoarseBasket_m = 0x1p-8;

/// `local` counts from its origin, here and below.
std::shared_ptr<const Land> build_land(const scene::Scene& local, Carving carving) {
  require_memory_for_land(local);
  auto land = std::make_shared<Land>();
  land->ground = std::make_shared<const mesh::GridMesh>(
      terrain::terrain_mesh(local.terrain, terrain::HeightField(local.terrain, carving)));
  if (local.biome.water.enabled) {
    auto water = terrain::water_mesh(local.terrain, local.biome.water, *land->ground);
    if (!water.empty())
      land->objects.push_back({scene::ObjectId::water, scene::MaterialId::water, std::move(water)});
  }
  return land;
}

/// All balloons of a scene that are there.
std::vector<const scene::Balloon*> balloons_of(const scene::Scene& scene) {
  std::vector<const scene::Balloon*> balloons;
  if (scene.balloon.enabled) balloons.push_back(&scene.balloon);
  for (const scene::Balloon& further : scene.balloons) {
    if (further.enabled) balloons.push_back(&further);
  }
  return balloons;
}

/// On a coarse land a balloon is coarse, too, even around an eye in its basket.
model::Detail balloon_detail(const scene::Scene& scene, const scene::Balloon& balloon,
                             Carving carving) {
  model::Detail detail =
      model::detail_for(balloon, scene.camera.position, scene::pixel_size(scene));
  if (carving == Carving::coarse) {
    detail.envelope_m = std::max(detail.envelope_m, kCoarseEnvelope_m);
    detail.basket_m = std::max(detail.basket_m, kCoarseBasket_m);
  }
  return detail;
}

bool same_balloons(const scene::Scene& a, const scene::Scene& b, Carving carving) {
  const auto of_a = balloons_of(a), of_b = balloons_of(b);
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                    [&](const scene::Balloon* one, const scene::Balloon* other) {
                      return *one == *other &&
                             balloon_detail(a, *one, carving) == balloon_detail(b, *other, carving);
                    });
}

std::shared_ptr<const Objects> build_balloons(const scene::Scene& local, Carving carving) {
  const auto balloons = balloons_of(local);
  if (balloons.empty()) return nullptr;
  std::vector<Objects> built(balloons.size());
  tbb::parallel_for(std::size_t{0}, balloons.size(), [&](std::size_t i) {
    for (auto& part : model::balloon(*balloons[i], balloon_detail(local, *balloons[i], carving))) {
      built[i].push_back({part.id, part.material, std::move(part.mesh)});
    }
  });
  auto objects = std::make_shared<Objects>();
  for (Objects& one : built) {
    for (Object& part : one) objects->push_back(std::move(part));
  }
  return objects;
}

}  // namespace

bool same_land(const scene::Scene& a, const scene::Scene& b) {
  return a.terrain == b.terrain && a.biome.water == b.biome.water;
}

World build(const scene::Scene& scene, const World* previous, const scene::Scene* previous_scene,
            scatter::Where where, Carving carving) {
  const bool known =
      previous != nullptr && previous_scene != nullptr && previous_scene->origin == scene.origin;
  const scene::Scene local = scene::counted_from_origin(scene);
  World world;
  try {
    tbb::parallel_invoke(
        [&, stop = current_stop()] {
          const StopScope scope(stop);
          const bool same = known && same_land(scene, *previous_scene);
          world.land = same ? previous->land : build_land(local, carving);
          const bool grown = same && same_plants(scene, *previous_scene, where);
          world.plants = grown ? previous->plants : build_plants(scene, *world.land->ground, where);
        },
        [&] {
          const bool same = known && same_balloons(scene, *previous_scene, carving);
          world.balloon = same ? previous->balloon : build_balloons(local, carving);
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
    objects.push_back({scene::ObjectId::terrain, scene::MaterialId::terrain,
                       mesh::to_triangles(*world.land->ground)});
    objects.insert(objects.end(), world.land->objects.begin(), world.land->objects.end());
  }
  if (world.balloon) objects.insert(objects.end(), world.balloon->begin(), world.balloon->end());
  if (world.plants && plants == Grown::included) append_as_triangles(*world.plants, objects);
  return objects;
}

}  // namespace aerostat::world

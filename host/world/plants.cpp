#include "world/plants.hpp"

#include <algorithm>

#include <oneapi/tbb/parallel_for.h>

#include "scatter/sight.hpp"

namespace aerostat::world {
namespace {

constexpr std::uint32_t kDetails = 3;

Object object_of(plant::Species species) {
  switch (species) {
    case plant::Species::boulder:
    case plant::Species::snowy_boulder:
    case plant::Species::driftwood:
      return {scene::ObjectId::stone, scene::MaterialId::stone, {}};
    default:
      return {scene::ObjectId::plant, scene::MaterialId::plant, {}};
  }
}

/// Makes each instance's model that of its detail: details of a model are numbered one after the
/// other.
void choose_details(const scene::Scene& scene, const std::vector<plant::ModelKey>& models,
                    std::vector<scatter::Instance>& instances) {
  const scene::PixelSize pixel = scene::pixel_size(scene);
  const dvec3 eye = scene.camera.position - scene.origin;
  tbb::parallel_for(std::size_t{0}, instances.size(), [&](std::size_t i) {
    scatter::Instance& instance = instances[i];
    const plant::Detail detail = scatter::detail_of(instance, models[instance.model], eye, pixel);
    instance.model = instance.model * kDetails + static_cast<std::uint32_t>(detail);
  });
}

/// Whether plants leave the same room for two balloons.
bool same_room(const scene::Balloon& a, const scene::Balloon& b) {
  return a.enabled == b.enabled && a.position == b.position && a.diameter_m == b.diameter_m;
}

void place(const mesh::TriangleMesh& model, const scatter::Instance& instance,
           mesh::TriangleMesh& mesh) {
  const scatter::Axes axes = scatter::axes_of(instance);
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  const auto turned = [&](const vec3& v) { return axes.x * v.x + axes.y * v.y + axes.z * v.z; };
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    mesh.positions.push_back(instance.position + turned(model.positions[i]));
    mesh.normals.push_back(turned(model.normals[i]) / instance.scale);
    mesh.colors.push_back(model.colors[i] * instance.tint);
  }
  for (const uvec3& triangle : model.triangles) mesh.triangles.push_back(triangle + base);
}

}  // namespace

std::shared_ptr<const Plants> build_plants(const scene::Scene& scene, const mesh::GridMesh& ground,
                                           scatter::Where where) {
  scatter::Growth growth = scatter::scatter(scene, ground, where);
  if (growth.instances.empty()) return nullptr;
  auto plants = std::make_shared<Plants>();
  choose_details(scene, growth.models, growth.instances);
  plants->instances = std::move(growth.instances);
  std::vector<std::uint32_t> number(growth.models.size() * kDetails, 0);
  for (const scatter::Instance& instance : plants->instances) number[instance.model] = 1;
  std::vector<std::uint32_t> used;
  for (std::uint32_t k = 0; k < number.size(); ++k) {
    if (number[k] == 0) continue;
    number[k] = static_cast<std::uint32_t>(used.size());
    used.push_back(k);
  }
  plants->models.resize(used.size());
  tbb::parallel_for(std::size_t{0}, used.size(), [&](std::size_t i) {
    const plant::ModelKey& key = growth.models[used[i] / kDetails];
    const auto detail = static_cast<plant::Detail>(used[i] % kDetails);
    plants->models[i] = object_of(key.species);
    plants->models[i].mesh = plant::build(key, detail);
  });
  for (scatter::Instance& instance : plants->instances) instance.model = number[instance.model];
  return plants;
}

bool same_plants(const scene::Scene& a, const scene::Scene& b, scatter::Where where) {
  if (where == scatter::Where::in_sight && !scatter::same_sight(a, b)) return false;
  return a.vegetation == b.vegetation && a.biome == b.biome &&
         a.camera.position == b.camera.position &&
         scene::point_of_view(a.camera) == scene::point_of_view(b.camera) &&
         scene::pixel_size(a) == scene::pixel_size(b) && same_room(a.balloon, b.balloon) &&
         std::equal(a.balloons.begin(), a.balloons.end(), b.balloons.begin(), b.balloons.end(),
                    same_room);
}

void append_as_triangles(const Plants& plants, Objects& objects) {
  Object grown{scene::ObjectId::plant, scene::MaterialId::plant, {}};
  Object lying{scene::ObjectId::stone, scene::MaterialId::stone, {}};
  for (const scatter::Instance& instance : plants.instances) {
    const Object& model = plants.models[instance.model];
    place(model.mesh, instance, model.id == scene::ObjectId::plant ? grown.mesh : lying.mesh);
  }
  for (Object* object : {&grown, &lying}) {
    if (!object->mesh.empty()) objects.push_back(std::move(*object));
  }
}

}  // namespace aerostat::world

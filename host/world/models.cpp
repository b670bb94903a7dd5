#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "scatter/surface.hpp"
#include "scene/scene.hpp"
#include "world/kinds.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {
namespace {

/// Returns a model as it stands, with its foot at the position that the scene gives.
scatter::Instance instance_of(const scene::PlacedModel& placed, const FileModel& model) {
  scatter::Instance instance;
  instance.position = vec3(placed.position);
  instance.yaw_rad = static_cast<float>(-glm::radians(placed.heading_deg));
  instance.scale = static_cast<float>(scale_of(placed, model));
  return instance;
}

/// Returns the lowest ground under the corners and the middle of a model's base, so that no side of
/// it hovers over a slope.
float lowest_ground(const scatter::Surface& surface, const FileModel& model,
                    const scatter::Instance& instance) {
  const scatter::Axes axes = scatter::axes_of(instance);
  const vec2 least(model.base_least), most(model.base_most), middle = 0.5f * (least + most);
  float lowest = kInfinity;
  for (const vec2& corner : {least, most, vec2(least.x, most.y), vec2(most.x, least.y), middle}) {
    const vec3 at = instance.position + axes.x * corner.x + axes.z * corner.y;
    lowest = std::min(lowest, surface.height(at.x, at.z));
  }
  return lowest;
}

Shape build(const GroupInput& input) {
  const scene::Scene& local = input.local;
  const SceneModels& models = *input.request.models;
  Instances instances;
  instances.are_plants = false;
  for (std::size_t i = 0; i < models.models.size(); ++i) {
    instances.models.push_back({models.models[i]->parts, models.first_material[i]});
  }
  const scatter::Surface surface(*input.ground);
  for (std::size_t i = 0; i < local.objects.size(); ++i) {
    const scene::PlacedModel& placed = local.objects[i];
    const FileModel& model = models.model_of(i);
    scatter::Instance instance = instance_of(placed, model);
    if (placed.height_above == scene::HeightReference::ground) {
      instance.position.y += lowest_ground(surface, model, instance);
    }
    instance.model = static_cast<std::uint32_t>(models.of_object[i]);
    instances.places.push_back(instance);
  }
  return instances;
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  return now.models == before.models && now.scene->objects == before.scene->objects;
}

std::vector<scatter::Obstacle> obstacles(const GroupRequest& request) {
  const auto& objects = request.scene->objects;
  std::vector<scatter::Obstacle> found;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const FileModel& model = request.models->model_of(i);
    const double width_m = scale_of(objects[i], model) * std::hypot(model.size.x, model.size.z);
    found.push_back(
        {objects[i].position, width_m, objects[i].height_above == scene::HeightReference::ground});
  }
  return found;
}

}  // namespace

const GroupKind kModels{.name = "models",
                        .footing = Footing::on_ground,
                        .build = build,
                        .same = same,
                        .obstacles = obstacles};

}  // namespace aerostat::world

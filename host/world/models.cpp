#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "core/grouped.hpp"
#include "core/log.hpp"
#include "scatter/surface.hpp"
#include "scene/scene.hpp"
#include "world/kinds.hpp"
#include "world/scene_models.hpp"
#include "world/strewn.hpp"

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

/// Says that rules and distances left room for fewer instances than were asked for.
void tell_of_room(const scene::PlacedModel& placed, const FileModel& model, std::size_t found) {
  if (found >= static_cast<std::size_t>(placed.count)) return;
  warn(
      fmt::format("{}: {} of {} instances stand, because the rules of the area leave no more room.",
                  model.key.file.filename().string(), grouped(found),
                  grouped(static_cast<std::uint64_t>(placed.count))));
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
    if (is_strewn(placed)) continue;
    const FileModel& model = models.model_of(i);
    scatter::Instance instance = instance_of(placed, model);
    if (placed.height_above == scene::HeightReference::ground) {
      instance.position.y += lowest_ground(surface, model, instance);
    }
    instance.model = static_cast<std::uint32_t>(models.of_object[i]);
    instances.places.push_back(instance);
  }
  for (const Strewn& strewn : strew(input, surface)) {
    tell_of_room(local.objects[strewn.object], models.model_of(strewn.object),
                 strewn.instances.size());
    instances.places.insert(instances.places.end(), strewn.instances.begin(),
                            strewn.instances.end());
  }
  return instances;
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  return now.models == before.models && now.scene->objects == before.scene->objects &&
         same_strewn(*now.scene, *before.scene);
}

std::vector<scatter::Obstacle> obstacles(const GroupRequest& request) {
  const auto& objects = request.scene->objects;
  std::vector<scatter::Obstacle> found;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    // Plants leave room for strewn models when both stand.
    if (is_strewn(objects[i])) continue;
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

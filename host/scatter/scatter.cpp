#include "scatter/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ground/ground_numbers.hpp"
#include "scatter/biome_layers.hpp"
#include "scatter/species.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {
namespace {

// The width in metres below which noise does not decide whether a tree stands at a place.
constexpr float kFootprintM = 1.0f;

std::vector<plant::ModelKey> all_models() {
  std::vector<plant::ModelKey> models;
  for (int s = 0; s < plant::kSpeciesCount; ++s) {
    const auto species = static_cast<plant::Species>(s);
    for (int v = 0; v < plant::variant_count(species); ++v) models.push_back({species, v});
  }
  return models;
}

/// Returns the height of an object's foot above the ground. The y of `place` may count from there.
double height_above(const Surface& surface, const dvec3& place, bool counts_from_ground = false) {
  if (counts_from_ground) return place.y;
  return place.y - static_cast<double>(surface.height(place.x, place.z));
}

Circles kept_out(const scene::ResolvedScene& scene, const Surface& surface,
                 std::span<const Obstacle> obstacles, double tallest_m) {
  Circles circles;
  const auto add = [&](const dvec3& at, double radius_m, bool above_ground = false) {
    if (height_above(surface, at, above_ground) < kClear_m) {
      circles.add({{at.x, at.z}, radius_m});
    }
  };
  add(scene::place_of(*scene, scene.eye()), kRoomOfEye_m);
  for (const Obstacle& obstacle : obstacles) {
    add(scene::place_of(*scene, obstacle.position), room_of(obstacle.width_m),
        obstacle.above_ground);
  }
  for (const scene::Clearing& clearing : scene->vegetation.clearings) {
    const dvec3 middle = scene::place_of(*scene, dvec3(clearing.center.x, 0.0, clearing.center.y));
    circles.add({{middle.x, middle.z}, clearing.radius_m});
  }
  circles.index(kPlantReach * tallest_m);
  return circles;
}

/// Returns a height that no plant exceeds. It is larger than what the layers allow.
double tallest_of(const std::vector<plant::ModelKey>& models, const Nature& nature) {
  const scene::Scene& scene = nature.scene;
  double tallest = 0.0;
  for (const plant::ModelKey& model : models) {
    tallest = std::max(tallest, plant::model_height(model));
  }
  // If the canopy of the biome is wider than that of these models, all plants are larger.
  constexpr double kCanopyM = 5.8;
  const double wide = std::max(1.0, scene.biome.ground.canopy_m / kCanopyM);
  tallest *= 1.5 * wide;
  for (std::size_t i = 0; i < nature.species.size(); ++i) {
    // The height of a plant is rounded to single precision.
    const double extent = greatest_extent(scene.vegetation.species[i], nature.species[i]);
    tallest = std::max(tallest, 1.001 * extent);
  }
  return tallest * scene.vegetation.size;
}

/// Returns the extent of a plant as seen from the middle of its square. No plant is broader than
/// tall.
Extent extent_of(const std::vector<Layer>& layers, double tallest_m) {
  double spacing = 0.0;
  for (const Layer& layer : layers) spacing = std::max(spacing, layer.spacing_m);
  return {0.64 * spacing + 0.5 * tallest_m, tallest_m};
}

/// Leaves out the models that no instance uses.
void drop_unused(Growth& growth) {
  std::vector<std::uint32_t> renumbered(growth.models.size(), 0);
  for (const Instance& instance : growth.instances) {
    if (instance.model < renumbered.size()) renumbered[instance.model] = 1;
  }
  std::vector<plant::ModelKey> used;
  for (std::size_t i = 0; i < growth.models.size(); ++i) {
    if (renumbered[i] == 0) continue;
    renumbered[i] = static_cast<std::uint32_t>(used.size());
    used.push_back(growth.models[i]);
  }
  const auto own = static_cast<std::uint32_t>(growth.models.size());
  const auto kept = static_cast<std::uint32_t>(used.size());
  for (Instance& instance : growth.instances) {
    const std::uint32_t model = instance.model;
    instance.model = model < own ? renumbered[model] : model - own + kept;
  }
  growth.models = std::move(used);
}

}  // namespace

Axes axes_of(const Instance& instance) {
  const vec2 lean = instance.lean;
  const vec3 up(lean.x, std::sqrt(std::max(1.0f - glm::dot(lean, lean), 0.0f)), lean.y);
  const vec3 ahead(std::sin(instance.yaw_rad), 0.0f, std::cos(instance.yaw_rad));
  const vec3 right = glm::normalize(glm::cross(up, ahead));
  return {right * instance.scale, up * instance.scale, glm::cross(right, up) * instance.scale};
}

Growth scatter(const scene::ResolvedScene& scene, const mesh::GridMesh& ground, Where where,
               std::span<const Obstacle> obstacles, const CoverLookup* cover,
               std::span<const SpeciesModel> species) {
  Growth growth;
  const scene::Vegetation& vegetation = scene->vegetation;
  if (!vegetation.enabled || !(vegetation.density > 0.0)) return growth;
  growth.models = all_models();
  const Surface surface(ground, scene::place_of(*scene, scene.origin()));
  const ground::GroundRule rule(ground::ground_numbers(*scene), kFootprintM, cover);
  const Nature nature{*scene, surface, rule, cover, species};
  std::vector<Layer> layers = biome_layers(nature);
  add_species(nature, layers);
  const double tallest_m = tallest_of(growth.models, nature);
  const Circles circles = kept_out(scene, surface, obstacles, tallest_m);
  std::optional<Sight> sight;
  if (where == Where::in_sight) {
    sight.emplace(scene, ground, vegetation.reach_m, extent_of(layers, tallest_m), obstacles);
  }
  const dvec3 middle = scene::place_of(*scene, scene::point_of_view(scene->camera));
  const Place place{surface,
                    rule,
                    sea_level(nature),
                    {middle.x, middle.z},
                    circles,
                    vegetation.seed,
                    sight ? &*sight : nullptr,
                    tallest_m};
  for (const Layer& layer : layers) {
    const auto placed = place_layer(layer, place, growth.models);
    growth.instances.insert(growth.instances.end(), placed.begin(), placed.end());
  }
  drop_unused(growth);
  return growth;
}

bool same_room(const scene::ResolvedScene& scene, const mesh::GridMesh& ground,
               std::span<const Obstacle> now, std::span<const Obstacle> before) {
  const auto same = [](const Obstacle& a, const Obstacle& b) { return a == b; };
  if (std::equal(now.begin(), now.end(), before.begin(), before.end(), same)) return true;
  const Surface surface(ground, scene::place_of(*scene, scene.origin()));
  const auto hovers = [&](const Obstacle& obstacle) {
    const dvec3 place = scene::place_of(*scene, obstacle.position);
    return height_above(surface, place, obstacle.above_ground) >= kClear_m;
  };
  return std::equal(now.begin(), now.end(), before.begin(), before.end(),
                    [&](const Obstacle& a, const Obstacle& b) {
                      if (a == b) return true;
                      return a.width_m == b.width_m && square_of(a) == square_of(b) && hovers(a) &&
                             hovers(b);
                    });
}

plant::Detail detail_of(const Instance& instance, const plant::ModelKey& model, const dvec3& eye,
                        const scene::PixelSize& pixel) {
  const double height = plant::model_height(model) * static_cast<double>(instance.scale);
  const double distance = std::max(glm::distance(dvec3(instance.position), eye), 0.1);
  const double pixels = height / pixel.metres(distance);
  if (pixels > 120.0) return plant::Detail::near;
  if (pixels > 30.0) return plant::Detail::middle;
  return pixels > 14.0 ? plant::Detail::far : plant::Detail::outline;
}

}  // namespace aerostat::scatter

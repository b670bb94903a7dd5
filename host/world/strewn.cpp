#include "world/strewn.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/random.hpp"
#include "core/stop_scope.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"
#include "terrain/cover.hpp"
#include "terrain/height_field.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {
namespace {

/// How often a place is looked for, for each instance that is asked for. Chosen by eye: rules that
/// leave a fiftieth of the area still find all places.
constexpr int kTries = 100;
/// How many tries pass between two looks whether to stop.
constexpr int kTriesBetweenStops = 4096;

/// The places that are taken, in squares as wide as the least distance.
class Taken {
 public:
  explicit Taken(double apart_m) : apart_(apart_m) {}

  bool has_room(const dvec2& place) const {
    if (!(apart_ > 0.0)) return true;
    const auto [i, j] = square_of(place);
    for (std::int64_t x = i - 1; x <= i + 1; ++x) {
      for (std::int64_t z = j - 1; z <= j + 1; ++z) {
        const auto found = squares_.find(key(x, z));
        if (found == squares_.end()) continue;
        for (const dvec2& other : found->second) {
          if (glm::distance(place, other) < apart_) return false;
        }
      }
    }
    return true;
  }

  void add(const dvec2& place) {
    if (!(apart_ > 0.0)) return;
    const auto [i, j] = square_of(place);
    squares_[key(i, j)].push_back(place);
  }

 private:
  std::pair<std::int64_t, std::int64_t> square_of(const dvec2& place) const {
    return {static_cast<std::int64_t>(std::floor(place.x / apart_)),
            static_cast<std::int64_t>(std::floor(place.y / apart_))};
  }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return (static_cast<std::uint64_t>(i) << 32) ^ (static_cast<std::uint64_t>(j) & 0xffffffffu);
  }

  double apart_;
  std::unordered_map<std::uint64_t, std::vector<dvec2>> squares_;
};

/// Strews one model after the other.
class Strewer {
 public:
  Strewer(const GroupInput& input, const scatter::Surface& surface)
      : input_(input), surface_(surface) {
    if (input.local.biome.water.enabled) sea_ = input.local.biome.water.level_m;
    field_.emplace(input.local.terrain, input.request.carving, input.reliefs);
    if (!field_->has_water()) field_.reset();
    cover_ = terrain::cover_of(input.request.scene->terrain, input.reliefs);
    origin_ = scene::place_of(*input.request.scene, input.request.scene.origin());
  }

  Strewn run(std::size_t object) {
    const scene::PlacedModel& placed = input_.local.objects[object];
    const scene::PlacedArea area = placed.area.value_or(scene::PlacedArea());
    Strewn strewn{object, {}};
    Taken taken(area.apart_m);
    for (const dvec2& place : all_) taken.add(place);
    Random random(area.seed);
    const std::int64_t most_tries = std::int64_t{kTries} * placed.count;
    for (std::int64_t i = 0; i < most_tries; ++i) {
      if (std::ssize(strewn.instances) == placed.count) break;
      if (i % kTriesBetweenStops == 0) stop_if_asked(current_stop());
      const auto instance = try_place(object, area, taken, random);
      if (instance) strewn.instances.push_back(*instance);
    }
    return strewn;
  }

  /// Keeps room for a model that stands alone.
  void take(const dvec3& position) { all_.emplace_back(position.x, position.z); }

 private:
  /// Draws a place, size and heading, and returns the instance if the rules allow it.
  std::optional<scatter::Instance> try_place(std::size_t object, const scene::PlacedArea& area,
                                             Taken& taken, Random& random) {
    const scene::PlacedModel& placed = input_.local.objects[object];
    const FileModel& model = input_.request.models->model_of(object);
    const double x = random.range(-0.5, 0.5), z = random.range(-0.5, 0.5);
    const double size = random.range(area.sizes.x, area.sizes.y);
    const double heading = random.range(-180.0, 180.0);
    const dvec2 place(placed.position.x + area.size_m.x * x, placed.position.z + area.size_m.y * z);
    if (!surface_.covers(place.x, place.y) || !taken.has_room(place)) return std::nullopt;
    const scatter::SurfacePoint ground = surface_.at(place.x, place.y);
    const auto water = water_above(ground.position);
    if (!suits(area, ground, water.has_value()) || !has_cover(area, place)) return std::nullopt;
    scatter::Instance instance;
    instance.position = {static_cast<float>(place.x), static_cast<float>(placed.position.y),
                         static_cast<float>(place.y)};
    const double turn = area.turned ? heading : placed.heading_deg;
    instance.yaw_rad = static_cast<float>(-glm::radians(turn));
    instance.scale = static_cast<float>(scale_of(placed, model) * size);
    instance.model = static_cast<std::uint32_t>(input_.request.models->of_object[object]);
    if (placed.height_above == scene::HeightReference::ground) {
      const bool floats = water && area.on == scene::PlacedOn::water;
      instance.position.y +=
          floats ? static_cast<float>(*water) : lowest_ground(surface_, model, instance);
    }
    taken.add(place);
    all_.push_back(place);
    return instance;
  }

  bool suits(const scene::PlacedArea& area, const scatter::SurfacePoint& ground,
             bool is_wet) const {
    if (area.on == scene::PlacedOn::land && is_wet) return false;
    if (area.on == scene::PlacedOn::water && !is_wet) return false;
    const double height = static_cast<double>(ground.position.y) + input_.request.scene.origin().y;
    if (height < area.heights_m.x || height > area.heights_m.y) return false;
    // Water is level, whatever lies below it.
    if (area.on == scene::PlacedOn::water) return true;
    const double up = std::clamp(static_cast<double>(ground.normal.y), -1.0, 1.0);
    const double slope_deg = glm::degrees(std::acos(up));
    return slope_deg >= area.slope_deg.x && slope_deg <= area.slope_deg.y;
  }

  /// Returns whether more than half of what covers a place is of the classes of an area.
  bool has_cover(const scene::PlacedArea& area, const dvec2& place) const {
    if (area.cover.empty()) return true;
    if (!cover_) return false;
    const double east = origin_.x + place.x, south = origin_.z + place.y;
    const double footprint_m = cover_->ground().texel_m;
    const CoverShares shares = cover_->at(east, south, footprint_m);
    float share = 0.0f;
    for (const CoverClass one : area.cover) {
      if (one != CoverClass::water) {
        share += shares[static_cast<std::size_t>(one)];
      } else if (cover_->has_water()) {
        share += cover_->water_at(east, south, footprint_m);
      }
    }
    return share > 0.5f;
  }

  /// Returns the level of the water that covers a point of the ground, or nothing if it is dry.
  std::optional<double> water_above(const vec3& ground) const {
    const double height = static_cast<double>(ground.y);
    if (sea_ && height < *sea_) return sea_;
    if (!field_) return std::nullopt;
    const auto level = field_->water_level(ground.x, ground.z);
    return level && height < *level ? level : std::nullopt;
  }

  const GroupInput& input_;
  const scatter::Surface& surface_;
  std::optional<double> sea_;
  std::optional<terrain::HeightField> field_;
  std::shared_ptr<const land::Cover> cover_;
  dvec3 origin_{0.0};  // the place over the terrain from which positions count
  std::vector<dvec2> all_;
};

}  // namespace

bool is_strewn(const scene::PlacedModel& placed) {
  return placed.count > 1 || placed.area.has_value();
}

std::vector<Strewn> strew(const GroupInput& input, const scatter::Surface& surface) {
  const auto& objects = input.local.objects;
  std::vector<Strewn> all;
  if (std::none_of(objects.begin(), objects.end(), is_strewn)) return all;
  Strewer strewer(input, surface);
  for (const scene::PlacedModel& placed : objects) {
    if (!is_strewn(placed)) strewer.take(placed.position);
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (is_strewn(objects[i])) all.push_back(strewer.run(i));
  }
  return all;
}

bool same_strewn(const scene::Scene& a, const scene::Scene& b) {
  const bool any_a = std::any_of(a.objects.begin(), a.objects.end(), is_strewn);
  const bool any_b = std::any_of(b.objects.begin(), b.objects.end(), is_strewn);
  if (!any_a && !any_b) return true;
  const scene::Water &wet_a = a.biome.water, &wet_b = b.biome.water;
  return a.objects == b.objects && wet_a.enabled == wet_b.enabled && wet_a.level_m == wet_b.level_m;
}

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

}  // namespace aerostat::world

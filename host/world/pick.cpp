#include "world/pick.hpp"

#include <algorithm>
#include <cmath>

#include "model/balloon.hpp"
#include "model/envelope_shape.hpp"
#include "model/rigging.hpp"
#include "scene/balloons.hpp"
#include "scene/scene.hpp"
#include "world/scene_models.hpp"
#include "world/strewn.hpp"

namespace aerostat::world {
namespace {

/// How far from the plan of a model a point may be that still belongs to it, as a share of the
/// model's size and in metres. The distance of a pixel is that of the nearest sample in it. Chosen
/// by eye.
constexpr double kShareAround = 0.02, kMetresAround = 0.3;

/// The step along a ray that looks for the ground, as a share of the distance and in metres. Chosen
/// by eye.
constexpr double kStepShare = 0.004, kLeastStep_m = 0.25;

/// Returns how far a point is outside of a rectangle around the origin with these sides.
double distance_outside(const dvec2& point, const dvec2& sides) {
  return glm::length(glm::max(glm::abs(point) - 0.5 * sides, dvec2(0.0)));
}

/// Returns a place in plan as a model sees it that is turned clockwise as seen from above.
dvec2 turned_back(const dvec2& from_foot, double heading_deg) {
  const double turn = glm::radians(heading_deg), c = std::cos(turn), s = std::sin(turn);
  return {c * from_foot.x + s * from_foot.y, c * from_foot.y - s * from_foot.x};
}

}  // namespace

std::optional<std::size_t> object_at(const scene::Scene& scene, const SceneModels& models,
                                     const dvec3& point) {
  std::optional<std::size_t> best;
  double best_size = kInfinity;
  for (std::size_t i = 0; i < scene.objects.size() && i < models.of_object.size(); ++i) {
    const scene::PlacedModel& placed = scene.objects[i];
    const FileModel& model = models.model_of(i);
    const dvec2 plan = scale_of(placed, model) * dvec2(model.size.x, model.size.z);
    const dvec2 from_foot(point.x - placed.position.x, point.z - placed.position.z);
    const double around = kShareAround * glm::length(plan) + kMetresAround;
    double size = glm::length(plan), outside = 0.0;
    if (is_strewn(placed)) {
      // An area is larger than each model that stands alone.
      const dvec2 sides = placed.area.value_or(scene::PlacedArea()).size_m + 2.0 * dvec2(size);
      outside = distance_outside(from_foot, sides);
      size = kMostReach_m + glm::length(sides);
    } else {
      outside = distance_outside(turned_back(from_foot, placed.heading_deg), plan);
    }
    if (outside > around || size >= best_size) continue;
    best = i;
    best_size = size;
  }
  return best;
}

std::optional<std::size_t> balloon_at(const scene::Scene& scene, const dvec3& point) {
  std::optional<std::size_t> nearest;
  double nearest_m = kInfinity;
  const auto look_at = [&](const scene::Balloon& balloon, std::size_t number) {
    if (!balloon.enabled) return;
    const dvec3 middle = balloon.position +
                         dvec3(0.0, model::balloon_height(balloon) - 0.5 * balloon.diameter_m, 0.0);
    const double outside = glm::distance(point, middle) - 0.5 * balloon.diameter_m;
    if (outside >= nearest_m) return;
    nearest = number;
    nearest_m = outside;
  };
  look_at(scene.balloon, 0);
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) look_at(scene.balloons[i], i + 1);
  return nearest;
}

ClothPlace cloth_place(const scene::Balloon& balloon, const dvec3& point) {
  const model::EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  const dvec3 from_mouth =
      point - balloon.position - dvec3(0.0, model::mouth_height(balloon.diameter_m), 0.0);
  // The middle of a gore rises from the mouth to the crown.
  double low = shape.mouth_arc(), high = shape.plate_arc();
  for (int i = 0; i < 40; ++i) {
    const double arc = 0.5 * (low + high);
    (shape.fabric(0, 0.5, {arc, 0.0}).position.y < from_mouth.y ? low : high) = arc;
  }
  const double azimuth_deg = glm::degrees(std::atan2(from_mouth.x, -from_mouth.z));
  return {std::remainder(azimuth_deg - balloon.heading_deg, 360.0), low - shape.mouth_arc()};
}

std::optional<double> distance_to_ground(const dvec3& origin, const dvec3& direction,
                                         const std::function<double(double x, double z)>& height) {
  const auto is_below = [&](double distance) {
    const dvec3 point = origin + direction * distance;
    return point.y < height(point.x, point.z);
  };
  double before = 0.0;
  while (before < kMostReach_m) {
    double after = before + std::max(kLeastStep_m, kStepShare * before);
    if (is_below(after)) {
      for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (before + after);
        (is_below(middle) ? after : before) = middle;
      }
      return after;
    }
    before = after;
  }
  return std::nullopt;
}

}  // namespace aerostat::world

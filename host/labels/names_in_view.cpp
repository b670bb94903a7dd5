#include "labels/names_in_view.hpp"

#include <algorithm>
#include <cmath>

#include "geo/transform.hpp"
#include "labels/projection.hpp"
#include "map/land_place.hpp"
#include "scene/scene.hpp"

namespace aerostat::labels {
namespace {

// Steps of the march along a line of sight, as a share of the way, and their ends.
constexpr double kStep = 0.002, kShortest_m = 5.0, kLongest_m = 60.0;
/// Farther than this from the middle of the ground, a scene has no land.
constexpr double kFarthest_m = 1e6;

/// The land of a scene, and how it is seen.
class Sight {
 public:
  Sight(const scene::ResolvedScene& scene, world::ReliefCache& reliefs)
      : scene_(*scene),
        middle_(map::land_place(*scene, reliefs, "--labels")),
        projection_(scene),
        surface_(*scene, world::Carving::fine, reliefs) {}

  NameInView see(const NamedPlace& named) const {
    NameInView seen;
    seen.named = named;
    const dvec2 local = geo::local_point(middle_, named.place);
    const double away = glm::length(local);
    if (!(away < kFarthest_m)) return seen;
    const double drop = scene_.terrain.curved ? geo::curvature_drop(away) : 0.0;
    const dvec2 at = local + scene_.terrain.center;
    const double ground = surface_.height(at.x, at.y);
    seen.height_m = named.height_m.value_or(ground + drop);
    const dvec3 point(at.x, std::max(seen.height_m - drop, ground), at.y);
    const std::optional<Projected> projected = projection_.of(point);
    if (!projected) return seen;
    seen.pixel = projected->pixel;
    seen.distance_m = projected->distance_m;
    seen.in_picture = projected->pixel.x >= 0.0 && projected->pixel.x < scene_.image.width &&
                      projected->pixel.y >= 0.0 && projected->pixel.y < scene_.image.height;
    seen.hidden = is_hidden(point, projected->distance_m);
    return seen;
  }

 private:
  /// Marches from the eye to a point.
  bool is_hidden(const dvec3& point, double distance_m) const {
    const dvec3 eye = projection_.eye_for(point);
    const dvec3 ahead = (point - eye) / distance_m;
    double step = kShortest_m;
    for (double t = step; t < distance_m - step; t += step) {
      const dvec3 at = eye + t * ahead;
      // Rays that pass beside the point by a pixel are those of the same pixel.
      const double tolerance = projection_.pixel_m(distance_m) * t / distance_m;
      if (surface_.height(at.x, at.z, step) > at.y + tolerance) return true;
      step = std::clamp(kStep * t, kShortest_m, kLongest_m);
    }
    return false;
  }

  const scene::Scene& scene_;
  geo::Place middle_;
  Projection projection_;
  world::Surface surface_;
};

}  // namespace

std::vector<NameInView> names_in_view(const std::vector<NamedPlace>& places,
                                      const scene::ResolvedScene& scene,
                                      world::ReliefCache& reliefs) {
  const Sight sight(scene, reliefs);
  std::vector<NameInView> names;
  names.reserve(places.size());
  for (const NamedPlace& place : places) names.push_back(sight.see(place));
  return names;
}

}  // namespace aerostat::labels

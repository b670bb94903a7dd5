#include "staging/view_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

#include "geo/transform.hpp"

namespace aerostat::staging {
namespace {

constexpr int kAzimuths = 72;     // directions in which rays leave a place
constexpr int kFan = 4;           // rays on each side of a view's middle: 4 x 5.5 degrees
constexpr int kPlacesAside = 26;  // places along a side of the map
constexpr double kFarthest_m = 40000.0;
constexpr double kStep = 1.06;  // each step of a ray is so many times as long as the one before
constexpr double kBlocking_deg = 4.0;
constexpr double kApart_deg = 50.0;  // of views from places that lie close together

/// The distances that matter for views over a map. They are smaller over a small one.
struct Distances {
  double first_m, blocking_m, farthest_m;

  explicit Distances(const ViewMap& map)
      : first_m(std::min(120.0, 0.05 * map.half_m())),
        blocking_m(std::min(2500.0, 0.25 * map.half_m())),
        farthest_m(std::min(kFarthest_m, 2.0 * map.half_m())) {}
};

/// What a ray sees of the land.
struct Ray {
  double skyline_deg = -90.0, skyline_m = 0.0;
  double near_deg = -90.0;  // the greatest angle nearer than a slope that blocks the view
  double ground_deg = 0.0;  // the mean angle of the ground before that distance
  double known = 0.0;       // share of the steps over known land
  int ridges = 0;
};

Ray follow(const ViewMap& map, const dvec3& eye, double azimuth_rad, const Distances& distances) {
  Ray ray;
  const dvec2 towards(std::sin(azimuth_rad), -std::cos(azimuth_rad));
  int steps = 0, known = 0, near_steps = 0;
  double near_sum = 0.0;
  bool hidden = false;
  for (double d = distances.first_m; d < distances.farthest_m; d *= kStep) {
    const dvec2 at = dvec2(eye.x, eye.z) + d * towards;
    const double rise = map.height(at.x, at.y) - geo::curvature_drop(d) - eye.y;
    const double angle = glm::degrees(std::atan2(rise, d));
    ++steps;
    known += map.is_known(at.x, at.y) ? 1 : 0;
    if (d < distances.blocking_m) {
      ray.near_deg = std::max(ray.near_deg, angle);
      near_sum += angle;
      ++near_steps;
    }
    if (angle > ray.skyline_deg) {
      if (hidden && angle > ray.skyline_deg + 0.15) ++ray.ridges;
      hidden = false;
      ray.skyline_deg = angle;
      ray.skyline_m = d;
    } else if (angle < ray.skyline_deg - 0.15) {
      hidden = true;
    }
  }
  ray.known = steps > 0 ? static_cast<double>(known) / steps : 0.0;
  ray.ground_deg = near_steps > 0 ? near_sum / near_steps : 0.0;
  return ray;
}

using Rays = std::array<Ray, kAzimuths>;

/// Returns a third of the relief around a place, as the balloon's height above the ground.
double height_over(const ViewMap& map, const dvec2& place) {
  const double reach = std::min(8000.0, 0.5 * map.half_m());
  double highest = map.height(place.x, place.y);
  const double ground = highest;
  for (int j = -6; j <= 6; ++j)
    for (int i = -6; i <= 6; ++i) {
      highest = std::max<double>(highest,
                                 map.height(place.x + i * reach / 6.0, place.y + j * reach / 6.0));
    }
  const double least = std::clamp(0.02 * map.half_m(), 40.0, 120.0);
  return std::clamp(0.33 * (highest - ground), least, 700.0);
}

bool sees_summit(const ViewMap& map, const dvec3& eye, const Rays& rays, int middle) {
  const dvec2 way = dvec2(map.summit().x, map.summit().z) - dvec2(eye.x, eye.z);
  const double distance = glm::length(way);
  if (distance < Distances(map).blocking_m) return false;
  const double azimuth = glm::degrees(std::atan2(way.x, -way.y));
  const double turn = std::remainder(azimuth - middle * 360.0 / kAzimuths, 360.0);
  if (std::abs(turn) > 18.0) return false;
  const int nearest =
      ((static_cast<int>(std::lround(azimuth * kAzimuths / 360.0)) % kAzimuths) + kAzimuths) %
      kAzimuths;
  const double rise = map.summit().y - geo::curvature_drop(distance) - eye.y;
  const double angle = glm::degrees(std::atan2(rise, distance));
  return angle > rays[nearest].skyline_deg - 1.0;
}

/// Returns the measure of a view and where its skyline is highest.
ViewChoice judge(const ViewMap& map, const dvec3& eye, const Rays& rays, int middle,
                 double sun_azimuth_deg) {
  double sum = 0.0, squares = 0.0, depth = 0.0, blocked = 0.0, ground = 0.0, known = 0.0, far = 0.0;
  const Distances distances(map);
  double highest = -90.0;
  ViewChoice view;
  constexpr int kCount = 2 * kFan + 1;
  for (int k = -kFan; k <= kFan; ++k) {
    const Ray& ray = rays[(middle + k + kAzimuths) % kAzimuths];
    const double angle = std::clamp(ray.skyline_deg, -2.0, 12.0);
    sum += angle;
    squares += angle * angle;
    depth += std::min(ray.ridges, 4) / 4.0;
    blocked += ray.near_deg > kBlocking_deg ? 1.0 : 0.0;
    ground += ray.ground_deg < -4.0 ? 1.0 : 0.0;
    known += ray.known;
    far += ray.skyline_m > 1.5 * distances.blocking_m ? 1.0 : 0.0;
    if (ray.skyline_deg > highest) {
      highest = ray.skyline_deg;
      view.peak_turn_deg = k * 360.0 / kAzimuths;
    }
  }
  const double mean = sum / kCount;
  const double deviation = std::sqrt(std::max(squares / kCount - mean * mean, 0.0));
  const double azimuth = middle * 360.0 / kAzimuths;
  const double side = std::sin(glm::radians(sun_azimuth_deg - azimuth));
  const double share = known / kCount;
  view.azimuth_deg = azimuth;
  view.score = mean / 6.0 + std::min(deviation, 3.0) / 2.5 + depth / kCount + 0.7 * side * side +
               0.4 * ground / kCount + 0.5 * far / kCount +
               (sees_summit(map, eye, rays, middle) ? 0.5 : 0.0) - 3.0 * blocked / kCount;
  // A bad view gets no better by unknown land.
  view.score = view.score > 0.0 ? view.score * share * share : view.score;
  return view;
}

/// Returns the best views of a place.
std::vector<ViewChoice> views_from(const ViewMap& map, const dvec2& place, double sun_azimuth_deg) {
  if (!map.is_known(place.x, place.y)) return {};
  const double above = height_over(map, place);
  const dvec3 eye(place.x, map.height(place.x, place.y) + above, place.y);
  const Distances distances(map);
  Rays rays;
  for (int k = 0; k < kAzimuths; ++k) {
    rays[k] = follow(map, eye, glm::radians(k * 360.0 / kAzimuths), distances);
  }
  std::vector<ViewChoice> views;
  for (int k = 0; k < kAzimuths; k += 2) {
    ViewChoice view = judge(map, eye, rays, k, sun_azimuth_deg);
    view.place = place;
    view.above_ground_m = above;
    views.push_back(view);
  }
  return views;
}

ViewPlaces lattice_over(const ViewMap& map) {
  ViewPlaces places;
  const auto along = [&map](int k) {
    return 0.9 * map.half_m() * (2.0 * k / (kPlacesAside - 1) - 1.0);
  };
  for (int j = 0; j < kPlacesAside; ++j)
    for (int i = 0; i < kPlacesAside; ++i) places.emplace_back(along(i), along(j));
  return places;
}

bool is_alike(const ViewChoice& a, const ViewChoice& b, double near_m) {
  return glm::length(a.place - b.place) < near_m &&
         std::abs(std::remainder(a.azimuth_deg - b.azimuth_deg, 360.0)) < kApart_deg;
}

}  // namespace

std::vector<ViewChoice> choose_views(const ViewMap& map, double sun_azimuth_deg, int count,
                                     const ViewPlaces& places) {
  const ViewPlaces tried = places.empty() ? lattice_over(map) : places;
  std::vector<std::vector<ViewChoice>> views(tried.size());
  tbb::parallel_for(std::size_t{0}, tried.size(),
                    [&](std::size_t k) { views[k] = views_from(map, tried[k], sun_azimuth_deg); });
  std::vector<ViewChoice> all;
  for (const auto& some : views) all.insert(all.end(), some.begin(), some.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const ViewChoice& a, const ViewChoice& b) { return a.score > b.score; });
  std::vector<ViewChoice> chosen;
  const double near_m = 0.35 * map.half_m();
  for (const ViewChoice& view : all) {
    if (static_cast<int>(chosen.size()) >= count) break;
    const bool alike = std::any_of(chosen.begin(), chosen.end(), [&](const ViewChoice& other) {
      return is_alike(view, other, near_m);
    });
    if (!alike) chosen.push_back(view);
  }
  return chosen;
}

}  // namespace aerostat::staging

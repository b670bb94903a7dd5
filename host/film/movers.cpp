#include "film/movers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/log.hpp"
#include "core/smooth_step.hpp"
#include "film/keys.hpp"
#include "film/traffic.hpp"
#include "scene/balloons.hpp"

namespace aerostat::film {
namespace {

/// The speed of what bends the streaks of thin high cloud, in speeds at which bulges rise: layers
/// of air at that height pass over each other faster. Chosen by eye.
constexpr double kBendSpeed = 10.0;

/// Returns the height of a balloon above the level that it counts from: by keys, or else as it is
/// given.
double key_height(const scene::Film& film, std::size_t index, double given, double time_s) {
  return element_at(film.keys, balloon_pointer(index) + "/position", 1, time_s).value_or(given);
}

/// Returns whether keys move a balloon along the ground.
bool is_keyed(const scene::Film& film, std::size_t index) {
  const std::string position = balloon_pointer(index) + "/position";
  return std::any_of(film.keys.begin(), film.keys.end(), [&](const scene::KeyTrack& track) {
    return track.value == position || track.value == position + "/0" ||
           track.value == position + "/2";
  });
}

}  // namespace

std::string balloon_pointer(std::size_t index) {
  return index == 0 ? "/balloon" : fmt::format("/balloons/{}", index - 1);
}

Balloons::Balloons(const scene::Scene& start, const SteeredAt& steered_at, std::size_t festival,
                   HeightAt ground)
    : film_(start.film), festival_burner_(start.festival.burner), ground_(std::move(ground)) {
  scene::Scene scene = start;
  const auto all = scene::all_balloons(scene);
  for (std::size_t i = 0; i < all.size(); ++i) add(*all[i], steered_at(i, 0.0).has_value());
  keep_apart(start, steered_at, festival);
}

void Balloons::add(const scene::Balloon& balloon, bool is_steered) {
  const std::size_t index = balloons_.size();
  const dvec3 given = balloon.position;
  const bool is_above_ground = balloon.height_above == scene::HeightReference::ground;
  const double base = is_above_ground ? ground_(given.x, given.z) : 0.0;
  const bool is_drifting = !film_.wind.empty() && !is_steered && !is_keyed(film_, index);
  balloons_.push_back(
      {given, given + dvec3(0.0, base, 0.0), is_above_ground, is_drifting, {}, Drift({}, {})});
  set_course(index, {});
}

void Balloons::set_course(std::size_t index, const Course& course) {
  One& one = balloons_[index];
  one.course = course;
  // The time of a drift counts from take-off.
  const double from_s = course.launch ? course.launch->time_s : 0.0;
  one.drift = Drift(film_.wind,
                    [this, index, course, from_s, base = one.start.y - one.given.y](double time) {
                      return base + height_of(index, course, from_s + time);
                    });
}

/// Finds a course for each balloon of the festival, one after the other, so that none meets those
/// before it. Warns if there is no room for some.
void Balloons::keep_apart(const scene::Scene& start, const SteeredAt& steered_at,
                          std::size_t festival) {
  scene::Scene scene = start;
  const auto all = scene::all_balloons(scene);
  Traffic traffic(film_.duration_s);
  for (std::size_t i = 0; i < std::min(festival, all.size()); ++i) {
    if (!all[i]->enabled) continue;
    traffic.add(traffic.way_of(
        [&](double time_s) { return steered_at(i, time_s).value_or(place(i, time_s)); }));
  }
  int crowded = 0;
  double nearest_m = start.festival.apart_m;
  for (std::size_t i = festival; i < all.size(); ++i) {
    Courses courses(start.festival, film_, i - festival, all[i]->position.y);
    Course best;
    Traffic::Way way;
    double room_m = -1.0;
    for (int attempt = 0; attempt < Courses::kMost && room_m < start.festival.apart_m; ++attempt) {
      const Course course = courses.next();
      set_course(i, course);
      Traffic::Way tried = traffic.way_of([&](double time_s) { return place(i, time_s); });
      const double found_m = traffic.least_distance(tried);
      if (found_m <= room_m) continue;
      best = course, way = std::move(tried), room_m = found_m;
    }
    set_course(i, best);
    traffic.add(std::move(way));
    if (room_m < start.festival.apart_m) ++crowded;
    nearest_m = std::min(nearest_m, room_m);
  }
  if (crowded == 0) return;
  warn(fmt::format(
      "no free course was found for {} of the balloons of /festival, and the nearest come "
      "within {:.0f} m of each other (/festival/apart_m is {:g}): fewer balloons or a "
      "larger /festival/spread_m give them room",
      crowded, nearest_m, start.festival.apart_m));
}

/// Returns the height of a balloon above the level that it counts from.
double Balloons::height_of(std::size_t index, const Course& course, double time_s) const {
  if (course.launch) return course.launch->climbed(time_s);
  return key_height(film_, index, balloons_[index].given.y, time_s) +
         course.risen(time_s, film_.climb_m_s);
}

dvec3 Balloons::place_of(std::size_t index, double time_s) {
  One& one = balloons_[index];
  const auto& launch = one.course.launch;
  const double climb = height_of(index, one.course, time_s) - one.given.y;
  const double since = launch ? std::max(time_s - launch->time_s, 0.0) : time_s;
  const dvec2 way = one.drift.at(since);
  dvec3 place = one.start + dvec3(way.x, climb, way.y);
  // A balloon that the wind carries towards a slope slides up along it.
  place.y = std::max(place.y, ground_(place.x, place.z));
  return place;
}

dvec3 Balloons::place(std::size_t index, double time_s) {
  const One& one = balloons_[index];
  if (one.is_drifting || one.course.launch) return place_of(index, time_s);
  const std::string pointer = balloon_pointer(index) + "/position";
  dvec3 place = one.given;
  for (int axis = 0; axis < 3; ++axis) {
    place[axis] = element_at(film_.keys, pointer, axis, time_s).value_or(place[axis]);
  }
  if (one.is_above_ground) place.y += ground_(place.x, place.z);
  return place;
}

void Balloons::move(scene::Scene& scene, double time_s) {
  const auto all = scene::all_balloons(scene);
  for (std::size_t i = 0; i < all.size(); ++i) {
    scene::Balloon& balloon = *all[i];
    const auto& launch = balloons_[i].course.launch;
    if (launch) {
      const double strength = std::max(balloon.burner, 0.5 * festival_burner_);
      balloon.burner = strength * launch->burner(time_s);
    }
    if (balloons_[i].is_drifting || launch) {
      balloon.position = place_of(i, time_s);
      if (!is_moved(film_.keys, balloon_pointer(i) + "/heading_deg")) {
        balloon.heading_deg =
            std::remainder(balloon.heading_deg + film_.turn_deg_s * time_s, 360.0);
      }
    } else if (balloon.height_above == scene::HeightReference::ground) {
      balloon.position.y += ground_(balloon.position.x, balloon.position.z);
    }
    balloon.height_above = scene::HeightReference::sea;
  }
}

void move_clouds_and_waves(const scene::Film& film, double time_s, const dvec3& eye,
                           const dvec3& way, scene::Scene& scene) {
  if (!is_moved(film.keys, "/biome/water/time_s")) scene.biome.water.time_s += time_s;
  if (!is_moved(film.keys, "/sky/cumulus/rise_m")) {
    scene.sky.cumulus.rise_m += time_s * film.cloud_change_m_s;
  }
  if (!is_moved(film.keys, "/sky/cloud_bend_m")) {
    scene.sky.cloud_bend_m += time_s * kBendSpeed * film.cloud_change_m_s;
  }
  if (!is_moved(film.keys, "/sky/cumulus/drift_m")) {
    scene.sky.cumulus.drift_m += time_s * wind_at(film.wind, scene.sky.cumulus.base_m);
  }
  if (!is_moved(film.keys, "/sky/cloud_drift_m")) {
    const double height = eye.y + scene.sky.cloud_height_m;
    scene.sky.cloud_drift_m += time_s * wind_at(film.wind, height) - dvec2(way.x, way.z);
  }
}

}  // namespace aerostat::film

#include "film/movers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "film/keys.hpp"
#include "scene/balloons.hpp"

namespace aerostat::film {
namespace {

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

Balloons::Balloons(const scene::Scene& start, const std::vector<bool>& steered, HeightAt ground)
    : film_(start.film), ground_(std::move(ground)) {
  scene::Scene scene = start;
  const auto all = scene::all_balloons(scene);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const dvec3 given = all[i]->position;
    const bool is_above_ground = all[i]->height_above == scene::HeightReference::ground;
    const double base = is_above_ground ? ground_(given.x, given.z) : 0.0;
    const bool is_drifting = !film_.wind.empty() && !steered[i] && !is_keyed(film_, i);
    const auto height = [this, i, y = given.y, base](double time) {
      return base + key_height(film_, i, y, time);
    };
    balloons_.push_back({given, given + dvec3(0.0, base, 0.0), is_above_ground, is_drifting,
                         Drift(film_.wind, height)});
  }
}

dvec3 Balloons::place_of(std::size_t index, double time_s) {
  One& one = balloons_[index];
  const double given = one.given.y;
  const double climb = key_height(film_, index, given, time_s) - given;
  const dvec2 way = one.drift.at(time_s);
  dvec3 place = one.start + dvec3(way.x, climb, way.y);
  // A balloon that the wind carries towards a slope slides up along it.
  place.y = std::max(place.y, ground_(place.x, place.z));
  return place;
}

dvec3 Balloons::place(double time_s) {
  const One& one = balloons_[0];
  if (one.is_drifting) return place_of(0, time_s);
  const std::string pointer = balloon_pointer(0) + "/position";
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
    if (balloons_[i].is_drifting) {
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
  if (!is_moved(film.keys, "/sky/cumulus/drift_m")) {
    scene.sky.cumulus.drift_m += time_s * wind_at(film.wind, scene.sky.cumulus.base_m);
  }
  if (!is_moved(film.keys, "/sky/cloud_drift_m")) {
    const double height = eye.y + scene.sky.cloud_height_m;
    scene.sky.cloud_drift_m += time_s * wind_at(film.wind, height) - dvec2(way.x, way.z);
  }
}

}  // namespace aerostat::film

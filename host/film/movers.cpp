#include "film/movers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "core/random.hpp"
#include "core/smooth_step.hpp"
#include "film/keys.hpp"
#include "scene/balloons.hpp"

namespace aerostat::film {
namespace {

/// The speed of what bends the streaks of thin high cloud, in speeds at which bulges rise: layers
/// of air at that height pass over each other faster. Chosen by eye.
constexpr double kBendSpeed = 10.0;

/// The time within which a balloon reaches half of its speed after take-off, the time for which the
/// burner heats before it, and that from one burst to the next. Chosen by eye.
constexpr double kSoft_s = 2.0, kHeating_s = 8.0, kBurst_s = 7.0;

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

double Launch::climbed(double at_s) const {
  const double since = std::max(at_s - time_s, 0.0);
  const double soft = since * since / (since + kSoft_s);
  return height_m > 0.0 ? height_m * -std::expm1(-climb_m_s * soft / height_m) : 0.0;
}

double Launch::burner(double at_s) const {
  const double since = at_s - time_s + kHeating_s;
  if (since < 0.0) return 0.0;
  const double need = 1.0 - 0.7 * climbed(at_s) / std::max(height_m, 1e-9);
  const double phase = since / kBurst_s - std::floor(since / kBurst_s);
  // A flame flares up and goes out within a tenth of the time between two.
  return smooth_unit_step(std::clamp(10.0 * phase, 0.0, 1.0)) *
         smooth_unit_step(std::clamp(10.0 * (0.75 * need - phase), 0.0, 1.0));
}

double launch_time(std::uint32_t seed, std::size_t number, double within_s) {
  return within_s * Random((std::uint64_t{seed} << 32) + number).unit();
}

Balloons::Balloons(const scene::Scene& start, const std::vector<bool>& steered,
                   std::size_t festival, HeightAt ground)
    : film_(start.film), festival_burner_(start.festival.burner), ground_(std::move(ground)) {
  scene::Scene scene = start;
  const auto all = scene::all_balloons(scene);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const dvec3 given = all[i]->position;
    const bool is_above_ground = all[i]->height_above == scene::HeightReference::ground;
    const double base = is_above_ground ? ground_(given.x, given.z) : 0.0;
    const bool is_drifting = !film_.wind.empty() && !steered[i] && !is_keyed(film_, i);
    std::optional<Launch> launch;
    if (i >= festival && film_.launch_s > 0.0) {
      const double time_s = launch_time(start.festival.seed, i - festival, film_.launch_s);
      launch = Launch{time_s, given.y, film_.climb_m_s};
    }
    // The time of a drift counts from take-off.
    const auto height = [this, i, y = given.y, base, launch](double time) {
      return base +
             (launch ? launch->climbed(launch->time_s + time) : key_height(film_, i, y, time));
    };
    balloons_.push_back({given, given + dvec3(0.0, base, 0.0), is_above_ground, is_drifting,
                         Drift(film_.wind, height), launch});
  }
}

dvec3 Balloons::place_of(std::size_t index, double time_s) {
  One& one = balloons_[index];
  const double given = one.given.y;
  const double height =
      one.launch ? one.launch->climbed(time_s) : key_height(film_, index, given, time_s);
  const double climb = height - given;
  const double since = one.launch ? std::max(time_s - one.launch->time_s, 0.0) : time_s;
  const dvec2 way = one.drift.at(since);
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
    if (balloons_[i].launch) {
      const double strength = std::max(balloon.burner, 0.5 * festival_burner_);
      balloon.burner = strength * balloons_[i].launch->burner(time_s);
    }
    if (balloons_[i].is_drifting || balloons_[i].launch) {
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

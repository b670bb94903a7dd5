#include "film/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "film/camera.hpp"
#include "film/clearings.hpp"
#include "film/keys.hpp"
#include "film/movers.hpp"
#include "scatter/obstacle.hpp"
#include "scene/balloons.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "staging/flight_path.hpp"
#include "staging/flight_point.hpp"
#include "staging/stage.hpp"
#include "world/resolve.hpp"
#include "world/surface.hpp"

namespace aerostat::film {

namespace {

/// Returns whether the sun of a scene on real land is that of the moment of a flight.
bool has_open_sun(const scene::SceneSource& source) {
  return !source.gives("/sun/date") && !source.gives("/sun/direction") &&
         !source.gives("/sun/azimuth_deg") && !source.gives("/sun/elevation_deg");
}

}  // namespace

struct Timeline::State {
  State(const scene::SceneSource& given, terrain::ReliefCache& reliefs_to_use)
      : film(given.scene().film),
        staged(staging::stage(given.without({"/film"}), reliefs_to_use)),
        reliefs(reliefs_to_use) {
    start = keyed(0.0);
    start.film = film;
    const std::size_t festival = 1 + start.balloons.size();
    scene::hold_festival(start);
    follow_tracks(given);
    move_along_tracks(start, 0.0);
    const auto ground = [this](double x, double z) { return height(x, z); };
    balloons.emplace(
        start, [this](std::size_t index, double time_s) { return on_track(index, time_s); },
        festival, ground);
    rig.emplace(
        start, [this](double time_s) { return balloon_at(time_s); }, ground);
    eye_start = eye_of(at(0.0, nullptr));
    if (start.vegetation.enabled) find_clearings();
  }

  /// A balloon that goes along a recorded flight.
  struct Track {
    std::size_t balloon;
    staging::FlightPath path;
  };

  void follow_tracks(const scene::SceneSource& given) {
    const auto all = scene::all_balloons(start);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i]->track) tracks.push_back({i, {*all[i]->track, start.terrain, reliefs}});
    }
    has_clock = !tracks.empty() && tracks[0].balloon == 0 && has_open_sun(given);
  }

  void move_along_tracks(scene::Scene& scene, double time_s) {
    const auto all = scene::all_balloons(scene);
    for (const Track& track : tracks) {
      all[track.balloon]->position = *on_track(track.balloon, time_s);
      all[track.balloon]->height_above = scene::HeightReference::sea;
    }
  }

  /// Returns where a recorded flight brings a balloon at a time, with its height above the sea, or
  /// nothing if the balloon has none.
  std::optional<dvec3> on_track(std::size_t index, double time_s) const {
    for (const Track& track : tracks) {
      if (track.balloon == index) return track.path.after(time_s * film.track_speed).position;
    }
    return std::nullopt;
  }

  /// Returns where the first balloon is at a time, with its height above the sea.
  dvec3 balloon_at(double time_s) {
    const auto tracked = on_track(0, time_s);
    return tracked ? *tracked : balloons->place(0, time_s);
  }

  /// Returns the scene with the values of the keys at a time, and with the sun of that moment of
  /// the flight if the scene leaves it open.
  scene::Scene keyed(double time_s) const {
    std::vector<scene::Override> changes;
    if (has_clock) {
      if (const auto time = tracks[0].path.after(time_s * film.track_speed).time_s) {
        const auto [date, clock] = staging::date_and_time(*time);
        changes = {{"/sun/date", date}, {"/sun/time", clock}};
      }
    }
    const auto keys = changes_at(film.keys, time_s);
    changes.insert(changes.end(), keys.begin(), keys.end());
    return staged.source.with(changes).scene();
  }

  /// Adds the balloons of the festival as they were at the beginning. Their places depend on where
  /// the other balloons are, which move.
  void add_festival(scene::Scene& scene) const {
    const auto listed = static_cast<std::ptrdiff_t>(scene.balloons.size());
    scene.balloons.insert(scene.balloons.end(), start.balloons.begin() + listed,
                          start.balloons.end());
    scene.festival.count = 0;
  }

  double height(double x, double z) {
    if (!surface) surface.emplace(start, world::Carving::fine, reliefs);
    return surface->height(x, z);
  }

  /// Finds the room that plants leave to camera and balloons anywhere in the film.
  void find_clearings() {
    const auto flyers = [this](double time_s) {
      scene::Scene scene = at(time_s, nullptr);
      std::vector<Flyer> all{{eye_of(scene), scatter::kRoomOfEye_m}};
      for (const scene::Balloon* balloon : scene::all_balloons(scene)) {
        // What is not there is out of the way.
        const dvec3 away(0.0, balloon->enabled ? 0.0 : 1e6, 0.0);
        all.push_back({balloon->position + away, scatter::room_of(balloon->diameter_m)});
      }
      return all;
    };
    clearings = clearings_along(flyers, film.duration_s,
                                [this](double x, double z) { return height(x, z); });
  }

  dvec3 eye_of(const scene::Scene& scene) { return world::resolve(scene, reliefs).eye(); }

  /// Returns the scene at a time. `from` is where the eye was at the beginning, or null to leave
  /// the clouds alone.
  scene::Scene at(double time_s, const dvec3* from) {
    scene::Scene scene = keyed(time_s);
    add_festival(scene);
    move_along_tracks(scene, time_s);
    balloons->move(scene, time_s);
    rig->move(scene, time_s);
    scene.film = {};
    auto& cleared = scene.vegetation.clearings;
    cleared.insert(cleared.end(), clearings.begin(), clearings.end());
    if (from != nullptr) {
      const dvec3 eye = eye_of(scene);
      move_clouds_and_waves(film, time_s, eye, eye - *from, scene);
    }
    return scene;
  }

  scene::Film film;
  staging::Staged staged;
  terrain::ReliefCache& reliefs;
  scene::Scene start;
  std::vector<Track> tracks;
  bool has_clock = false;  // the first track gives the sun's time
  std::optional<world::Surface> surface;
  std::optional<Balloons> balloons;
  std::optional<CameraRig> rig;
  std::vector<scene::Clearing> clearings;
  dvec3 eye_start{0.0};
};

Timeline::Timeline(const scene::SceneSource& source, terrain::ReliefCache& reliefs)
    : state_(std::make_unique<State>(source, reliefs)) {}

Timeline::~Timeline() = default;

const std::vector<std::string>& Timeline::notes() const {
  return state_->staged.notes;
}

const scene::Film& Timeline::film() const {
  return state_->film;
}

int Timeline::frames() const {
  return frame_count(state_->film);
}

double Timeline::time_of(int frame) const {
  return (frame - 1) / state_->film.fps;
}

int Timeline::moments() const {
  return state_->film.shutter_angle_deg > 0.0 ? state_->film.shutter_moments : 1;
}

double Timeline::time_of_moment(int frame, int moment) const {
  const scene::Film& film = state_->film;
  const double open_s = film.shutter_angle_deg / 360.0 / film.fps;
  const double share = (moment + 0.5) / moments();
  return time_of(frame) + (moments() > 1 ? share * open_s : 0.0);
}

scene::Scene Timeline::scene_at(int frame) {
  return scene_at_time(time_of(frame));
}

double Timeline::ground_at(double x, double z) {
  return state_->height(x, z);
}

scene::Scene Timeline::scene_at_time(double time_s) {
  return state_->at(time_s, &state_->eye_start);
}

int frame_count(const scene::Film& film) {
  return std::max(1, static_cast<int>(std::llround(film.duration_s * film.fps)));
}

}  // namespace aerostat::film

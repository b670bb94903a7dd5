#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/film.hpp"
#include "scene/source.hpp"
#include "terrain/relief_cache.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::film {

/// A scene in time. A frame is a function of the scene and the frame's number alone, whatever was
/// asked for before.
class Timeline {
 public:
  /// Takes a scene, and chooses what it leaves open (staging::stage). The caches must outlive the
  /// timeline. Throws the errors of staging::stage, staging::FlightPath and world::resolve.
  Timeline(const scene::SceneSource& source, terrain::ReliefCache& reliefs);
  ~Timeline();
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  /// Returns sentences for the user on what was found and chosen.
  const std::vector<std::string>& notes() const;

  const scene::Film& film() const;

  /// Returns the number of frames, at least 1.
  int frames() const;

  /// Returns the time of a frame in seconds. The frames count from 1, and the first one is at 0.
  double time_of(int frame) const;

  /// Returns the number of moments that a frame averages: 1, or more if the shutter has an angle.
  int moments() const;

  /// Returns the time of a moment of a frame in seconds. Moments count from 0. With an open
  /// shutter, they are the middles of equal parts of the time for which it is open; otherwise, the
  /// only one is time_of(frame).
  double time_of_moment(int frame, int moment) const;

  /// Returns the scene of a frame. It has no film, and its heights of balloons and of the camera
  /// count from the sea.
  scene::Scene scene_at(int frame);

  /// Returns the height above the sea on which one stands at a place.
  double ground_at(double x, double z);

  /// Returns the scene at a time in seconds.
  scene::Scene scene_at_time(double time_s);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the number of frames of a film, at least 1.
int frame_count(const scene::Film& film);

}  // namespace aerostat::film

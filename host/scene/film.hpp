#pragma once

#include <string>
#include <vector>

#include "core/math.hpp"

/// A film of a scene: how its values, its camera and the wind go on in time.
namespace aerostat::scene {

/// How values go from one key to the next: at an even rate, slowly at both ends, or not at all
/// until the next key.
enum class Easing { linear, smooth, hold };

/// What moves the camera. The manual (docs/manual/films.md) says what each mode does.
enum class CameraMode { scene, path, orbit, chase, basket, ground };

/// What the camera of a mode looks at. `usual` stands for what suits the mode.
enum class CameraLook { usual, target, balloon, ahead };

/// A value that a key gives: a number, an array of numbers, or a text.
struct KeyValue {
  std::vector<double> numbers;  // one for a number; empty for a text
  bool is_array = false;
  std::string text;

  bool operator==(const KeyValue&) const = default;
};

/// A key: the value at a time.
struct Key {
  double time_s = 0.0;
  KeyValue is;

  bool operator==(const Key&) const = default;
};

/// The keys of one value of the scene.
struct KeyTrack {
  std::string value;  // JSON pointer
  Easing ease = Easing::smooth;
  std::vector<Key> keys;

  bool operator==(const KeyTrack&) const = default;
};

/// The wind at a height. Between the heights of a profile, it turns and changes evenly.
struct WindLayer {
  double height_m = 0.0;    // above the sea
  double speed_m_s = 3.0;   // speed of the air
  double from_deg = 270.0;  // azimuth that the wind comes from

  bool operator==(const WindLayer&) const = default;
};

/// A point of the camera's path.
struct PathPoint {
  dvec3 position{0.0};  // its y counts from the level of /camera/height_above
  double time_s = 0.0;

  bool operator==(const PathPoint&) const = default;
};

struct CameraMove {
  CameraMode mode = CameraMode::scene;
  CameraLook look = CameraLook::usual;
  std::vector<PathPoint> path;
  bool constant_speed = false;
  double radius_m = 60.0;   // distance of an orbit from the balloon's axis
  double height_m = 10.0;   // height of an orbit above the floor of the basket
  double from_deg = 180.0;  // azimuth, seen from the balloon, where an orbit begins
  double turn_deg_s = 6.0;  // an orbit's turn in a second
  double lag_s = 1.5;       // time by which a chase lags behind

  bool operator==(const CameraMove&) const = default;
};

struct Film {
  double duration_s = 10.0;
  double fps = 25.0;
  std::vector<KeyTrack> keys;
  std::vector<WindLayer> wind{WindLayer{}};
  double cloud_change_m_s = 1.0;  // speed at which bulges rise through heaped clouds
  double turn_deg_s = 1.0;        // slow turn of balloons that drift
  double launch_s = 0.0;     // within which the festival's balloons take off; 0: all fly already
  double climb_m_s = 2.5;    // speed at which they climb
  double track_speed = 1.0;  // seconds of a recorded flight in a second of the film
  double meter_s = 2.0;      // between the moments by whose light the film is exposed
  /// The share of a frame's time for which the shutter is open, as the angle of a disc that turns
  /// once a frame. 0: a frame shows one moment.
  double shutter_angle_deg = 0.0;
  int shutter_moments = 8;  // moments that a frame averages while the shutter is open
  CameraMove camera;

  bool operator==(const Film&) const = default;
};

}  // namespace aerostat::scene

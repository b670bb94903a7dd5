#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "film/wind.hpp"
#include "scene/film.hpp"
#include "scene/scene.hpp"

/// What moves by itself in a film.
namespace aerostat::film {

/// Returns the height above the sea on which one stands at a place.
using HeightAt = std::function<double(double x, double z)>;

/// Returns the JSON pointer of a balloon in the order of scene::all_balloons().
std::string balloon_pointer(std::size_t index);

/// A balloon that takes off and climbs to a height.
struct Launch {
  double time_s = 0.0;     // of take-off
  double height_m = 0.0;   // above where it stands
  double climb_m_s = 2.5;  // soon after take-off

  /// Returns how far it has climbed. It begins softly and slows down towards its height.
  double climbed(double at_s) const;
  /// Returns the strength of the burner, 0 to 1: bursts, which get shorter towards its height.
  double burner(double at_s) const;
};

/// Returns the time of take-off of a balloon of a festival.
double launch_time(std::uint32_t seed, std::size_t number, double within_s);

/// The balloons in the wind. Keys of a balloon's height let it climb and sink, into the wind that
/// blows there. Keys of its place along the ground take it out of the wind.
class Balloons {
 public:
  /// Takes the scene at the beginning, with the balloons of its festival, and the height of the
  /// ground. `steered` says of each balloon whether something else than the wind moves it. The
  /// balloons from number `festival` on take off within /film/launch_s.
  Balloons(const scene::Scene& start, const std::vector<bool>& steered, std::size_t festival,
           HeightAt ground);

  /// Puts the balloons of a scene at a time to their places, with heights above the sea.
  void move(scene::Scene& scene, double time_s);

  /// Returns where the wind or its keys bring the first balloon at a time, with its height above
  /// the sea.
  dvec3 place(double time_s);

 private:
  struct One {
    dvec3 given;  // as the scene has it
    dvec3 start;  // with its height above the sea
    bool is_above_ground = false;
    bool is_drifting = false;
    Drift drift;
    std::optional<Launch> launch;
  };

  dvec3 place_of(std::size_t index, double time_s);

  scene::Film film_;
  double festival_burner_;
  HeightAt ground_;
  std::vector<One> balloons_;
};

/// Moves the clouds with the wind, changes their shapes, and moves the waves with time. `way` is
/// how far the eye has gone since the film began: thin high cloud hangs over the eye, and the film
/// holds it in its place.
void move_clouds_and_waves(const scene::Film& film, double time_s, const dvec3& eye,
                           const dvec3& way, scene::Scene& scene);

}  // namespace aerostat::film

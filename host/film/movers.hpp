#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "film/course.hpp"
#include "film/wind.hpp"
#include "scene/film.hpp"
#include "scene/scene.hpp"

/// What moves by itself in a film.
namespace aerostat::film {

/// Returns the height above the sea on which one stands at a place.
using HeightAt = std::function<double(double x, double z)>;

/// Returns the JSON pointer of a balloon in the order of scene::all_balloons().
std::string balloon_pointer(std::size_t index);

/// The balloons in the wind. Keys of a balloon's height let it climb and sink, into the wind that
/// blows there. Keys of its place along the ground take it out of the wind. The balloons of a
/// festival keep apart: those that would meet others take off at another time or go to another
/// height.
class Balloons {
 public:
  /// Returns where something else than the wind brings a balloon at a time, with its height above
  /// the sea, or nothing if nothing does.
  using SteeredAt = std::function<std::optional<dvec3>(std::size_t index, double time_s)>;

  /// Takes the scene at the beginning, with the balloons of its festival, and the height of the
  /// ground. The balloons from number `festival` on are those of the festival.
  Balloons(const scene::Scene& start, const SteeredAt& steered_at, std::size_t festival,
           HeightAt ground);

  /// Puts the balloons of a scene at a time to their places, with heights above the sea.
  void move(scene::Scene& scene, double time_s);

  /// Returns where the wind or its keys bring a balloon at a time, with its height above the sea.
  dvec3 place(std::size_t index, double time_s);

 private:
  struct One {
    dvec3 given;  // as the scene has it
    dvec3 start;  // with its height above the sea
    bool is_above_ground = false;
    bool is_drifting = false;
    Course course;
    Drift drift;
  };

  void add(const scene::Balloon& balloon, bool is_steered);
  void set_course(std::size_t index, const Course& course);
  void keep_apart(const scene::Scene& start, const SteeredAt& steered_at, std::size_t festival);
  double height_of(std::size_t index, const Course& course, double time_s) const;
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

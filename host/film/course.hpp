#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/random.hpp"
#include "scene/balloon.hpp"
#include "scene/film.hpp"

/// How balloons of a festival get to their heights.
namespace aerostat::film {

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

/// Returns the time of take-off of a balloon of a festival, unless it would meet others.
double launch_time(std::uint32_t seed, std::size_t number, double within_s);

/// How a balloon of a festival gets to its height. Without a launch, it flies at the beginning and
/// goes up or down from there.
struct Course {
  std::optional<Launch> launch;
  double rise_m = 0.0;

  /// Returns by how much a balloon without a launch has gone up. Its speed is at most `climb_m_s`.
  double risen(double time_s, double climb_m_s) const;
};

/// The courses that a balloon of a festival may take, in the order in which they are tried. They
/// follow from the seed and its number.
class Courses {
 public:
  /// How many of them are tried at most.
  static constexpr int kMost = 100;

  /// `height_m` is the height that the festival gives the balloon. The festival and the film must
  /// outlive this object.
  Courses(const scene::Festival& festival, const scene::Film& film, std::size_t number,
          double height_m);

  Course next();

 private:
  const scene::Festival& festival_;
  const scene::Film& film_;
  double height_m_, first_s_;
  Random random_;
  int tried_ = 0;
};

}  // namespace aerostat::film

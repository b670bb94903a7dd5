#pragma once

#include <memory>

#include "scene/scene.hpp"

namespace aerostat::world {

/// Heights of what one stands on: the ground, or the sea where it is higher. Copies share their
/// data; safe from any thread.
class Surface {
 public:
  /// Takes some tenths of a second for a terrain that was not the last one asked for.
  explicit Surface(const scene::Scene& scene);

  /// Metres above sea level.
  double height(double x, double z) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace aerostat::world

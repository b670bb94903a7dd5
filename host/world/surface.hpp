#pragma once

#include <memory>

#include "scene/scene.hpp"
#include "terrain/carving.hpp"

namespace aerostat::world {

using terrain::Carving;

/// Heights of what one stands on: the ground, or the sea where it is higher. Copies share their
/// data; safe from any thread.
class Surface {
 public:
  /// Takes some tenths of a second for a terrain that was not the last one asked for.
  explicit Surface(const scene::Scene& scene, Carving carving = Carving::fine);

  /// Metres above sea level, without the ground's detail below `spacing`.
  double height(double x, double z, double spacing = 0.0) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace aerostat::world

#pragma once

#include <memory>

#include "scene/scene.hpp"
#include "terrain/carving.hpp"
#include "terrain/relief_cache.hpp"

namespace aerostat::world {

using terrain::Carving;
using terrain::ReliefCache;

/// Heights of what one stands on: the ground, or the sea where it is higher. Copies share their
/// data; safe from any thread.
class Surface {
 public:
  /// Prepares the relief, which takes some tenths of a second.
  explicit Surface(const scene::Scene& scene, Carving carving = Carving::fine);

  /// Takes the relief from a cache, or prepares it and leaves it there.
  Surface(const scene::Scene& scene, Carving carving, ReliefCache& reliefs);

  /// Metres above sea level, without the ground's detail below `spacing`.
  double height(double x, double z, double spacing = 0.0) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace aerostat::world

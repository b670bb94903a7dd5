#pragma once

#include <memory>

#include "terrain/carving.hpp"
#include "terrain/relief_cache.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::world {

using terrain::Carving;
using terrain::ReliefCache;

/// The heights on which one stands: the ground, or the sea, a lake or a river where it is higher.
/// Copies share their data. It may be used from any thread.
class Surface {
 public:
  /// Prepares the relief, which takes some tenths of a second. The scene need not be resolved.
  explicit Surface(const scene::Scene& scene, Carving carving = Carving::fine);

  /// Takes the relief from a cache, or prepares it and leaves it there.
  Surface(const scene::Scene& scene, Carving carving, ReliefCache& reliefs);

  /// Returns the height in metres above sea level, without detail of the ground below `spacing`.
  double height(double x, double z, double spacing = 0.0) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// Returns whether two scenes have the same land and sea, whatever their meshes count from. They
/// need not be resolved.
bool same_land(const scene::Scene& a, const scene::Scene& b);

}  // namespace aerostat::world

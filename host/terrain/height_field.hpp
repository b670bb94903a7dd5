#pragma once

#include <memory>
#include <optional>

#include "core/math.hpp"
#include "scene/land.hpp"
#include "terrain/carving.hpp"
#include "terrain/points.hpp"
#include "terrain/relief_cache.hpp"

namespace aerostat::terrain {

/// The ground as a function: one height for every point of the plane. Copies share their data, and
/// every call is safe from any thread. The sea is not part of it: heights go on under water. Nor is
/// the scree of terrain_mesh.hpp, which raises the ground at the feet of walls.
class HeightField {
 public:
  /// Prepares the relief, which takes some tenths of a second for carved kinds and a sixth of that
  /// if it is coarse.
  explicit HeightField(const scene::Terrain& terrain, Carving carving = Carving::fine);

  /// Takes the relief from a cache, or prepares it and leaves it there.
  HeightField(const scene::Terrain& terrain, Carving carving, ReliefCache& cache);

  /// Height above sea level in metres, without detail below `spacing`.
  double height(double x, double z, double spacing = 0.0) const;

  /// Unit normal of the ground, from central differences at +-spacing metres.
  vec3 normal(double x, double z, double spacing) const;

  /// Heights of many points; `points` holds world coordinates less Terrain::center, and detail
  /// below each point's spacing is left out. The same bits as one by one.
  void heights(const Points& points, Block& height) const;

  /// Returns whether there are lakes or rivers.
  bool has_water() const;

  /// Heights above sea level of the surfaces of the nearest lakes and rivers, NaN where none is
  /// near. There is water where the ground is lower.
  void water_levels(const Points& points, Block& level) const;

  /// Returns the height of the surface of a lake or river at a place, or nothing on dry land.
  std::optional<double> water_level(double x, double z, double spacing = 0.0) const;

 private:
  Points point_at(double x, double z, double spacing) const;

  std::shared_ptr<const Relief> relief_;
  dvec2 center_;
  float base_m_;
};

}  // namespace aerostat::terrain

#pragma once

#include <algorithm>
#include <limits>
#include <memory>

#include "land/cover.hpp"
#include "points.hpp"
#include "scene/land.hpp"
#include "terrain/carving.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::terrain {

/// The shape of one kind of ground, as a function of the point. It does not change once it is
/// built.
class Relief {
 public:
  virtual ~Relief() = default;

  /// Computes heights in metres, without Terrain::base_m. They are smooth enough for each point's
  /// spacing.
  virtual void heights(const Points& points, Block& height) const = 0;

  /// Returns whether there are lakes or rivers.
  virtual bool has_water() const { return false; }

  /// Computes the heights of the surfaces of the nearest lakes and rivers in metres, without
  /// Terrain::base_m. They are NaN where none is near. The ground is lower than they are where
  /// there is water, and higher around.
  virtual void water_levels(const Points& points, Block& level) const {
    std::fill_n(level.begin(), points.count, std::numeric_limits<float>::quiet_NaN());
  }
};

/// Makes an alpine relief of valleys that join and ridges with side ridges. A broad valley passes
/// through the centre.
std::unique_ptr<Relief> make_mountains(const scene::Terrain& terrain, Carving carving);

/// Makes a mountainous tropical island in a sea of level 0, with a bay and a beach near the
/// centre.
std::unique_ptr<Relief> make_island(const scene::Terrain& terrain, Carving carving);

/// Makes a sea of transverse dunes with rocky table hills far out.
std::unique_ptr<Relief> make_dunes(const scene::Terrain& terrain);

/// Makes the ground of elevation data, with relief added below its resolution. `cover` is its land
/// cover, whose water becomes lakes and rivers, or null.
std::unique_ptr<Relief> make_real_land(const scene::Terrain& terrain,
                                       std::shared_ptr<const land::Land> files,
                                       const land::Cover* cover);

}  // namespace aerostat::terrain

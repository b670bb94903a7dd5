#pragma once

#include <memory>

#include "points.hpp"
#include "scene/scene.hpp"
#include "terrain/carving.hpp"

namespace aerostat::terrain {

/// The shape of one kind of ground, as a function of the point. Immutable once built.
class Relief {
 public:
  virtual ~Relief() = default;

  /// Heights in metres (without Terrain::base_m), smooth enough for each point's spacing.
  virtual void heights(const Points& points, Block& height) const = 0;
};

/// Alpine relief: valleys that join, ridges with side ridges; a broad valley through the centre.
std::unique_ptr<Relief> make_mountains(const scene::Terrain& terrain, Carving carving);

/// A mountainous tropical island in a sea of level 0; a bay with a beach near the centre.
std::unique_ptr<Relief> make_island(const scene::Terrain& terrain, Carving carving);

/// A sea of transverse dunes with rocky table hills far out.
std::unique_ptr<Relief> make_dunes(const scene::Terrain& terrain);

}  // namespace aerostat::terrain

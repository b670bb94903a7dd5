#pragma once

#include "pack/pack_scene.hpp"
#include "scene/io.hpp"
#include "shading_scene.hpp"
#include "support/resolved.hpp"

namespace aerostat::test {

/// Returns the usual clouds of the tropics, over this share of the sky, under a sun straight above.
inline pack::PackedScene broken_clouds(double cover) {
  scene::Scene scene = scene::defaults(scene::BiomeKind::tropical, scene::View::outside);
  scene.sun.direction = {0.0, 1.0, 0.0};
  scene.sky.cumulus.cover = cover;
  return pack::pack_scene(resolved(scene));
}

}  // namespace aerostat::test

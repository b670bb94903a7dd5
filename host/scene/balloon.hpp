#pragma once

#include <vector>

#include "core/math.hpp"
#include "scene/height_reference.hpp"

/// A balloon of a scene.
namespace aerostat::scene {

enum class Pattern { stripes, chevrons, spiral, rainbow, checker };
/// Sets of fabrics that go together. palettes.hpp gives their colours.
enum class Palette { ember, lagoon, spectrum, glacier, orchard, plum, regatta, meadow };

struct Balloon {
  bool enabled = true;
  dvec3 position{0.0, 0.0, 0.0};  // centre of the basket's floor
  HeightReference height_above = HeightReference::ground;
  double diameter_m = 18.8;
  double heading_deg = 0.0;
  int gores = 24;
  double burner = 1.0;  // strength of the burners, 0 (no flame) to 1
  Pattern pattern = Pattern::stripes;
  Palette palette = Palette::ember;
  std::vector<vec3> colors;  // at least one; the pattern repeats them; default: the palette's

  bool operator==(const Balloon&) const = default;
};

}  // namespace aerostat::scene

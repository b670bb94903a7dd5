#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/math.hpp"
#include "scene/artwork.hpp"
#include "scene/geo_point.hpp"
#include "scene/height_reference.hpp"

/// A balloon of a scene.
namespace aerostat::scene {

enum class Pattern { stripes, chevrons, spiral, rainbow, checker };
/// Sets of fabrics that go together. palettes.hpp gives their colours.
enum class Palette { ember, lagoon, spectrum, glacier, orchard, plum, regatta, meadow };

/// The most balloons beside the scene's own, listed or made by a festival.
inline constexpr int kMostFurtherBalloons = 32;

/// Further balloons that are made from a seed. world::resolve turns them into a list.
struct Festival {
  int count = 0;
  std::uint32_t seed = 1;
  dvec2 center{0.0, 0.0};        // x and z of the middle
  dvec2 spread_m{300.0, 300.0};  // half of the area's width along x and z
  double lowest_m = 10.0;        // heights of the baskets above the ground
  double highest_m = 200.0;
  double apart_m = 34.0;  // least distance between balloons
  double burner = 1.0;    // greatest strength of the burners

  bool operator==(const Festival&) const = default;
};

struct Balloon {
  bool enabled = true;
  dvec3 position{0.0, 0.0, 0.0};  // centre of the basket's floor
  HeightReference height_above = HeightReference::ground;
  std::optional<GeoPoint> at;        // in place of position
  std::optional<FlightTrack> track;  // in place of both
  double diameter_m = 18.8;
  double heading_deg = 0.0;
  int gores = 24;
  double burner = 1.0;  // strength of the burners, 0 (no flame) to 1
  Pattern pattern = Pattern::stripes;
  Palette palette = Palette::ember;
  std::vector<vec3> colors;        // at least one; the pattern repeats them; default: the palette's
  std::vector<Artwork> artwork{};  // pictures on the envelope, the later ones over the former
  std::optional<EnvelopeModel> envelope{};  // a special shape, in place of the usual one
  int passengers = 0;                       // people in the basket

  bool operator==(const Balloon&) const = default;
};

}  // namespace aerostat::scene

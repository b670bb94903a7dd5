#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/land_cover.hpp"
#include "core/math.hpp"
#include "scene/geo_point.hpp"
#include "scene/height_reference.hpp"
#include "scene/up_axis.hpp"

/// Models from files that stand in a scene.
namespace aerostat::scene {

/// The most models that a scene can place.
inline constexpr int kMostObjects = 1000;

/// The most instances of one entry of a scene's models.
inline constexpr int kMostInstances = 1'000'000;

/// Where the instances of a model may stand.
enum class PlacedOn { land, water, anywhere };

/// The area over which the instances of a model are strewn, and the rules by which they stand.
struct PlacedArea {
  dvec2 size_m{400.0, 400.0};  // width along x and z; the model's position is the middle
  std::uint32_t seed = 1;
  PlacedOn on = PlacedOn::land;
  dvec2 slope_deg{0.0, 90.0};
  dvec2 heights_m{-12000.0, 12000.0};  // of the ground above the sea
  std::vector<CoverClass> cover{};     // the land cover on which they stand; empty: on any
  double apart_m = 0.0;                // least distance between two instances
  dvec2 sizes{1.0, 1.0};               // least and greatest factor on the size
  bool turned = true;                  // each has a heading of its own

  bool operator==(const PlacedArea&) const = default;
};

/// A model from a file that stands in the landscape.
struct PlacedModel {
  std::string file;
  dvec3 position{0.0};  // of its foot: the lowest point, in the middle of its box
  HeightReference height_above = HeightReference::ground;
  std::optional<GeoPoint> at;      // in place of position
  double heading_deg = 0.0;        // clockwise as seen from above
  double scale = 1.0;              // metres for each unit of the file
  std::optional<double> height_m;  // of the model, wins over scale
  UpAxis up = UpAxis::y;
  int count = 1;                     // of instances; more than one are strewn over the area
  std::optional<PlacedArea> area{};  // default: that of PlacedArea

  bool operator==(const PlacedModel&) const = default;
};

}  // namespace aerostat::scene

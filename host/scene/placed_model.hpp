#pragma once

#include <optional>
#include <string>

#include "core/math.hpp"
#include "scene/geo_point.hpp"
#include "scene/height_reference.hpp"

/// Models from files that stand in a scene.
namespace aerostat::scene {

/// The axis of a file that points up.
enum class UpAxis { y, z };

/// The most models that a scene can place.
inline constexpr int kMostObjects = 1000;

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

  bool operator==(const PlacedModel&) const = default;
};

}  // namespace aerostat::scene

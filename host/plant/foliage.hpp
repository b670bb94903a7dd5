#pragma once

#include <functional>
#include <span>

#include "mesh/mesh.hpp"

/// Builds the parts of plants: leaves, wood and the dark inside of a crown. Each function appends
/// triangles to a mesh that has colours.
namespace aerostat::plant {

/// The shade of a place in a crown that is lit as a whole.
struct Shade {
  /// The unit vector away from the crown's middle.
  dvec3 outward{0.0, 1.0, 0.0};
  /// The baked occlusion, which is 1 outside the crown and less inside.
  double light = 1.0;
};

/// The crown that leaves belong to. Vertex normals bend towards `outward`, so that a crown of many
/// flat leaves is shaded like one soft body.
using Crown = std::function<Shade(const dvec3& position)>;

/// Returns an ellipsoid as a crown. Its normals point outwards from the centre. Its light is `dark`
/// in the middle and 1 at the surface, and somewhat less below than above.
Crown ellipsoid_crown(const dvec3& center, const dvec3& radii, double dark);

/// Returns a crown that lights everything in the same way, with `outward` up.
Crown open_crown();

/// A leaf, a leaflet or a spray of needles. It is a kite of two triangles that is folded along its
/// spine.
struct Leaf {
  dvec3 base{0.0};
  dvec3 tip{0.0};
  /// The vector from the spine to the right edge, which is half the width.
  dvec3 across{0.0};
  /// The widest place of the leaf, from 0 at the base to 1 at the tip.
  double belly = 0.4;
  /// The distance of the edges below the spine, in half widths.
  double fold = 0.0;
  /// The linear albedo before the shade of the crown.
  vec3 color{0.1f};
  /// The brightness of the tip divided by that of the base.
  double tip_gain = 1.0;
};
void add_leaf(mesh::TriangleMesh& mesh, const Leaf& leaf, const Crown& crown);

/// Adds a blade along a path of at least two points. It is a flat strip that narrows to a point.
/// `across` is half the width at the foot. The brightness grows by the factor `tip_gain` towards
/// the tip.
void add_blade(mesh::TriangleMesh& mesh, std::span<const dvec3> path, const dvec3& across,
               const vec3& color, double tip_gain, const Crown& crown);

/// Adds a branch or trunk along a path. Its radius is `radius_from` at the foot and `radius_to` at
/// the end.
void add_wood(mesh::TriangleMesh& mesh, std::span<const dvec3> path, double radius_from,
              double radius_to, int sides, const vec3& color);

/// Adds a closed octahedron, turned by `yaw`, that stands for the inside of a mass of leaves and
/// keeps the light out.
void add_core(mesh::TriangleMesh& mesh, const dvec3& center, const dvec3& radii, const vec3& color,
              double yaw, const Crown& crown);

/// Returns the level unit vector at an angle in radians about the vertical.
dvec3 level_direction(double angle);

/// Two unit vectors at right angles to a unit vector and to each other.
struct Across {
  dvec3 right, up;
};
Across across(const dvec3& axis);

}  // namespace aerostat::plant

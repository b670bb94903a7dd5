#pragma once

#include <functional>
#include <span>

#include "mesh/mesh.hpp"

/// What plants are made of: leaves, wood and the dark inside of a crown. Each function appends
/// triangles to a mesh that has colours.
namespace aerostat::plant {

/// How a place in a crown is lit as a whole.
struct Shade {
  dvec3 outward{0.0, 1.0, 0.0};  // unit, away from the crown's middle
  double light = 1.0;            // baked occlusion, 1 outside, less within
};

/// The crown that leaves belong to. Vertex normals bend towards `outward`, so that a crown of many
/// flat leaves is shaded as one soft body.
using Crown = std::function<Shade(const dvec3& position)>;

/// An ellipsoid: outwards from its centre, `dark` in the middle, 1 at its surface, somewhat darker
/// below than above.
Crown ellipsoid_crown(const dvec3& center, const dvec3& radii, double dark);

/// A crown that lights everything the same way: `outward` up.
Crown open_crown();

/// A leaf, a spray of needles or a leaflet: a kite of two triangles that is folded along its spine.
struct Leaf {
  dvec3 base{0.0};
  dvec3 tip{0.0};
  dvec3 across{0.0};      // from the spine to the right edge: half the width
  double belly = 0.4;     // where the leaf is widest, 0 at the base, 1 at the tip
  double fold = 0.0;      // the edges lie so far below the spine, in half widths
  vec3 color{0.1f};       // linear albedo, before the crown's shade
  double tip_gain = 1.0;  // brightness of the tip against the base
};
void add_leaf(mesh::TriangleMesh& mesh, const Leaf& leaf, const Crown& crown);

/// A blade along a path of at least two points: a flat strip that narrows to a point. `across` is
/// half the width at the foot; brightness grows by `tip_gain` towards the tip.
void add_blade(mesh::TriangleMesh& mesh, std::span<const dvec3> path, const dvec3& across,
               const vec3& color, double tip_gain, const Crown& crown);

/// A branch or trunk along a path, `radius_from` at its foot, `radius_to` at its end.
void add_wood(mesh::TriangleMesh& mesh, std::span<const dvec3> path, double radius_from,
              double radius_to, int sides, const vec3& color);

/// A closed octahedron, turned by `yaw`, that stands for the inside of a mass of leaves: it keeps
/// the light out.
void add_core(mesh::TriangleMesh& mesh, const dvec3& center, const dvec3& radii, const vec3& color,
              double yaw, const Crown& crown);

/// Level unit vector at an angle about the vertical.
dvec3 level_direction(double angle);

/// Two unit vectors across a unit vector and each other.
struct Across {
  dvec3 right, up;
};
Across across(const dvec3& axis);

}  // namespace aerostat::plant

#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/outline.hpp"

namespace aerostat::model {

/// Adds a closed wall of woven willow along `middle` from y = `bottom` to `top`. Both faces show
/// weavers that pass alternately over and under the stakes. Each rod of willow has its own tint and
/// is darker where it meets its neighbours. Without the relief the faces lie `half_thickness` from
/// the middle. The relief adds up to weave_relief(). If `tolerance_m` is larger than the relief,
/// the faces are plain and have the mean colour.
void add_woven_wall(mesh::TriangleMesh& mesh, const Outline& middle, double bottom, double top,
                    double half_thickness, double tolerance_m);
double weave_relief();

/// Adds a rope of two strands along the outline of `path` at height y, moved outwards by `offset`.
void add_rope_band(mesh::TriangleMesh& mesh, const Outline& path, double offset, double height,
                   double radius, double tolerance_m);

}  // namespace aerostat::model

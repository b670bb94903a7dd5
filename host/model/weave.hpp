#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/outline.hpp"

namespace aerostat::model {

/// A closed wall of woven willow along `middle`, from y = `bottom` to `top`: both faces show
/// weavers that pass alternately over and under the stakes, each length of willow with its own tint
/// and darker where it meets its neighbours. Without the relief the faces lie `half_thickness` from
/// the middle; the relief adds up to weave_relief(). Where `tolerance_m` swallows the relief the
/// faces are plain and have the mean colour.
void add_woven_wall(mesh::TriangleMesh& mesh, const Outline& middle, double bottom, double top,
                    double half_thickness, double tolerance_m);
double weave_relief();

/// A rope of two strands laid along the outline of `path` at height y, moved out by `offset`.
void add_rope_band(mesh::TriangleMesh& mesh, const Outline& path, double offset, double height,
                   double radius, double tolerance_m);

}  // namespace aerostat::model

#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/outline.hpp"

namespace aerostat::model {

/// Builds the padded leather rim. It is a closed tube along `middle` at y = `height`, sewn together
/// from pieces of leather that each have their own tint, with two rows of stitches. The uvs are
/// metres along the rim and around it.
mesh::TriangleMesh build_rim(const Outline& middle, double height, const Detail& detail = {});

/// Returns half the width and half the height of the rim in metres.
dvec2 rim_half_size();

}  // namespace aerostat::model

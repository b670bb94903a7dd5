#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/outline.hpp"

namespace aerostat::model {

/// The padded leather rim: a closed tube along `middle` at y = `height`, sewn together from lengths
/// of leather of their own tint, with two rows of stitches. Places
/// are metres along the rim and around it.
mesh::TriangleMesh build_rim(const Outline& middle, double height, const Detail& detail = {});

/// Half its width and height.
dvec2 rim_half_size();

}  // namespace aerostat::model

#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/envelope_pattern.hpp"
#include "model/envelope_shape.hpp"

namespace aerostat::model {

/// Builds the fabric of the envelope, the parachute disc and the plate of the crown as one sheet,
/// with y = 0 at the mouth. Every edge is shared by two triangles (by position), except the edges
/// of the mouth. Every triangle has one colour. The uv of a vertex is the pair (gores around from
/// the first tape, panels up from the mouth). The disc counts as one more panel and the plate as
/// the next. Load tapes and seams are drawn where u and v pass whole numbers, when the fabric is
/// shaded.
mesh::TriangleMesh build_envelope(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                                  const Detail& detail = {});

/// Builds the scoop of heat-proof cloth below the mouth. It is a sheet that begins on the circle of
/// the mouth and ends `depth` below it in a hem of `lower_radius`, with y = 0 at the mouth. The uvs
/// of its vertices go on from those of the envelope, and v runs from 0.5 at the hem to 1 at the
/// mouth.
mesh::TriangleMesh build_skirt(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                               double lower_radius, double depth, const Detail& detail = {});

}  // namespace aerostat::model

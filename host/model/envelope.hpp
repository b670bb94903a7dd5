#pragma once

#include "mesh/mesh.hpp"
#include "model/envelope_pattern.hpp"
#include "model/envelope_shape.hpp"

namespace aerostat::model {

/// The envelope's fabric, load tapes, seams, parachute disc and crown plate as one sheet, y = 0 at
/// the mouth: every edge is shared by two triangles (by position) but those of the mouth. Every
/// triangle has one colour.
mesh::TriangleMesh build_envelope(const EnvelopeShape& shape, const EnvelopePattern& pattern);

/// The scoop of heat-proof cloth below the mouth, a sheet that begins on the mouth's circle and
/// ends in a hem of `lower_radius`, `depth` below. y = 0 at the mouth.
mesh::TriangleMesh build_skirt(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                               double lower_radius, double depth);

}  // namespace aerostat::model

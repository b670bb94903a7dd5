#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/envelope_pattern.hpp"
#include "model/envelope_shape.hpp"

namespace aerostat::model {

/// The envelope's fabric with the parachute disc and the crown's plate as one sheet, y = 0 at the
/// mouth: every edge is shared by two triangles (by position) but those of the mouth. Every
/// triangle has one colour. A vertex's place is (gores around from the first tape, panels up from
/// the mouth; the disc is one more, the plate the next): load tapes and seams, where it passes
/// whole numbers, are laid over the fabric when it is shaded.
mesh::TriangleMesh build_envelope(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                                  const Detail& detail = {});

/// The scoop of heat-proof cloth below the mouth, a sheet that begins on the mouth's circle and
/// ends in a hem of `lower_radius`, `depth` below. y = 0 at the mouth. Places as the envelope's,
/// from 0.5 at the hem to 1 at the mouth.
mesh::TriangleMesh build_skirt(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                               double lower_radius, double depth, const Detail& detail = {});

}  // namespace aerostat::model

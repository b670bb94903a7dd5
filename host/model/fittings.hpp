#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/envelope_pattern.hpp"
#include "model/envelope_shape.hpp"

/// Small things that hang on the balloon.
namespace aerostat::model {

/// Two turning vents, slits up the middle of gores across from each other, closed by dark flaps on
/// both sides of the fabric. y = 0 at the mouth. None where they are too thin to be seen.
void add_vents(mesh::TriangleMesh& mesh, const EnvelopeShape& shape, const EnvelopePattern& pattern,
               const Detail& detail);

/// The parachute's lines inside the envelope, from the disc's rim to their knot and down to the
/// burners. y = 0 at the mouth, whose height above the basket's floor is `mouth_height_m`.
void add_valve_lines(mesh::TriangleMesh& mesh, const EnvelopeShape& shape, double mouth_height_m,
                     const Detail& detail);

/// Ballast in canvas bags on the outer side of the basket.
void add_sandbags(mesh::TriangleMesh& mesh, const Detail& detail);

/// What is sewn of padded cloth: a pouch on the inner side of the wall and one for the instruments.
void add_pouches(mesh::TriangleMesh& mesh, const Detail& detail);

}  // namespace aerostat::model

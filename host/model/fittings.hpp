#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/envelope_pattern.hpp"
#include "model/envelope_shape.hpp"

/// Builds small things that hang on the balloon.
namespace aerostat::model {

/// Adds two turning vents with y = 0 at the mouth. They are slits up the middle of gores on
/// opposite sides, closed by dark flaps on both sides of the fabric. Adds nothing if they are too
/// thin to be seen.
void add_vents(mesh::TriangleMesh& mesh, const EnvelopeShape& shape, const EnvelopePattern& pattern,
               const Detail& detail);

/// Adds the lines of the parachute inside the envelope, which run from the disc's rim to a knot and
/// on down to the burners. y = 0 at the mouth, whose height above the basket's floor is
/// `mouth_height_m`.
void add_valve_lines(mesh::TriangleMesh& mesh, const EnvelopeShape& shape, double mouth_height_m,
                     const Detail& detail);

/// Adds ballast in canvas bags on the outer side of the basket.
void add_sandbags(mesh::TriangleMesh& mesh, const Detail& detail);

/// Adds the sewn and padded pouches: one on the inner side of the wall and one for the instruments.
void add_pouches(mesh::TriangleMesh& mesh, const Detail& detail);

}  // namespace aerostat::model

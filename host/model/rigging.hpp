#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/envelope_shape.hpp"

namespace aerostat::model {

/// A straight wire between two points of the rig. Lengths are in metres.
struct Wire {
  dvec3 from{0.0};
  dvec3 to{0.0};
  double radius = 0.0;
};

/// Returns the height of the envelope's mouth above the basket's floor, in metres.
double mouth_height(double diameter_m);

/// Returns the wires from the corners of the burner frame to the load tapes at the mouth, one for
/// each tape.
std::vector<Wire> flying_wires(const EnvelopeShape& shape);

/// Returns the pairs of wires from the corners of the frame down into the rim of the basket.
std::vector<Wire> basket_wires();

/// Returns the largest radius at height y that stays clear of the wires.
double clear_radius(const std::vector<Wire>& wires, double y);

/// Builds all wires, the ring in which they meet at the mouth, and the lines of the parachute.
mesh::TriangleMesh build_cables(const EnvelopeShape& shape, const Detail& detail = {});

/// Builds everything that is padded with cloth: the sleeves of the uprights, the jackets of the
/// cylinders, and the pouches.
mesh::TriangleMesh build_padding(const Detail& detail = {});

/// Builds the frame of the burners with its four uprights, the burners, the gas cylinders and the
/// hoses.
mesh::TriangleMesh build_frame(const Detail& detail = {});

}  // namespace aerostat::model

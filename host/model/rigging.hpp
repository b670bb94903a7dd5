#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "model/envelope_shape.hpp"

namespace aerostat::model {

/// A straight wire between two points of the rig.
struct Wire {
  dvec3 from{0.0};
  dvec3 to{0.0};
  double radius = 0.0;
};

/// Height of the envelope's mouth above the basket's floor.
double mouth_height(double diameter_m);

/// The wires from the burner frame's corners to the load tapes at the mouth, one for each.
std::vector<Wire> flying_wires(const EnvelopeShape& shape);

/// The pairs of wires from the frame's corners down into the basket's rim.
std::vector<Wire> basket_wires();

/// The largest radius at height y that stays clear of the wires.
double clear_radius(const std::vector<Wire>& wires, double y);

/// All wires, with the ring that they meet at the mouth, and the parachute's lines.
mesh::TriangleMesh build_cables(const EnvelopeShape& shape, const Detail& detail = {});

/// What is padded with cloth: the sleeves of the uprights, the cylinders' jackets, the pouches.
mesh::TriangleMesh build_padding(const Detail& detail = {});

/// The burner's frame with its four uprights, the burners, the gas cylinders and the hoses.
mesh::TriangleMesh build_frame(const Detail& detail = {});

}  // namespace aerostat::model

#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"

namespace aerostat::model {

/// Adds two burners side by side on the cross tubes of the frame, with valve blocks, cans, coils
/// and levers.
void add_burners(mesh::TriangleMesh& mesh, const Detail& detail);

/// Returns the distance of the frame's cross tubes from the middle, in metres.
double burner_mount_z();

/// Returns the point at which the hose of the right burner's rear side arrives. The points of the
/// other hoses are its mirror images.
dvec3 burner_port();

/// Adds the steel and brass of a gas cylinder that stands on `foot`. `add_jacket` adds the jacket
/// of padded cloth that covers it up to its shoulder.
void add_cylinder(mesh::TriangleMesh& mesh, const dvec3& foot, const Detail& detail);
void add_jacket(mesh::TriangleMesh& mesh, const dvec3& foot, const Detail& detail);

/// Returns the height of the middle of the flames above the basket's floor, in metres.
double flame_height();

/// Builds the flames of both burners. They are higher the harder the burners fire (0 < burner <=
/// 1).
mesh::TriangleMesh build_flame(double burner, const Detail& detail = {});

}  // namespace aerostat::model

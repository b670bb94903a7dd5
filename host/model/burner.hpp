#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"

namespace aerostat::model {

/// Two burners side by side on the frame's cross tubes: valve block, can, coil and levers.
void add_burners(mesh::TriangleMesh& mesh, const Detail& detail);

/// Distance of the frame's cross tubes from the middle.
double burner_mount_z();

/// Where the hose of the right burner's rear side arrives; the others mirror it.
dvec3 burner_port();

/// A gas cylinder that stands on `foot`: what is steel and brass, and the jacket of padded cloth
/// that covers it up to its shoulder.
void add_cylinder(mesh::TriangleMesh& mesh, const dvec3& foot, const Detail& detail);
void add_jacket(mesh::TriangleMesh& mesh, const dvec3& foot, const Detail& detail);

/// Height of the middle of the flames.
double flame_height();

/// The flames of both burners, the higher the harder these fire (0 < burner <= 1).
mesh::TriangleMesh build_flame(double burner, const Detail& detail = {});

}  // namespace aerostat::model

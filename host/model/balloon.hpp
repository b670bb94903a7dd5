#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "scene/scene.hpp"

/// Models: functions that return meshes.
namespace aerostat::model {

/// One object of a model. Vertex colours are its albedo; the scene's material multiplies them.
struct Part {
  scene::ObjectId id = scene::ObjectId::envelope;
  mesh::TriangleMesh mesh;
};

/// A hot-air balloon in world coordinates, one part each of envelope, skirt, basket, rim (with all
/// that is padded), frame (uprights, burners, gas cylinders), cables, floor and, if the burners
/// fire, flame. `balloon.position` is the middle of the basket's floor. The passengers look to
/// `heading_deg`: 0 is -z, 90 is +x; their side rails run that way for 1.5 m, 1.2 m apart. The
/// basket keeps its size, the envelope has the diameter. Throws Error{bad_data} unless diameter_m >
/// 0, gores >= 3 and there is a colour.
std::vector<Part> balloon(const scene::Balloon& balloon, const Detail& detail = {});

/// The eye of a passenger in world coordinates: 1.62 m above the floor, in the middle between left
/// and right, 0.25 m behind the middle, so that the rim ahead, the two front uprights and their
/// wires are in view. `basket_forward` is the level, unit direction of the heading.
dvec3 basket_eye(const scene::Balloon& balloon);
dvec3 basket_forward(const scene::Balloon& balloon);

/// Where the burners' light comes from, in world coordinates.
dvec3 flame_middle(const scene::Balloon& balloon);

/// From the basket's floor to the crown.
double balloon_height(const scene::Balloon& balloon);

}  // namespace aerostat::model

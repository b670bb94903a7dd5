#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "model/detail.hpp"
#include "scene/balloon.hpp"
#include "scene/objects.hpp"

/// Builds models as functions that return meshes.
namespace aerostat::model {

/// One object of a model. Its vertex colours are its albedo, which the scene's material multiplies.
struct Part {
  scene::ObjectId id = scene::ObjectId::envelope;
  scene::MaterialId material = scene::MaterialId::envelope;
  mesh::TriangleMesh mesh;
};

/// Builds a hot-air balloon in world coordinates. Its parts are the envelope, skirt, basket, rim
/// (with everything that is padded), frame (uprights, burners, gas cylinders), cables, floor and,
/// if the burners fire, flame. `balloon.position` is the middle of the basket's floor. The
/// passengers look to `heading_deg`: 0 is -z, 90 is +x. The side rails of the basket run in this
/// direction for 1.5 m, 1.2 m apart. The basket always has the same size, and the envelope has the
/// diameter of the scene. Throws Error{bad_data} unless diameter_m > 0, gores >= 3 and there is a
/// colour.
std::vector<Part> balloon(const scene::Balloon& balloon, const Detail& detail = {});

/// Returns the eye of a passenger in world coordinates: 1.62 m above the floor, in the middle
/// between left and right, and 0.25 m behind the middle of the basket. From there the rim ahead,
/// the two front uprights and their wires are in view. `basket_forward` returns the level unit
/// vector of the heading.
dvec3 basket_eye(const scene::Balloon& balloon);
dvec3 basket_forward(const scene::Balloon& balloon);

/// Returns the point in world coordinates from which the light of the burners comes.
dvec3 flame_middle(const scene::Balloon& balloon);

/// Returns the height from the basket's floor to the crown in metres.
double balloon_height(const scene::Balloon& balloon);

}  // namespace aerostat::model

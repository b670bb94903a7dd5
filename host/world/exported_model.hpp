#pragma once

#include <cstdint>
#include <span>

#include "asset/model.hpp"
#include "scene/resolved_scene.hpp"
#include "world/world.hpp"

namespace aerostat::world {

/// Returns the number of triangles that exported_model() would hold, with those of instances once
/// for each model.
std::uint64_t count_model_triangles(const World& world, Placed instances = Placed::left_out);

/// Returns a world as a model in which instances share their meshes. Materials of models from files
/// are as they were read, with their textures. Those of the scene have the colours of plain
/// surfaces and a roughness whose lobe is as wide as Phong's. Instances have the colours of their
/// models without the tints of single plants. `cloths` has a texture for each of
/// scene::balloons_of(), laid out as pack::dyed_cloths() says: an envelope whose texture has a size
/// shows it in place of the colours of its vertices. Without textures, none does. Positions count
/// from the scene's origin, which the model names.
asset::Model exported_model(const World& world, Placed instances = Placed::left_out,
                            std::span<const asset::Texture> cloths = {});

}  // namespace aerostat::world

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "asset/model.hpp"

namespace aerostat::asset {

/// The two parts of a glTF 2.0 file: its JSON and the bytes of its buffer.
struct GltfParts {
  std::string json;
  std::vector<std::uint8_t> binary;
};

/// Returns a model as glTF 2.0. Each mesh is written once, and each placement is a node that names
/// it; all are children of a node whose translation is the model's origin. Textures are PNG files
/// in the buffer. `binary_name` is the name of the file with the buffer relative to that of the
/// JSON, or empty if both are in one file (GLB). Throws Error{exhausted} if the buffer would have 4
/// GiB or more, which the format cannot hold.
GltfParts gltf_parts(const Model& model, const std::string& binary_name);

/// Returns the bytes of a GLB file, otherwise as gltf_parts().
std::vector<std::uint8_t> glb_bytes(const Model& model);

}  // namespace aerostat::asset

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aerostat::test {

/// The readers of models by the names of their folders of seeds: "gltf", "obj", "mtl", "ply",
/// "stl".
const std::vector<std::string>& model_readers();

/// Takes any bytes for a file of one of the readers. Returns a description of a fault, or an empty
/// string if everything was as promised. `is_read` becomes whether the bytes were such a file.
std::string fault_of_model(const std::string& reader, std::string_view bytes, bool& is_read);

}  // namespace aerostat::test

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "asset/model.hpp"

namespace aerostat::asset {

/// A texture as an MTL file names it. At texture coordinates uv, it shows the
/// texel at `uv * scale + offset`.
struct MtlMap {
  std::string file;
  glm::vec2 scale{1.0f}, offset{0.0f};
  bool clamp = false;
  float strength = 1.0f;  // of bumps
};

/// A material of an MTL file and the textures that it names.
struct MtlMaterial {
  Material material;
  std::optional<MtlMap> color, emission, normal, opacity;
};

/// Reads the materials of an MTL file. Colours are taken as sRGB. Lines that mean nothing here are
/// passed over, and maps that are not used are told in `notes`. Throws Error{bad_data} with the
/// line, also if there are more than `most` materials.
std::vector<MtlMaterial> read_mtl(std::string_view text, std::size_t most,
                                  std::vector<std::string>& notes);

}  // namespace aerostat::asset

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "asset/gltf_buffers.hpp"
#include "asset/json_value.hpp"
#include "asset/reading.hpp"

namespace aerostat::asset {

/// The texture coordinates that a material asks for: `matrix * (u, v, 1)` of one of the sets.
struct GltfUv {
  std::size_t set = 0;  // the number behind TEXCOORD_
  glm::dmat3 matrix{1.0};

  bool operator==(const GltfUv&) const = default;
};

/// Reads the materials of a glTF file into the model, with their textures.
class GltfMaterials {
 public:
  /// Throws Error{bad_data} for what cannot be understood. A texture that cannot be read becomes a
  /// note.
  GltfMaterials(const JsonValue& root, GltfBuffers& buffers, Reading& reading);

  std::size_t size() const { return uv_.size(); }

  /// Returns the texture coordinates of a material, if it has textures.
  const std::optional<GltfUv>& uv(std::size_t material) const { return uv_[material]; }

 private:
  void read_material(const JsonValue& material);
  void read_metallic_roughness(const JsonValue& numbers, Material& result);
  void read_specular_glossiness(const JsonValue& numbers, Material& result);
  void read_extensions(const JsonValue& extensions, Material& result);
  void read_emission(const JsonValue& material, Material& result);
  void read_alpha(const JsonValue& material, Material& result);
  std::optional<TextureUse> use(const JsonValue& info);
  void want_uv(const JsonValue& info);
  TextureUse sampled(const JsonValue& texture) const;
  std::optional<std::size_t> image(std::size_t i);
  void check_images() const;

  JsonValue root_;
  GltfBuffers& buffers_;
  Reading& reading_;
  std::vector<std::optional<GltfUv>> uv_;  // of the materials
  bool uv_differ_ = false;                 // of the textures of the material that is being read
  std::map<std::size_t, std::optional<std::size_t>> images_;  // places in Model::textures
};

}  // namespace aerostat::asset

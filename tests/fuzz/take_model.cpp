#include "take_model.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "asset/mtl.hpp"
#include "asset/read.hpp"
#include "core/error.hpp"
#include "track/text.hpp"

namespace aerostat::test {

namespace {

using asset::Material;
using asset::Model;
using asset::Primitive;

/// Limits that damaged files reach in a moment.
constexpr asset::Limits kLimits{.file_bytes = 1 << 20,
                                .vertices = 100'000,
                                .triangles = 100'000,
                                .texture_side = 256,
                                .texture_bytes = 1 << 20,
                                .nodes = 1000,
                                .node_depth = 50,
                                .placements = 1000,
                                .materials = 100};

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string fault_of_primitive(const Primitive& primitive, const Model& model) {
  const std::size_t count = primitive.positions.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == count; };
  if (!fits(primitive.normals.size()) || !fits(primitive.uv.size()) ||
      !fits(primitive.colors.size())) {
    return "attributes of another length";
  }
  if (primitive.material >= model.materials.size()) return "a material that is not there";
  if (primitive.triangles.empty()) return "no triangles";
  for (const auto& triangle : primitive.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= count) return "a corner that is not there";
    }
  }
  for (const glm::vec3& position : primitive.positions) {
    if (!is_finite(position)) return "a position that is not finite";
  }
  for (const glm::vec3& normal : primitive.normals) {
    if (!(std::abs(glm::length(normal) - 1.0f) < 1e-4f)) return "a normal of another length";
  }
  for (const glm::vec2& uv : primitive.uv) {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return "uv that are not finite";
  }
  for (const glm::vec4& color : primitive.colors) {
    if (!is_finite(glm::vec3(color)) || !(color.a >= 0.0f)) return "a colour that is no colour";
  }
  return "";
}

std::string fault_of_material(const Material& material, std::size_t textures) {
  for (const auto& use : {material.base_color_texture, material.metallic_roughness_texture,
                          material.normal_texture, material.emission_texture}) {
    if (use && use->texture >= textures) return "a texture that is not there";
  }
  const auto is_share = [](float value) { return value >= 0.0f && value <= 1.0f; };
  const glm::vec4& color = material.base_color;
  const bool is_good = is_share(color.r) && is_share(color.g) && is_share(color.b) &&
                       is_share(color.a) && is_share(material.metallic) &&
                       is_share(material.roughness) && is_share(material.transmission) &&
                       is_finite(material.emission) && std::isfinite(material.normal_scale) &&
                       material.alpha_cutoff >= 0.0f;
  return is_good ? "" : "a material out of its bounds";
}

std::string fault_of_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    if (note.empty() || note.back() != '.' || !track::is_utf8(note)) return "note: " + note;
  }
  return "";
}

std::string fault_of(const Model& model) {
  for (const asset::Mesh& mesh : model.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      const std::string fault = fault_of_primitive(primitive, model);
      if (!fault.empty()) return fault;
    }
  }
  for (const asset::Placement& placement : model.placements) {
    if (placement.mesh >= model.meshes.size()) return "a mesh that is not there";
    if (!(std::abs(glm::determinant(placement.transform)) > 0.0)) return "a transform without size";
  }
  for (const Material& material : model.materials) {
    const std::string fault = fault_of_material(material, model.textures.size());
    if (!fault.empty()) return fault;
  }
  for (const asset::Texture& texture : model.textures) {
    if (texture.rgba.size() != std::size_t{4} * texture.width * texture.height) {
      return "a texture of another size";
    }
  }
  const asset::Bounds box = asset::bounds(model);
  if (box.empty() || asset::placed_triangle_count(model) == 0) return "an empty model";
  return fault_of_notes(model.notes);
}

std::string fault_of_mtl(std::string_view bytes, bool& is_read) {
  std::vector<std::string> notes;
  const auto materials = asset::read_mtl(bytes, kLimits.materials, notes);
  is_read = !materials.empty();
  for (const asset::MtlMaterial& each : materials) {
    const std::string fault = fault_of_material(each.material, 0);
    if (!fault.empty()) return fault;
  }
  return fault_of_notes(notes);
}

std::string fault_of_bytes(const std::string& reader, std::string_view bytes, bool& is_read) {
  if (reader == "mtl") return fault_of_mtl(bytes, is_read);
  asset::ReadOptions options;
  options.limits = kLimits;
  const auto format = asset::format_of("", "fuzz." + reader);
  if (!format) return "no reader " + reader;
  const Model model = asset::read_bytes(bytes, *format, "/nowhere/fuzz", options);
  is_read = true;
  return fault_of(model);
}

}  // namespace

const std::vector<std::string>& model_readers() {
  static const std::vector<std::string> readers = {"gltf", "obj", "mtl", "ply", "stl"};
  return readers;
}

std::string fault_of_model(const std::string& reader, std::string_view bytes, bool& is_read) {
  is_read = false;
  try {
    return fault_of_bytes(reader, bytes, is_read);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) return std::string("another error: ") + error.what();
    return track::is_utf8(error.what()) ? "" : "an error that is not UTF-8";
  } catch (const std::exception& error) {
    return std::string("not an error of aerostat's own: ") + error.what();
  }
}

}  // namespace aerostat::test

#include "asset/gltf_meshes.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "asset/words.hpp"
#include "core/math.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

using glm::vec4;
using Triangle = std::array<std::uint32_t, 3>;

/// The forms in which an attribute may be stored.
struct Allowed {
  std::initializer_list<std::string_view> types;
  bool floats = true;
  bool fractions = true;  // normalized integers
  bool integers = false;  // others
};

bool is_allowed(const GltfAccessor& accessor, const Allowed& allowed) {
  const bool is_type =
      std::find(allowed.types.begin(), allowed.types.end(), accessor.type) != allowed.types.end();
  if (!is_type || accessor.number == GltfNumber::uint32) return false;
  if (accessor.is_of_float()) return allowed.floats;
  return accessor.normalized ? allowed.fractions : allowed.integers;
}

/// Gives the vertices that the triangles use new indices without gaps. Returns the old index of
/// each of them, in ascending order. Many primitives may share one long list of vertices, so the
/// time that this takes depends on the number of triangles and not on the length of the list.
std::vector<std::uint32_t> keep_used(std::vector<Triangle>& triangles, std::size_t vertices) {
  std::vector<std::uint32_t> used;
  if (vertices / 4 <= triangles.size()) {
    std::vector<std::uint8_t> is_used(vertices, 0);
    for (const Triangle& triangle : triangles) {
      for (const std::uint32_t corner : triangle) is_used[corner] = 1;
    }
    for (std::uint32_t i = 0; i < vertices; ++i) {
      if (is_used[i] != 0) used.push_back(i);
    }
    if (used.size() == vertices) return used;
  } else {
    for (const Triangle& triangle : triangles)
      used.insert(used.end(), triangle.begin(), triangle.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
  }
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      const auto found = std::lower_bound(used.begin(), used.end(), corner);
      corner = static_cast<std::uint32_t>(found - used.begin());
    }
  }
  return used;
}

class MeshReader {
 public:
  MeshReader(const JsonValue& root, const GltfAccessors& accessors, const GltfMaterials& materials,
             Reading& reading)
      : root_(root), accessors_(accessors), materials_(materials), reading_(reading) {
    const JsonValue used = root["extensionsUsed"];
    for (std::size_t i = 0; i < used.size(); ++i) {
      is_quantized_ = is_quantized_ || used.at(i).text() == "KHR_mesh_quantization";
    }
  }

  std::vector<GltfMesh> read() {
    const JsonValue meshes = root_["meshes"];
    std::vector<GltfMesh> result;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const JsonValue mesh = meshes.at(i), primitives = mesh["primitives"];
      if (primitives.size() == 0) primitives.fail("at least one primitive");
      result.emplace_back();
      result.back().mesh.name = track::clean_text(mesh["name"].text());
      const JsonValue weights = mesh["weights"];
      for (std::size_t k = 0; k < weights.size(); ++k) {
        is_morphed_ = is_morphed_ || weights.at(k).number(0.0) != 0.0;
      }
      for (std::size_t k = 0; k < primitives.size(); ++k) {
        read_primitive(primitives.at(k), result.back());
      }
    }
    if (no_triangles_ > 0) {
      reading_.note(
          fmt::format("Left out: {}.", track::counted(no_triangles_, "primitive of points or lines",
                                                      "primitives of points or lines")));
    }
    if (without_uv_ > 0) {
      reading_.note(fmt::format("Textures do not show for want of texture coordinates: {}.",
                                track::counted(without_uv_, "primitive", "primitives")));
    }
    if (is_morphed_) {
      reading_.note("Morph targets are left out, and the meshes have their basic shapes.");
    }
    return result;
  }

 private:
  void read_primitive(const JsonValue& primitive, GltfMesh& mesh) {
    const JsonValue mode = primitive["mode"], attributes = primitive["attributes"];
    if (!attributes.is_filled()) attributes.fail("the attributes of vertices");
    const std::uint64_t form = mode.whole(4);
    if (form > 6) mode.fail("an integer from 0 to 6");
    check_attributes(attributes);
    check_targets(primitive["targets"]);
    const JsonValue position = attributes["POSITION"];
    if (!position.exists() || form < 4) {
      ++no_triangles_;
      return;
    }
    Primitive result;
    const GltfAccessor& points = accessors_.at(position);
    const JsonValue draco = primitive["extensions"]["KHR_draco_mesh_compression"];
    if (draco.exists() && !points.view && !points.sparse) {
      draco.fail("a mesh that is only there as compressed by Draco", "one that is not compressed");
    }
    result.triangles = triangles(primitive, points.count, form);
    const std::vector<std::uint32_t> used = keep_used(result.triangles, points.count);
    reading_.budget.take_vertices(used.size());
    const std::vector<float> numbers = reals_of(points, used);
    result.positions.reserve(used.size());
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      result.positions.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    const JsonValue material = primitive["material"];
    result.material =
        material.exists() ? material.index(materials_.size(), "materials") : standard_material();
    read_attributes(attributes, used, result);
    mesh.influences.push_back(influences(attributes, used));
    mesh.mesh.primitives.push_back(std::move(result));
  }

  /// Throws unless all attributes that are read have forms that they may have, and one element for
  /// each vertex.
  void check_attributes(const JsonValue& attributes) const {
    std::optional<std::size_t> count;
    for (const std::string& name : attributes.keys()) {
      const GltfAccessor& accessor = accessors_.at(attributes[name]);
      if (!count) count = accessor.count;
      if (accessor.count != *count) {
        attributes[name].fail(fmt::format("{} elements", accessor.count),
                              fmt::format("{}, as the other attributes have", *count));
      }
      if (!is_good(name, accessor)) {
        attributes[name].fail(
            fmt::format("{} of {} ({})", accessor.type, static_cast<std::uint32_t>(accessor.number),
                        accessor.normalized ? "normalized" : "not normalized"),
            fmt::format("what {} may be", name));
      }
    }
  }

  void check_targets(const JsonValue& targets) const {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const JsonValue target = targets.at(i);
      for (const std::string& name : target.keys()) accessors_.at(target[name]);
    }
  }

  bool is_good(const std::string& name, const GltfAccessor& accessor) const {
    const bool is_packed = is_quantized_;
    if (name == "POSITION") return is_allowed(accessor, {{"VEC3"}, true, is_packed, is_packed});
    if (name == "NORMAL") return is_allowed(accessor, {{"VEC3"}, true, is_packed, false});
    if (name == "TANGENT") return is_allowed(accessor, {{"VEC4"}, true, is_packed, false});
    if (name.starts_with("TEXCOORD_"))
      return is_allowed(accessor, {{"VEC2"}, true, true, is_packed});
    if (name.starts_with("COLOR_")) return is_allowed(accessor, {{"VEC3", "VEC4"}});
    if (name.starts_with("JOINTS_")) return is_allowed(accessor, {{"VEC4"}, false, false, true});
    if (name.starts_with("WEIGHTS_")) return is_allowed(accessor, {{"VEC4"}});
    if (!name.starts_with('_')) return false;
    return true;
  }

  void read_attributes(const JsonValue& attributes, std::span<const std::uint32_t> used,
                       Primitive& result) {
    const JsonValue normal = attributes["NORMAL"], color = attributes["COLOR_0"];
    if (normal.exists()) {
      const std::vector<float> numbers = reals_of(accessors_.at(normal), used);
      for (std::size_t i = 0; i < numbers.size(); i += 3) {
        result.normals.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
      }
    }
    if (color.exists()) {
      const GltfAccessor& accessor = accessors_.at(color);
      const std::vector<float> numbers = reals_of(accessor, used);
      const bool has_alpha = accessor.components == 4;
      for (std::size_t i = 0; i < numbers.size(); i += accessor.components) {
        result.colors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2],
                                   has_alpha ? numbers[i + 3] : 1.0f);
      }
    }
    if (result.material >= materials_.size()) return;
    const std::optional<GltfUv>& uv = materials_.uv(result.material);
    const JsonValue coordinates = attributes[fmt::format("TEXCOORD_{}", uv ? uv->set : 0)];
    without_uv_ += uv && !coordinates.exists() ? 1 : 0;
    if (!uv || !coordinates.exists()) return;
    const std::vector<float> numbers = reals_of(accessors_.at(coordinates), used);
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
      result.uv.emplace_back(uv->matrix * dvec3(numbers[i], numbers[i + 1], 1.0));
    }
  }

  GltfInfluences influences(const JsonValue& attributes,
                            std::span<const std::uint32_t> used) const {
    GltfInfluences result;
    for (; attributes[fmt::format("JOINTS_{}", result.sets)].exists(); ++result.sets) {
      const JsonValue weights = attributes[fmt::format("WEIGHTS_{}", result.sets)];
      if (!weights.exists()) weights.fail("weights for the joints");
    }
    for (std::size_t set = 0; set < result.sets; ++set) {
      const auto joints =
          integers_of(accessors_.at(attributes[fmt::format("JOINTS_{}", set)]), used);
      const auto weights =
          reals_of(accessors_.at(attributes[fmt::format("WEIGHTS_{}", set)]), used);
      result.of_vertices.resize(joints.size() / 4 * result.sets);
      for (std::size_t i = 0; i + 3 < joints.size(); i += 4) {
        result.of_vertices[i / 4 * result.sets + set] = {
            {joints[i], joints[i + 1], joints[i + 2], joints[i + 3]},
            vec4(weights[i], weights[i + 1], weights[i + 2], weights[i + 3])};
      }
    }
    return result;
  }

  /// Returns the triangles of a primitive of the form 4 (each by itself), 5 (a strip) or 6 (a fan).
  std::vector<Triangle> triangles(const JsonValue& primitive, std::size_t vertices,
                                  std::uint64_t form) {
    const std::optional<std::vector<std::uint32_t>> indices = indices_of(primitive, form, vertices);
    const std::size_t corners = indices ? indices->size() : vertices;
    const auto corner = [&](std::size_t i) {
      return indices ? (*indices)[i] : static_cast<std::uint32_t>(i);
    };
    std::vector<Triangle> result;
    if (form == 4) {
      for (std::size_t i = 0; i + 2 < corners; i += 3) {
        result.push_back({corner(i), corner(i + 1), corner(i + 2)});
      }
      return result;
    }
    for (std::size_t i = 2; i < corners; ++i) {
      const bool is_turned = form == 5 && i % 2 == 1;
      const std::size_t first = form == 5 ? i - 2 : 0;
      const Triangle triangle = {corner(first), corner(is_turned ? i : i - 1),
                                 corner(is_turned ? i - 1 : i)};
      const auto [a, b, c] = triangle;
      // Strips repeat corners to continue at another place.
      if (a != b && b != c && c != a) result.push_back(triangle);
    }
    return result;
  }

  std::optional<std::vector<std::uint32_t>> indices_of(const JsonValue& primitive,
                                                       std::uint64_t form, std::size_t vertices) {
    const JsonValue value = primitive["indices"];
    const GltfAccessor* const accessor = value.exists() ? &accessors_.at(value) : nullptr;
    const std::size_t corners = accessor != nullptr ? accessor->count : vertices;
    reading_.budget.take_triangles(form == 4 ? corners / 3 : corners);
    if (accessor == nullptr) return std::nullopt;
    const bool is_unsigned = accessor->number == GltfNumber::uint8 ||
                             accessor->number == GltfNumber::uint16 ||
                             accessor->number == GltfNumber::uint32;
    if (accessor->type != "SCALAR" || !is_unsigned || accessor->normalized) {
      value.fail("an accessor of unsigned integers");
    }
    if (accessor->view && accessor->view->stride) value.fail("a view without byteStride");
    std::vector<std::uint32_t> indices = integers_of(*accessor);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < vertices) continue;
      value.fail(fmt::format("the index {} at place {}", indices[i], i),
                 fmt::format("indices of the {} vertices, from 0", vertices));
    }
    return indices;
  }

  /// Returns the index of the default material of glTF, which is added at the first call.
  std::size_t standard_material() {
    if (!standard_material_) {
      reading_.budget.take_materials(1);
      standard_material_ = reading_.model.materials.size();
      Material& material = reading_.model.materials.emplace_back();
      material.metallic = 1.0f;
    }
    return *standard_material_;
  }

  JsonValue root_;
  const GltfAccessors& accessors_;
  const GltfMaterials& materials_;
  Reading& reading_;
  bool is_quantized_ = false, is_morphed_ = false;
  std::size_t no_triangles_ = 0, without_uv_ = 0;  // primitives
  std::optional<std::size_t> standard_material_;
};

}  // namespace

std::vector<GltfMesh> read_gltf_meshes(const JsonValue& root, const GltfAccessors& accessors,
                                       const GltfMaterials& materials, Reading& reading) {
  return MeshReader(root, accessors, materials, reading).read();
}

Mesh skinned(const GltfMesh& mesh, const std::vector<glm::dmat4>& joints, const JsonValue& skin) {
  Mesh result = mesh.mesh;
  for (std::size_t i = 0; i < result.primitives.size(); ++i) {
    Primitive& primitive = result.primitives[i];
    const auto& [sets, of_vertices] = mesh.influences[i];
    if (sets == 0) skin.fail("a mesh without JOINTS_0", "one whose vertices have joints");
    for (std::size_t vertex = 0; vertex < primitive.positions.size(); ++vertex) {
      glm::dmat4 blend(0.0);
      double sum = 0.0;
      for (std::size_t k = vertex * sets * 4; k < (vertex + 1) * sets * 4; ++k) {
        const GltfInfluence& influence = of_vertices[k / 4];
        const float weight = influence.weights[static_cast<int>(k % 4)];
        if (!(weight > 0.0f)) continue;
        const std::uint32_t joint = influence.joints[k % 4];
        if (joint >= joints.size()) {
          skin.fail(fmt::format("joint {} of a vertex", joint),
                    fmt::format("one of {} joints, from 0", joints.size()));
        }
        blend += joints[joint] * static_cast<double>(weight);
        sum += static_cast<double>(weight);
      }
      if (!(sum > 0.0)) continue;
      blend /= sum;
      vec3& position = primitive.positions[vertex];
      position = vec3(blend * glm::dvec4(position, 1.0));
      if (primitive.normals.empty()) continue;
      const glm::dmat3 turn = glm::inverse(glm::transpose(glm::dmat3(blend)));
      primitive.normals[vertex] = vec3(turn * dvec3(primitive.normals[vertex]));
    }
  }
  return result;
}

}  // namespace aerostat::asset

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "asset/gltf_accessors.hpp"
#include "asset/gltf_buffers.hpp"
#include "asset/gltf_file.hpp"
#include "asset/gltf_materials.hpp"
#include "asset/gltf_meshes.hpp"
#include "asset/gltf_nodes.hpp"
#include "asset/gltf_unread.hpp"
#include "asset/json_value.hpp"
#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// Returns whether a transform is finite and does not flatten what it is applied to.
bool has_size(const dmat4& transform) {
  double sum = 0.0;
  for (int i = 0; i < 16; ++i) sum += transform[i / 4][i % 4];
  return std::isfinite(sum) && glm::determinant(glm::dmat3(transform)) != 0.0;
}

/// Makes the meshes and placements of the model from the parts of a file.
class Assembler {
 public:
  Assembler(const JsonValue& root, const GltfAccessors& accessors, std::vector<GltfMesh> meshes,
            std::vector<GltfNode> nodes, Reading& reading)
      : root_(root),
        accessors_(accessors),
        meshes_(std::move(meshes)),
        nodes_(std::move(nodes)),
        reading_(reading),
        places_(meshes_.size()) {}

  void assemble() {
    const JsonValue nodes = root_["nodes"], skins = root_["skins"];
    for (std::size_t i = 0; i < skins.size(); ++i) check_skin(skins.at(i));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const JsonValue mesh = nodes.at(i)["mesh"], skin = nodes.at(i)["skin"];
      if (skin.exists() && !mesh.exists()) mesh.fail("a mesh for the skin");
      if (!mesh.exists()) continue;
      const std::size_t place = mesh.index(meshes_.size(), "meshes");
      if (skin.exists()) skin_at(skin);
      if (nodes_[i].is_shown) place_mesh(nodes.at(i), nodes_[i], place);
    }
    if (nodes.size() == 0 && !meshes_.empty()) {
      reading_.note("The file has no nodes, so that its meshes stand where they are.");
      for (std::size_t i = 0; i < meshes_.size(); ++i) place(stored(i), dmat4(1.0));
    }
    note_left_out();
    take_off_origin();
  }

  /// Returns whether meshes are left out because their size is 0.
  bool hides_some() const { return hidden_ > 0; }

 private:
  void place_mesh(const JsonValue& node, const GltfNode& at, std::size_t mesh) {
    const JsonValue skin = node["skin"], instances = node["extensions"][kInstancing];
    if (skin.exists()) {
      // The joints of the skin place the mesh. By the specification, the transform of the node that
      // has the mesh is ignored.
      place(baked(mesh, skin), dmat4(1.0));
    } else if (instances.exists()) {
      place_instances(instances["attributes"], at.global, mesh);
    } else {
      place(stored(mesh), at.global);
    }
  }

  void place(std::size_t mesh, const dmat4& transform) {
    reading_.budget.take_placements(1);
    if (has_size(transform)) {
      reading_.model.placements.push_back({mesh, transform});
    } else {
      ++hidden_;
    }
  }

  /// Returns the index of a mesh in the model. The mesh is added to the model at the first call.
  std::size_t stored(std::size_t mesh) {
    if (!places_[mesh]) {
      places_[mesh] = reading_.model.meshes.size();
      reading_.model.meshes.push_back(meshes_[mesh].mesh);
    }
    return *places_[mesh];
  }

  void place_instances(const JsonValue& attributes, const dmat4& global, std::size_t mesh) {
    std::optional<std::size_t> count;
    const auto read = [&](const char* name, std::string_view type) {
      std::vector<float> numbers;
      const JsonValue value = attributes[name];
      if (!value.exists()) return numbers;
      const GltfAccessor& accessor = accessors_.at(value);
      const bool is_good = accessor.type == type && (accessor.is_of_float() || accessor.normalized);
      if (!is_good) value.fail(fmt::format("an accessor of {}", type));
      if (!count) reading_.budget.take_placements(accessor.count);
      if (count.value_or(accessor.count) != accessor.count) value.fail("as many as the others");
      count = accessor.count;
      return reals_of(accessor);
    };
    const std::vector<float> t = read("TRANSLATION", "VEC3"), r = read("ROTATION", "VEC4");
    const std::vector<float> s = read("SCALE", "VEC3");
    if (!count) attributes.fail("TRANSLATION, ROTATION or SCALE");
    const std::size_t place = stored(mesh);
    for (std::size_t i = 0; i < *count; ++i) {
      const dvec3 translation =
          t.empty() ? dvec3(0.0) : dvec3(t[3 * i], t[3 * i + 1], t[3 * i + 2]);
      const dvec4 rotation = r.empty() ? dvec4(0.0, 0.0, 0.0, 1.0)
                                       : dvec4(r[4 * i], r[4 * i + 1], r[4 * i + 2], r[4 * i + 3]);
      const dvec3 scale = s.empty() ? dvec3(1.0) : dvec3(s[3 * i], s[3 * i + 1], s[3 * i + 2]);
      const dmat4 transform = global * composed(translation, rotation, scale);
      if (has_size(transform)) {
        reading_.model.placements.push_back({place, transform});
      } else {
        ++hidden_;
      }
    }
  }

  JsonValue skin_at(const JsonValue& index) const {
    const JsonValue skins = root_["skins"];
    return skins.at(index.index(skins.size(), "skins"));
  }

  void check_skin(const JsonValue& skin) const {
    const JsonValue joints = skin["joints"];
    if (joints.size() == 0) joints.fail("at least one joint");
    for (std::size_t i = 0; i < joints.size(); ++i) joints.at(i).index(nodes_.size(), "nodes");
    const JsonValue inverse = skin["inverseBindMatrices"];
    if (!inverse.exists()) return;
    const GltfAccessor& accessor = accessors_.at(inverse);
    const bool is_good =
        accessor.type == "MAT4" && accessor.is_of_float() && accessor.count >= joints.size();
    if (!is_good) inverse.fail("a MAT4 of floats for each joint");
  }

  /// Returns, for each joint of a skin, the matrix from the mesh to the scene.
  const std::vector<dmat4>& joints_of(const JsonValue& index) {
    const JsonValue skin = skin_at(index), joints = skin["joints"];
    std::vector<dmat4>& matrices = joints_[static_cast<std::size_t>(index.whole())];
    if (!matrices.empty()) return matrices;
    const JsonValue inverse = skin["inverseBindMatrices"];
    std::vector<std::uint32_t> all(joints.size());
    std::iota(all.begin(), all.end(), std::uint32_t{0});
    const std::vector<float> numbers =
        inverse.exists() ? reals_of(accessors_.at(inverse), all) : std::vector<float>();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      dmat4 bind(1.0);
      for (std::size_t k = 0; k < 16 && !numbers.empty(); ++k) {
        bind[static_cast<int>(k / 4)][static_cast<int>(k % 4)] =
            static_cast<double>(numbers[16 * i + k]);
      }
      matrices.push_back(nodes_[joints.at(i).index(nodes_.size(), "nodes")].global * bind);
    }
    return matrices;
  }

  /// Adds a copy of a mesh whose vertices are moved by its skin, and returns its index in the
  /// model.
  std::size_t baked(std::size_t mesh, const JsonValue& index) {
    const std::vector<dmat4>& matrices = joints_of(index);
    for (const Primitive& primitive : meshes_[mesh].mesh.primitives) {
      reading_.budget.take_vertices(primitive.positions.size());
      reading_.budget.take_triangles(primitive.triangles.size());
    }
    reading_.model.meshes.push_back(skinned(meshes_[mesh], matrices, skin_at(index)));
    return reading_.model.meshes.size() - 1;
  }

  void note_left_out() {
    if (hidden_ > 0) {
      reading_.note(fmt::format("Left out because their size is 0: {}.",
                                track::counted(hidden_, "placed mesh", "placed meshes")));
    }
    if (root_["animations"].size() > 0) {
      reading_.note("Animations are left out, and the model stands as it rests.");
    }
  }

  void take_off_origin() {
    Model& model = reading_.model;
    model.origin = far_origin(bounds(model));
    for (Placement& placement : model.placements) {
      placement.transform[3] -= dvec4(model.origin, 0.0);
    }
  }

  JsonValue root_;
  const GltfAccessors& accessors_;
  std::vector<GltfMesh> meshes_;
  std::vector<GltfNode> nodes_;
  Reading& reading_;
  std::vector<std::optional<std::size_t>> places_;    // indices of the meshes in the model
  std::map<std::size_t, std::vector<dmat4>> joints_;  // of the skins that are needed
  std::size_t hidden_ = 0;                            // placements without size
};

}  // namespace

void read_gltf(Reading& reading) {
  const GltfFile file = open_gltf(reading.bytes);
  const JsonValue root(file.json);
  for (const std::string& extension : check_gltf(root)) {
    reading.note(fmt::format("The extension {} is left out.", extension));
  }
  GltfBuffers buffers(root, file.binary, reading.files, reading.budget.limits().file_bytes);
  const GltfAccessors accessors(root, buffers);
  std::vector<GltfNode> nodes = read_gltf_nodes(root, reading.budget);
  const GltfMaterials materials(root, buffers, reading);
  std::vector<GltfMesh> meshes = read_gltf_meshes(root, accessors, materials, reading);
  Assembler assembler(root, accessors, std::move(meshes), std::move(nodes), reading);
  assembler.assemble();
  // What is not drawn because its size is 0 is no fault of something else.
  if (reading.model.placements.empty() && !assembler.hides_some()) check_unread(root);
}

}  // namespace aerostat::asset

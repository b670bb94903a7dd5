#include "asset/write_gltf.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "image/write.hpp"

namespace aerostat::asset {
namespace {

static_assert(std::endian::native == std::endian::little, "the writer copies words as they lie");

using Json = nlohmann::ordered_json;

/// The numbers that glTF uses for types and uses of data.
constexpr int kUnsignedInt = 5125, kFloat = 5126, kVertices = 34962, kIndices = 34963;
constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648, kNearest = 9728, kLinear = 9729,
              kLinearMipmap = 9987;
constexpr const char* kTransmission = "KHR_materials_transmission";
constexpr const char* kIor = "KHR_materials_ior";
constexpr const char* kStrength = "KHR_materials_emissive_strength";
constexpr float kUsualIor = 1.5f;

int wrap_of(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return kRepeat;
    case Wrap::mirror:
      return kMirror;
    case Wrap::clamp:
      return kClamp;
  }
  return kRepeat;
}

Json list_of(const glm::vec3& v) {
  return Json::array({v.x, v.y, v.z});
}

class Writer {
 public:
  Writer(const Model& model, const std::string& binary_name)
      : model_(model), binary_name_(binary_name) {}

  GltfParts run() {
    Json root = {{"asset", {{"version", "2.0"}, {"generator", "aerostat"}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", Json::array({0})}}})}};
    for (const Mesh& mesh : model_.meshes) add_mesh(mesh);
    for (const Material& material : model_.materials) add_material(material);
    add_nodes();
    for (const Texture& texture : model_.textures) add_image(texture);
    root["nodes"] = std::move(nodes_);
    const auto put = [&root](const char* key, Json& list) {
      if (!list.empty()) root[key] = std::move(list);
    };
    put("meshes", meshes_);
    put("materials", materials_);
    put("textures", textures_);
    put("samplers", samplers_);
    put("images", images_);
    put("accessors", accessors_);
    put("bufferViews", views_);
    put("extensionsUsed", extensions_);
    if (!binary_.empty()) {
      Json buffer = {{"byteLength", binary_.size()}};
      if (!binary_name_.empty()) buffer["uri"] = binary_name_;
      root["buffers"] = Json::array({std::move(buffer)});
    }
    return {root.dump(), std::move(binary_)};
  }

 private:
  /// Appends bytes to the buffer and returns the number of their view.
  std::size_t add_view(const void* data, std::size_t size, std::optional<int> target) {
    binary_.resize((binary_.size() + 3) / 4 * 4, 0);
    const std::size_t offset = binary_.size();
    if (size > std::numeric_limits<std::uint32_t>::max() - 64 - offset) {
      throw Error(
          ErrorKind::exhausted,
          fmt::format("exporting glTF: found more than {} bytes, and a file holds at most 4 "
                      "GiB; fewer plants or a coarser land need less",
                      offset));
    }
    binary_.resize(offset + size);
    std::memcpy(binary_.data() + offset, data, size);
    Json view = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
    if (target) view["target"] = *target;
    views_.push_back(std::move(view));
    return views_.size() - 1;
  }

  template <class T>
  std::size_t add_accessor(const std::vector<T>& values, const char* type, int component,
                           std::size_t per_value, int target) {
    const std::size_t view = add_view(values.data(), values.size() * sizeof(T), target);
    accessors_.push_back({{"bufferView", view},
                          {"componentType", component},
                          {"count", values.size() * per_value},
                          {"type", type}});
    return accessors_.size() - 1;
  }

  void add_mesh(const Mesh& mesh) {
    Json primitives = Json::array();
    for (const Primitive& primitive : mesh.primitives) {
      if (!primitive.triangles.empty()) primitives.push_back(primitive_json(primitive));
    }
    // A mesh without triangles is not allowed. Its placements are left out.
    numbers_.push_back(primitives.empty() ? std::nullopt : std::optional(meshes_.size()));
    if (!primitives.empty()) {
      meshes_.push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
    }
  }

  Json primitive_json(const Primitive& primitive) {
    const auto floats = [this](const auto& values, const char* type) {
      return add_accessor(values, type, kFloat, 1, kVertices);
    };
    Json attributes = {{"POSITION", floats(primitive.positions, "VEC3")}};
    glm::vec3 least(primitive.positions.front()), most = least;
    for (const glm::vec3& position : primitive.positions) {
      least = glm::min(least, position);
      most = glm::max(most, position);
    }
    accessors_.back()["min"] = list_of(least);
    accessors_.back()["max"] = list_of(most);
    if (!primitive.normals.empty()) attributes["NORMAL"] = floats(primitive.normals, "VEC3");
    if (!primitive.uv.empty()) attributes["TEXCOORD_0"] = floats(primitive.uv, "VEC2");
    const bool is_white =
        std::all_of(primitive.colors.begin(), primitive.colors.end(),
                    [](const glm::vec4& color) { return color == glm::vec4(1.0f); });
    if (!is_white) attributes["COLOR_0"] = floats(primitive.colors, "VEC4");
    const std::size_t indices =
        add_accessor(primitive.triangles, "SCALAR", kUnsignedInt, 3, kIndices);
    return {{"attributes", std::move(attributes)},
            {"indices", indices},
            {"material", primitive.material}};
  }

  Json texture_json(const TextureUse& use) {
    const Json sampler = {{"magFilter", use.nearest ? kNearest : kLinear},
                          {"minFilter", kLinearMipmap},
                          {"wrapS", wrap_of(use.wrap_u)},
                          {"wrapT", wrap_of(use.wrap_v)}};
    const auto place = [](Json& list, const Json& wanted) {
      const auto found = std::find(list.begin(), list.end(), wanted);
      const auto index = static_cast<std::size_t>(std::distance(list.begin(), found));
      if (found == list.end()) list.push_back(wanted);
      return index;
    };
    const std::size_t number = place(samplers_, sampler);
    return {{"index", place(textures_, {{"sampler", number}, {"source", use.texture}})}};
  }

  /// Notes that the file uses an extension, and returns its name.
  const char* extension(const char* name) {
    if (std::find(extensions_.begin(), extensions_.end(), name) == extensions_.end()) {
      extensions_.push_back(name);
    }
    return name;
  }

  void add_material(const Material& from) {
    const glm::vec4& base = from.base_color;
    Json surface = {{"baseColorFactor", Json::array({base.x, base.y, base.z, base.w})},
                    {"metallicFactor", from.metallic},
                    {"roughnessFactor", from.roughness}};
    if (from.base_color_texture)
      surface["baseColorTexture"] = texture_json(*from.base_color_texture);
    if (from.metallic_roughness_texture) {
      surface["metallicRoughnessTexture"] = texture_json(*from.metallic_roughness_texture);
    }
    Json material = {{"name", from.name}, {"pbrMetallicRoughness", std::move(surface)}};
    if (from.normal_texture) {
      material["normalTexture"] = texture_json(*from.normal_texture);
      material["normalTexture"]["scale"] = from.normal_scale;
    }
    if (from.emission_texture) material["emissiveTexture"] = texture_json(*from.emission_texture);
    Json extras = Json::object();
    const float strongest = std::max({from.emission.x, from.emission.y, from.emission.z});
    if (strongest > 0.0f) {
      material["emissiveFactor"] = list_of(from.emission / std::max(strongest, 1.0f));
      if (strongest > 1.0f) extras[extension(kStrength)] = {{"emissiveStrength", strongest}};
    }
    if (from.transmission > 0.0f) {
      extras[extension(kTransmission)] = {{"transmissionFactor", from.transmission}};
    }
    if (from.ior != kUsualIor) extras[extension(kIor)] = {{"ior", from.ior}};
    if (!extras.empty()) material["extensions"] = std::move(extras);
    if (from.alpha == AlphaMode::mask) {
      material["alphaMode"] = "MASK";
      material["alphaCutoff"] = from.alpha_cutoff;
    }
    if (from.alpha == AlphaMode::blend) material["alphaMode"] = "BLEND";
    if (from.double_sided) material["doubleSided"] = true;
    materials_.push_back(std::move(material));
  }

  void add_image(const Texture& texture) {
    const std::vector<std::uint8_t> png = image::encode_png(
        texture.rgba, static_cast<int>(texture.width), static_cast<int>(texture.height));
    const std::size_t view = add_view(png.data(), png.size(), std::nullopt);
    images_.push_back({{"name", texture.name}, {"mimeType", "image/png"}, {"bufferView", view}});
  }

  void add_nodes() {
    Json children = Json::array();
    nodes_.push_back({{"name", "aerostat"}});
    for (const Placement& placement : model_.placements) {
      const std::optional<std::size_t> mesh = numbers_[placement.mesh];
      if (!mesh) continue;
      Json node = {{"name", model_.meshes[placement.mesh].name}, {"mesh", *mesh}};
      if (placement.transform != glm::dmat4(1.0)) {
        Json matrix = Json::array();
        for (int i = 0; i < 16; ++i) matrix.push_back(placement.transform[i / 4][i % 4]);
        node["matrix"] = std::move(matrix);
      }
      children.push_back(nodes_.size());
      nodes_.push_back(std::move(node));
    }
    if (model_.origin != glm::dvec3(0.0)) {
      nodes_[0]["translation"] = Json::array({model_.origin.x, model_.origin.y, model_.origin.z});
    }
    if (!children.empty()) nodes_[0]["children"] = std::move(children);
  }

  const Model& model_;
  const std::string& binary_name_;
  std::vector<std::optional<std::size_t>> numbers_;  // of the meshes in the file
  std::vector<std::uint8_t> binary_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(),
       textures_ = Json::array(), samplers_ = Json::array(), images_ = Json::array(),
       accessors_ = Json::array(), views_ = Json::array(), extensions_ = Json::array();
};

void put_word(std::vector<std::uint8_t>& bytes, std::size_t word) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
}

}  // namespace

GltfParts gltf_parts(const Model& model, const std::string& binary_name) {
  return Writer(model, binary_name).run();
}

std::vector<std::uint8_t> glb_bytes(const Model& model) {
  GltfParts parts = gltf_parts(model, {});
  parts.json.resize((parts.json.size() + 3) / 4 * 4, ' ');
  parts.binary.resize((parts.binary.size() + 3) / 4 * 4, 0);
  const std::size_t total = 12 + 8 + parts.json.size() + 8 + parts.binary.size();
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(
        ErrorKind::exhausted,
        fmt::format("exporting GLB: found {} bytes, and a file holds less than 4 GiB", total));
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(total);
  put_word(bytes, 0x46546c67);  // "glTF"
  put_word(bytes, 2);
  put_word(bytes, total);
  put_word(bytes, parts.json.size());
  put_word(bytes, 0x4e4f534a);  // "JSON"
  bytes.insert(bytes.end(), parts.json.begin(), parts.json.end());
  put_word(bytes, parts.binary.size());
  put_word(bytes, 0x004e4942);  // "BIN"
  bytes.insert(bytes.end(), parts.binary.begin(), parts.binary.end());
  return bytes;
}

}  // namespace aerostat::asset

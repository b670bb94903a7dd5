#include "asset/gltf_materials.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "asset/words.hpp"
#include "core/error.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

// These limits are far beyond all sensible values. They keep products in the range of float.
constexpr double kStrongest = 1e12;  // emission: the sun has some 1e9 candelas a square metre
constexpr double kSteepest = 1e6;    // a normal map
constexpr double kDensest = 1e6;     // an index of refraction
constexpr double kEndless = std::numeric_limits<double>::infinity();

float fraction(const JsonValue& value, double otherwise) {
  return static_cast<float>(value.number(otherwise, 0.0, 1.0));
}

/// Returns a colour of N components from 0 to 1.
template <std::size_t N>
glm::vec4 color(const JsonValue& value) {
  std::array<double, N> ones{};
  ones.fill(1.0);
  const std::array<double, N> numbers = value.numbers<N>(ones);
  glm::vec4 result(1.0f);
  for (std::size_t i = 0; i < N; ++i) {
    if (!(numbers[i] >= 0.0 && numbers[i] <= 1.0)) value.fail("numbers from 0 to 1");
    result[static_cast<int>(i)] = static_cast<float>(numbers[i]);
  }
  return result;
}

/// Returns the texture coordinates that a use of a texture asks for.
GltfUv uv_of(const JsonValue& info) {
  GltfUv uv;
  const JsonValue transform = info["extensions"]["KHR_texture_transform"];
  uv.set = static_cast<std::size_t>(transform["texCoord"].whole(info["texCoord"].whole(0)));
  if (!transform.exists()) return uv;
  const auto offset = transform["offset"].numbers<2>({0, 0});
  const auto scale = transform["scale"].numbers<2>({1, 1});
  const double angle = transform["rotation"].number(0.0);
  const double c = std::cos(angle), s = std::sin(angle);
  // The extension turns counter-clockwise as seen in the picture, whose v points down.
  uv.matrix = glm::dmat3(scale[0] * c, -scale[0] * s, 0.0, scale[1] * s, scale[1] * c, 0.0,
                         offset[0], offset[1], 1.0);
  return uv;
}

Wrap wrap_of(const JsonValue& value) {
  const std::uint64_t code = value.whole(10497);
  if (code == 10497) return Wrap::repeat;
  if (code == 33648) return Wrap::mirror;
  if (code != 33071) value.fail("10497, 33071 or 33648");
  return Wrap::clamp;
}

}  // namespace

GltfMaterials::GltfMaterials(const JsonValue& root, GltfBuffers& buffers, Reading& reading)
    : root_(root), buffers_(buffers), reading_(reading) {
  check_images();
  const JsonValue materials = root["materials"];
  reading.budget.take_materials(materials.size());
  for (std::size_t i = 0; i < materials.size(); ++i) read_material(materials.at(i));
}

void GltfMaterials::check_images() const {
  const JsonValue images = root_["images"], textures = root_["textures"];
  for (std::size_t i = 0; i < images.size(); ++i) {
    const JsonValue image = images.at(i), view = image["bufferView"];
    if (image["uri"].exists() == view.exists()) image.fail("either a uri or a bufferView");
    if (!view.exists()) continue;
    const std::size_t place = view.index(buffers_.view_count(), "bufferViews");
    if (buffers_.view(place).stride) view.fail("a view without byteStride");
    const std::string type = image["mimeType"].text();
    if (type.empty()) image["mimeType"].fail("image/png or image/jpeg");
  }
  for (std::size_t i = 0; i < textures.size(); ++i) {
    const JsonValue source = textures.at(i)["source"];
    if (source.exists()) source.index(images.size(), "images");
    sampled(textures.at(i));
  }
}

void GltfMaterials::read_material(const JsonValue& material) {
  Material result;
  result.name = track::clean_text(material["name"].text());
  uv_.emplace_back();
  uv_differ_ = false;
  const JsonValue extensions = material["extensions"];
  const JsonValue older = extensions["KHR_materials_pbrSpecularGlossiness"];
  if (older.exists() && !material["pbrMetallicRoughness"].exists()) {
    read_specular_glossiness(older, result);
  } else {
    read_metallic_roughness(material["pbrMetallicRoughness"], result);
  }
  const JsonValue normal = material["normalTexture"];
  result.normal_texture = use(normal);
  result.normal_scale = static_cast<float>(normal["scale"].number(1.0, -kSteepest, kSteepest));
  const JsonValue occlusion = material["occlusionTexture"]["index"];
  if (occlusion.exists()) occlusion.index(root_["textures"].size(), "textures");
  read_emission(material, result);
  read_alpha(material, result);
  result.double_sided = material["doubleSided"].flag(false);
  read_extensions(extensions, result);
  if (uv_differ_) {
    reading_.note(
        fmt::format("The textures of the material {} lie differently on its surface, and "
                    "all of them are laid out as the first of them.",
                    in_quotes(result.name)));
  }
  reading_.model.materials.push_back(std::move(result));
}

void GltfMaterials::read_metallic_roughness(const JsonValue& numbers, Material& result) {
  result.base_color = color<4>(numbers["baseColorFactor"]);
  const JsonValue texture = numbers["baseColorTexture"];
  result.base_color_texture = use(texture);
  if (texture.exists() && !result.base_color_texture) show_missing_texture(result);
  result.metallic = fraction(numbers["metallicFactor"], 1.0);
  result.roughness = fraction(numbers["roughnessFactor"], 1.0);
  result.metallic_roughness_texture = use(numbers["metallicRoughnessTexture"]);
}

/// Reads the older description of a material. The colour of its reflections is not kept.
void GltfMaterials::read_specular_glossiness(const JsonValue& numbers, Material& result) {
  result.base_color = color<4>(numbers["diffuseFactor"]);
  const JsonValue texture = numbers["diffuseTexture"];
  result.base_color_texture = use(texture);
  if (texture.exists() && !result.base_color_texture) show_missing_texture(result);
  result.metallic = 0.0f;
  result.roughness = 1.0f - fraction(numbers["glossinessFactor"], 1.0);
}

void GltfMaterials::read_emission(const JsonValue& material, Material& result) {
  const JsonValue factor = material["emissiveFactor"];
  if (factor.exists()) result.emission = glm::vec3(color<3>(factor));
  const JsonValue strength =
      material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
  result.emission *= static_cast<float>(strength.number(1.0, 0.0, kStrongest));
  result.emission_texture = use(material["emissiveTexture"]);
}

void GltfMaterials::read_alpha(const JsonValue& material, Material& result) {
  const JsonValue mode = material["alphaMode"];
  const std::string name = mode.text();
  if (name == "MASK") {
    result.alpha = AlphaMode::mask;
  } else if (name == "BLEND") {
    result.alpha = AlphaMode::blend;
  } else if (!name.empty() && name != "OPAQUE") {
    mode.fail("OPAQUE, MASK or BLEND");
  }
  result.alpha_cutoff = static_cast<float>(material["alphaCutoff"].number(0.5, 0.0, kEndless));
}

void GltfMaterials::read_extensions(const JsonValue& extensions, Material& result) {
  const JsonValue transmission = extensions["KHR_materials_transmission"];
  result.transmission = fraction(transmission["transmissionFactor"], 0.0);
  if (transmission["transmissionTexture"].exists()) {
    reading_.note(fmt::format("The texture of what passes through the material {} is left out.",
                              in_quotes(result.name)));
  }
  const JsonValue ior = extensions["KHR_materials_ior"]["ior"];
  const double index = ior.number(1.5, 0.0, kDensest);
  if (index != 0.0 && !(index >= 1.0)) ior.fail("0 or a number of at least 1");
  result.ior = static_cast<float>(index);
  if (!extensions["KHR_materials_unlit"].exists()) return;
  // Unlit materials are lit as matt surfaces. The file gives no luminance with which they could
  // shine.
  result.metallic = 0.0f;
  result.roughness = 1.0f;
  result.metallic_roughness_texture.reset();
}

std::optional<TextureUse> GltfMaterials::use(const JsonValue& info) {
  if (!info.exists()) return std::nullopt;
  const JsonValue textures = root_["textures"];
  const JsonValue texture = textures.at(info["index"].index(textures.size(), "textures"));
  const JsonValue source = texture["source"];
  if (!source.exists()) {
    const std::vector<std::string> extensions = texture["extensions"].keys();
    reading_.note(
        fmt::format("A texture is left out: {} has no picture in PNG or JPEG{}.", texture.pointer(),
                    extensions.empty() ? std::string()
                                       : fmt::format(", only {}", fmt::join(extensions, ", "))));
    return std::nullopt;
  }
  const std::optional<std::size_t> place = image(source.index(root_["images"].size(), "images"));
  if (!place) return std::nullopt;
  want_uv(info);
  TextureUse result = sampled(texture);
  result.texture = *place;
  return result;
}

void GltfMaterials::want_uv(const JsonValue& info) {
  const GltfUv wanted = uv_of(info);
  if (!uv_.back()) uv_.back() = wanted;
  uv_differ_ = uv_differ_ || !(*uv_.back() == wanted);
}

TextureUse GltfMaterials::sampled(const JsonValue& texture) const {
  TextureUse result;
  const JsonValue sampler = texture["sampler"], samplers = root_["samplers"];
  if (!sampler.exists()) return result;
  const JsonValue found = samplers.at(sampler.index(samplers.size(), "samplers"));
  result.wrap_u = wrap_of(found["wrapS"]);
  result.wrap_v = wrap_of(found["wrapT"]);
  result.nearest = found["magFilter"].whole(9729) == 9728;
  return result;
}

std::optional<std::size_t> GltfMaterials::image(std::size_t i) {
  const auto known = images_.find(i);
  if (known != images_.end()) return known->second;
  std::optional<std::size_t>& place = images_[i];
  const JsonValue image = root_["images"].at(i), view = image["bufferView"], uri = image["uri"];
  try {
    const bool is_file = uri.exists() && !uri.text().starts_with("data:");
    const std::string name = is_file ? track::clean_text(uri.text()) : image.pointer();
    const std::string_view bytes =
        view.exists() ? buffers_.view(view.index(buffers_.view_count(), "bufferViews")).bytes
                      : buffers_.bytes_of_uri(uri);
    place = add_texture(reading_, bytes, name);
  } catch (const Error& error) {
    reading_.note(fmt::format("A texture is left out: {}.", error.what()));
  }
  return place;
}

}  // namespace aerostat::asset

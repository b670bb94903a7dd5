#include "pack/pack_models.hpp"

#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include "core/copy.hpp"
#include "core/error.hpp"
#include "pack/mip_levels.hpp"

namespace aerostat::pack {
namespace {

/// A texture as one or more materials of a model use it.
struct Wanted {
  const asset::Texture* texture = nullptr;
  asset::TextureUse use;
  TexelKind kind = TexelKind::color;

  auto key() const { return std::tuple(texture, use.wrap_u, use.wrap_v, use.nearest, kind); }
};

const asset::Texture& white() {
  static const asset::Texture texture{"white", 1, 1, {255, 255, 255, 255}};
  return texture;
}

/// Lists the textures of models, each once for each way in which it is used.
class Textures {
 public:
  Textures() { add({&white(), {}, TexelKind::data}); }

  /// Returns the number of a texture, which is 0 for none.
  std::uint32_t number(const world::FileModel& model, const std::optional<asset::TextureUse>& use,
                       TexelKind kind) {
    if (!use) return 0;
    return add({&model.textures[use->texture], *use, kind});
  }

  /// Returns the textures one behind the other, and sets `places` to those of their first words.
  std::vector<std::uint32_t> words(std::vector<std::uint32_t>& places) const {
    require_room();
    std::vector<std::vector<std::uint32_t>> parts(wanted_.size());
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      const Wanted& one = wanted_[i];
      parts[i] = texture_words(*one.texture, one.use, one.kind);
    });
    std::vector<std::uint32_t> all;
    for (std::vector<std::uint32_t>& part : parts) {
      places.push_back(static_cast<std::uint32_t>(all.size()));
      all.insert(all.end(), part.begin(), part.end());
      part = {};
    }
    return all;
  }

 private:
  std::uint32_t add(const Wanted& one) {
    const auto [entry, is_new] =
        numbers_.try_emplace(one.key(), static_cast<std::uint32_t>(wanted_.size()));
    if (is_new) wanted_.push_back(one);
    return entry->second;
  }

  /// Levels take a third more than the texture itself.
  void require_room() const {
    std::size_t texels = 0;
    const Wanted* largest = &wanted_.front();
    const auto size = [](const Wanted& one) {
      return std::size_t{one.texture->width} * one.texture->height;
    };
    for (const Wanted& one : wanted_) {
      texels += size(one) + size(one) / 3;
      if (size(one) > size(*largest)) largest = &one;
    }
    if (texels <= kMostTextureWords) return;
    throw Error(ErrorKind::exhausted,
                fmt::format("/objects: the textures of the models take {} MiB, expected at most "
                            "{}; smaller pictures take less, and the largest one is {} with {} x "
                            "{} pixels",
                            texels >> 18, kMostTextureWords >> 18, largest->texture->name,
                            largest->texture->width, largest->texture->height));
  }

  std::vector<Wanted> wanted_;
  std::map<decltype(Wanted{}.key()), std::uint32_t> numbers_;
};

std::uint32_t see_through(asset::AlphaMode mode) {
  switch (mode) {
    case asset::AlphaMode::opaque:
      return AERO_OPAQUE;
    case asset::AlphaMode::mask:
      return AERO_MASKED;
    case asset::AlphaMode::blend:
      return AERO_BLENDED;
  }
  return AERO_OPAQUE;
}

/// Returns the reflectance at normal incidence of a surface with this index of refraction.
float bare_reflectance(float ior) {
  const float root = (ior - 1.0f) / (ior + 1.0f);
  return root * root;
}

/// Packs a material. Its textures are numbers yet.
AeroMaterial pack_material(const world::FileModel& model, const asset::Material& from,
                           Textures& textures) {
  AeroMaterial material{};
  material.kind = AERO_MATERIAL_MODEL;
  copy(material.albedo, vec3(from.base_color));
  material.ambient = material.diffuse = 1.0f;
  material.shininess = 1.0f;
  material.specular = bare_reflectance(from.ior);
  material.translucency = from.transmission;
  copy(material.emission, from.emission);
  material.burner_light = AERO_BURNER_NOTHING;
  material.metallic = from.metallic;
  material.roughness = from.roughness;
  material.opacity = from.base_color.w;
  material.cutoff = from.alpha_cutoff;
  material.see_through = see_through(from.alpha);
  material.normal_scale = from.normal_scale;
  const auto colors =
      from.alpha == asset::AlphaMode::opaque ? TexelKind::opaque_color : TexelKind::color;
  material.color_texture = textures.number(model, from.base_color_texture, colors);
  material.metal_texture = textures.number(model, from.metallic_roughness_texture, TexelKind::data);
  material.normal_texture = textures.number(model, from.normal_texture, TexelKind::data);
  material.emission_texture =
      textures.number(model, from.emission_texture, TexelKind::opaque_color);
  return material;
}

}  // namespace

std::shared_ptr<const PackedModels> pack_models(const world::SceneModels& models) {
  auto packed = std::make_shared<PackedModels>();
  Textures textures;
  for (const auto& model : models.models) {
    for (const asset::Material& material : model->materials) {
      packed->materials.push_back(pack_material(*model, material, textures));
    }
  }
  std::vector<std::uint32_t> places;
  packed->texels = textures.words(places);
  for (AeroMaterial& material : packed->materials) {
    for (aero_uint* texture : {&material.color_texture, &material.metal_texture,
                               &material.normal_texture, &material.emission_texture}) {
      *texture = places[*texture];
    }
  }
  return packed;
}

}  // namespace aerostat::pack

#include "asset/obj_materials.hpp"

#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "asset/words.hpp"
#include "core/error.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

/// A texture that has a pixel with less opacity than this is used as a mask. Chosen by eye.
constexpr std::uint8_t kSeeThrough = 128;

/// Returns the path of a file that an OBJ or MTL file names. Many programs write absolute paths of
/// the computer that they ran on. If there is no such file here, a file of the same name beside the
/// model is taken.
std::filesystem::path find_by_name(const Files& files, std::string_view name) {
  try {
    return files.find(name);
  } catch (const Error&) {
    const std::size_t folder = name.find_last_of("/\\");
    if (folder == std::string_view::npos || folder + 1 == name.size()) throw;
    try {
      return files.find(name.substr(folder + 1));
    } catch (const Error&) {
      // The error about the whole name is more helpful than the one about its last part.
    }
    throw;
  }
}

}  // namespace

void ObjMaterials::read_library(const std::string& names) {
  // The whole line may be one name with spaces.
  if (const auto path = find(names, false)) return read_file(*path);
  Words words(names);
  std::size_t count = 0;
  for (std::string_view name = words.next(); !name.empty(); name = words.next()) {
    if (++count > kMostLibraries)
      refuse(fmt::format("found an mtllib of more than {} names", kMostLibraries));
    if (const auto path = find(name, true)) read_file(*path);
  }
}

std::optional<std::filesystem::path> ObjMaterials::find(std::string_view name, bool is_told) {
  try {
    return find_by_name(reading_.files, name);
  } catch (const Error& error) {
    if (is_told) reading_.note(fmt::format("Materials are missing: {}.", error.what()));
    return std::nullopt;
  }
}

void ObjMaterials::read_file(const std::filesystem::path& path) {
  if (!read_.insert(path).second) return;
  try {
    const std::string text = reading_.files.read(path);
    for (MtlMaterial& material :
         read_mtl(text, reading_.budget.limits().materials, reading_.model.notes)) {
      std::string name = material.material.name;
      library_.try_emplace(std::move(name), std::move(material));
    }
  } catch (const Error& error) {
    refuse(fmt::format("{}: {}", path.filename().string(), error.what()));
  }
}

ObjMaterial ObjMaterials::of(const std::string& name, bool have_colors) {
  const auto known = known_.find(name);
  if (known != known_.end()) return known->second;
  const auto found = library_.find(name);
  MtlMaterial read{plain_material(), {}, {}, {}, {}};
  if (have_colors) read.material.base_color = glm::vec4(1.0f);
  if (found != library_.end()) read = found->second;
  if (found == library_.end() && !name.empty()) {
    reading_.note(
        fmt::format("The material {} is missing, and grey takes its place.", in_quotes(name)));
  }
  read.material.name = track::clean_text(name);
  return known_[name] = add(std::move(read));
}

ObjMaterial ObjMaterials::add(MtlMaterial read) {
  reading_.budget.take_materials(1);
  Material& material = read.material;
  ObjMaterial result;
  if (const std::optional<MtlMap>& map = read.color ? read.color : read.emission) {
    result.scale = map->scale;
    result.offset = map->offset;
  }
  if (read.color) {
    material.base_color_texture = use(*read.color);
    if (!material.base_color_texture) show_missing_texture(material);
  }
  if (read.opacity && (!read.color || read.opacity->file != read.color->file)) {
    add_opacity(material, *read.opacity);
  }
  show_opacity(material, read.opacity.has_value());
  if (read.emission) material.emission_texture = use(*read.emission);
  if (read.normal) {
    material.normal_texture = use(*read.normal);
    material.normal_scale = read.normal->strength;
  }
  result.place = reading_.model.materials.size();
  reading_.model.materials.push_back(std::move(material));
  return result;
}

std::optional<TextureUse> ObjMaterials::use(const MtlMap& map) {
  const std::optional<std::size_t> place = texture(map.file);
  if (!place) return std::nullopt;
  const Wrap wrap = map.clamp ? Wrap::clamp : Wrap::repeat;
  return TextureUse{*place, wrap, wrap, false};
}

std::optional<std::size_t> ObjMaterials::texture(const std::string& file) {
  const auto known = textures_.find(file);
  if (known != textures_.end()) return known->second;
  std::optional<std::size_t>& place = textures_[file];
  try {
    const std::string bytes = reading_.files.read(find_by_name(reading_.files, file));
    place = add_texture(reading_, bytes, track::clean_text(file));
  } catch (const Error& error) {
    reading_.note(fmt::format("A texture is left out: {}.", error.what()));
  }
  return place;
}

/// Gives the base colour of a material the opacity of a texture of its own.
void ObjMaterials::add_opacity(Material& material, const MtlMap& map) {
  const std::optional<TextureUse> opacity = use(map);
  if (!opacity) return;
  std::optional<TextureUse>& color = material.base_color_texture;
  const auto key =
      std::pair(color ? std::optional(color->texture) : std::nullopt, opacity->texture);
  const auto known = joined_.find(key);
  if (!color) color = opacity;
  if (known != joined_.end()) {
    color->texture = known->second;
    return;
  }
  std::vector<Texture>& textures = reading_.model.textures;
  const Texture& from = textures[opacity->texture];
  Texture joined = key.first ? textures[*key.first] : white_texture(from.width, from.height);
  reading_.budget.take_texture(joined.width, joined.height);
  set_opacity(joined, from);
  joined_[key] = color->texture = textures.size();
  textures.push_back(std::move(joined));
}

/// Uses the opacity of the base colour's texture as a mask if it has holes or if `is_wanted`.
void ObjMaterials::show_opacity(Material& material, bool is_wanted) {
  if (!material.base_color_texture || material.alpha != AlphaMode::opaque) return;
  const std::size_t place = material.base_color_texture->texture;
  const auto [known, is_new] = have_holes_.try_emplace(place, false);
  if (is_new) known->second = least_opacity(reading_.model.textures[place]) < kSeeThrough;
  if (known->second || is_wanted) material.alpha = AlphaMode::mask;
}

}  // namespace aerostat::asset

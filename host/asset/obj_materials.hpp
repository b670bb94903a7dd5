#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "asset/mtl.hpp"
#include "asset/reading.hpp"

namespace aerostat::asset {

/// The most lines "mtllib" of a file, and the most names in one of them.
inline constexpr std::size_t kMostLibraries = 100;

/// A material of the model, and how it changes texture coordinates.
struct ObjMaterial {
  std::size_t place = 0;  // in Model::materials
  glm::vec2 scale{1.0f}, offset{0.0f};
};

/// The materials that an OBJ file names. What is missing becomes grey, and a note says so.
class ObjMaterials {
 public:
  explicit ObjMaterials(Reading& reading) : reading_(reading) {}

  /// Reads the MTL files that a line "mtllib" names. Throws Error{bad_data} with the name and the
  /// line if one of them cannot be understood.
  void read_library(const std::string& names);

  /// Returns the material of a name. It is added to the model when it is asked for first. If the
  /// vertices have colours, they take the place of the grey of what is missing.
  ObjMaterial of(const std::string& name, bool have_colors);

 private:
  std::optional<std::filesystem::path> find(std::string_view name, bool is_told);
  void read_file(const std::filesystem::path& path);
  ObjMaterial add(MtlMaterial read);
  std::optional<TextureUse> use(const MtlMap& map);
  std::optional<std::size_t> texture(const std::string& file);
  void add_opacity(Material& material, const MtlMap& map);
  void show_opacity(Material& material, bool is_wanted);

  Reading& reading_;
  std::set<std::filesystem::path> read_;
  std::map<std::string, MtlMaterial> library_;
  std::map<std::string, ObjMaterial> known_;
  std::map<std::string, std::optional<std::size_t>> textures_;  // by the names in MTL files
  /// The textures that were made of the colours of one, or of white, and the opacity of another.
  std::map<std::pair<std::optional<std::size_t>, std::size_t>, std::size_t> joined_;
  std::map<std::size_t, bool> have_holes_;  // of the textures that are known
};

}  // namespace aerostat::asset

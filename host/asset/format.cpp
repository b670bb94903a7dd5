#include <string>

#include "asset/read.hpp"
#include "asset/words.hpp"

namespace aerostat::asset {
namespace {

bool is_word(std::string_view text, std::string_view word) {
  return text.substr(0, word.size()) == word && text.size() > word.size() &&
         (text[word.size()] == '\r' || text[word.size()] == '\n');
}

}  // namespace

std::optional<Format> format_of(std::string_view beginning, const std::filesystem::path& file) {
  if (beginning.substr(0, 4) == "glTF") return Format::gltf;
  if (is_word(beginning, "ply")) return Format::ply;
  const std::string ending = lower_case(file.extension().string());
  if (ending == ".gltf" || ending == ".glb") return Format::gltf;
  if (ending == ".obj") return Format::obj;
  if (ending == ".ply") return Format::ply;
  if (ending == ".stl") return Format::stl;
  return std::nullopt;
}

}  // namespace aerostat::asset

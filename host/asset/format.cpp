#include <algorithm>
#include <cctype>
#include <string>

#include "asset/read.hpp"

namespace aerostat::asset {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

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

#include "staging/scene_text.hpp"

#include <cctype>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::staging {
namespace {

/// Returns the first character behind a byte order mark and white space, or 0 without any.
char first_character(std::ifstream& file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  for (int read = 0, byte = 0; (byte = file.get()) != std::ifstream::traits_type::eof(); ++read) {
    const bool is_mark = read < 3 && static_cast<char>(byte) == kByteOrderMark[read];
    if (!is_mark && std::isspace(byte) == 0) return static_cast<char>(byte);
  }
  return 0;
}

}  // namespace

void require_scene_text(const std::filesystem::path& file) {
  if (file.extension() == ".json" || !std::filesystem::is_regular_file(file)) return;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return;
  const char first = first_character(stream);
  // A scene is an object, or begins with a comment.
  if (first == 0 || first == '{' || first == '/') return;
  const bool is_list = file.extension() == ".vrt";
  throw Error(
      ErrorKind::bad_data,
      fmt::format("{}: this is neither a scene, which is JSON, nor elevation data of a known "
                  "format{}; `gdal_translate {} land.tif` turns most others into one",
                  file.string(), is_list ? ": a VRT only names other files" : "",
                  file.filename().string()));
}

}  // namespace aerostat::staging

#include "cli/parse.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/duration.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace aerostat::cli {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

[[noreturn]] void refuse_crop(const std::string& text, const char* why) {
  throw Error(ErrorKind::usage,
              fmt::format("--crop: '{}' {}; expected x0,y0,x1,y1 in whole pixels with x0 < x1 and "
                          "y0 < y1, such as 0,0,640,360",
                          text, why));
}

[[noreturn]] void refuse_seeds(const std::string& text, const std::string& why) {
  throw Error(
      ErrorKind::usage,
      fmt::format("--seeds: '{}' {}; expected whole numbers from 0 to 4294967295 and ranges "
                  "of them, such as 1,5,9-11",
                  text, why));
}

/// Returns the first and last seed of a text such as "7" or "9-11", or nothing if it is neither
/// form.
std::optional<std::pair<std::uint32_t, std::uint32_t>> seed_range(std::string_view part) {
  const auto number = [](std::string_view digits) -> std::optional<std::uint32_t> {
    std::uint32_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
  };
  const auto dash = part.find('-');
  const auto first = number(part.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : number(part.substr(dash + 1));
  if (!first || !last) return std::nullopt;
  return std::pair{*first, *last};
}

/// Returns the file name's ending that gives a file's format. It is "." and `format` if that is
/// given, or else the ending of `path`. It is `usual` for standard output and for a special file
/// without an ending, such as /dev/null.
std::string ending_of(const std::filesystem::path& path, const std::string& format,
                      const char* usual) {
  if (!format.empty()) return "." + format;
  const std::string ending = lower(path.extension().string());
  const bool has_none = is_standard(path) || (ending.empty() && is_special_file(path));
  return has_none ? usual : ending;
}

std::optional<int> exponent_of_unit(const std::string& unit) {
  static constexpr std::string_view kUnits = "kmgt";
  if (unit.empty() || unit == "b") return 0;
  const auto place = kUnits.find(unit[0]);
  const std::string rest = unit.substr(1);
  if (place == std::string_view::npos || !(rest.empty() || rest == "b" || rest == "ib")) {
    return std::nullopt;
  }
  return 10 * (static_cast<int>(place) + 1);
}

}  // namespace

render::Crop parse_crop(const std::string& text) {
  std::array<int, 4> values{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc{} || values[i] < 0) refuse_crop(text, "is not four whole numbers");
    at = next;
    const bool is_last = i + 1 == values.size();
    if (is_last ? at != end : at == end || *at != ',') {
      refuse_crop(text, "is not four whole numbers");
    }
    ++at;
  }
  const render::Crop crop{values[0], values[1], values[2], values[3]};
  if (crop.x0 >= crop.x1 || crop.y0 >= crop.y1) refuse_crop(text, "is empty");
  return crop;
}

void require_inside(const render::Crop& crop, int width, int height) {
  if (crop.x1 <= width && crop.y1 <= height) return;
  throw Error(ErrorKind::usage,
              fmt::format("--crop: {},{},{},{} reaches beyond the image of {} x {} pixels", crop.x0,
                          crop.y0, crop.x1, crop.y1, width, height));
}

std::uint64_t parse_byte_size(const std::string& text) {
  double number = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto exponent = exponent_of_unit(lower(std::string(rest, text.data() + text.size())));
  const double bytes = exponent ? std::ldexp(number, *exponent) : -1.0;
  const bool is_whole = exponent != 0 || bytes == std::trunc(bytes);
  if (error != std::errc{} || !is_whole || !(bytes >= 1.0) || bytes >= 0x1p63) {
    throw Error(ErrorKind::usage,
                fmt::format("--memory-limit: '{}' is not a size; expected whole bytes or a number "
                            "with K, M, G or T, such as 1.5G",
                            text));
  }
  return static_cast<std::uint64_t>(bytes);
}

double parse_duration(const std::string& text, const char* option) {
  if (const auto seconds = duration_s(text)) return *seconds;
  throw Error(ErrorKind::usage,
              fmt::format("{}: '{}' is not a time; expected seconds, or a number with s, m or h, "
                          "such as 90s",
                          option, text));
}

std::vector<std::uint32_t> parse_seeds(const std::string& text) {
  std::vector<std::uint32_t> seeds;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const auto range = seed_range(std::string_view(text).substr(start, end - start));
    if (!range) refuse_seeds(text, "is not a list of seeds");
    const auto [first, last] = *range;
    if (first > last)
      refuse_seeds(text, fmt::format("has a range from {} down to {}", first, last));
    const std::uint64_t total = seeds.size() + std::uint64_t{last} - first + 1;
    if (total > kMostTiles) refuse_seeds(text, fmt::format("is more than {} seeds", kMostTiles));
    for (std::uint64_t seed = first; seed <= last; ++seed) {
      seeds.push_back(static_cast<std::uint32_t>(seed));
    }
    start = end + 1;
  }
  return seeds;
}

PictureFormat picture_format(const std::filesystem::path& path, const std::string& format) {
  const std::string ending = ending_of(path, format, ".png");
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".exr") return PictureFormat::exr;
  if (ending == ".tif" || ending == ".tiff") return PictureFormat::geotiff;
  throw Error(
      ErrorKind::usage,
      fmt::format(
          "--output: '{}' has no ending of a known format; expected a name that ends in .png "
          "(8-bit picture), .exr (linear layers) or .tif (map), or --format",
          path.string()));
}

MeshFormat mesh_format(const std::filesystem::path& path, const std::string& format) {
  const std::string ending = ending_of(path, format, ".ply");
  if (ending == ".ply") return MeshFormat::ply;
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".glb") return MeshFormat::glb;
  if (ending == ".gltf") return MeshFormat::gltf;
  throw Error(ErrorKind::usage,
              fmt::format("--output: '{}' has no ending of a known format; expected a name "
                          "that ends in .ply, .obj, .glb or .gltf, or --format",
                          path.string()));
}

bool is_standard(const std::filesystem::path& path) {
  return path == "-";
}

std::filesystem::path default_picture(const std::filesystem::path& scene, const char* ending) {
  if (is_standard(scene)) {
    throw Error(ErrorKind::usage,
                "a scene from standard input gives the picture no name; expected --output with a "
                "name, or with - for standard output");
  }
  return scene.stem().string() + ending;
}

}  // namespace aerostat::cli

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/open.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

constexpr std::size_t kMostFiles = 4096;

constexpr std::array<std::string_view, 14> kElevations{".tif", ".tiff", ".hgt", ".zip", ".asc",
                                                       ".dt0", ".dt1",  ".dt2", ".dem", ".bil",
                                                       ".flt", ".nc",   ".grd", ".img"};
// These may be pictures that only accompany files of heights.
constexpr std::array<std::string_view, 5> kImages{".png", ".r16", ".r32", ".raw", ".exr"};

bool has_ending(const std::filesystem::path& path, std::span<const std::string_view> endings) {
  if (path.filename().string().starts_with('.')) return false;
  std::string ending = ending_of(path);
  if (ending == ".gz") ending = ending_of(path.stem());
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

std::vector<std::filesystem::path> elevation_files_in(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::directory_iterator entry(folder, code);
  std::vector<std::filesystem::path> elevations, images;
  for (; !code && entry != std::filesystem::directory_iterator(); entry.increment(code)) {
    std::error_code type_code;
    if (!entry->is_regular_file(type_code)) continue;
    if (has_ending(entry->path(), kElevations)) elevations.push_back(entry->path());
    if (has_ending(entry->path(), kImages)) images.push_back(entry->path());
    if (std::max(elevations.size(), images.size()) > kMostFiles) {
      refuse(folder, fmt::format("the folder has more than {} files of heights", kMostFiles));
    }
  }
  if (code) {
    throw Error(ErrorKind::io,
                fmt::format("{}: cannot read the folder: {}", folder.string(), code.message()));
  }
  std::vector<std::filesystem::path>& paths = elevations.empty() ? images : elevations;
  if (paths.empty()) refuse(folder, "the folder has no files of heights");
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace aerostat::elevation

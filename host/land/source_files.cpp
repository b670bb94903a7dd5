#include "land/source_files.hpp"

#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/open.hpp"

namespace aerostat::land {

std::vector<std::filesystem::path> source_files(const std::vector<std::filesystem::path>& sources) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& source : sources) {
    std::error_code code;
    if (!std::filesystem::is_directory(source, code)) {
      files.push_back(source);
      continue;
    }
    const std::vector<std::filesystem::path> found = elevation::elevation_files_in(source);
    if (found.empty()) {
      throw Error(ErrorKind::bad_data,
                  fmt::format("{}: the folder holds no file of heights", source.string()));
    }
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

}  // namespace aerostat::land

#include "film/scene_mark.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/checksum.hpp"
#include "core/file.hpp"
#include "film/program_mark.hpp"
#include "opencl/program.hpp"
#include "scene/io.hpp"
#include "scene/named_files.hpp"
#include "scene/scene.hpp"

namespace aerostat::film {
namespace {

namespace fs = std::filesystem;

std::string of_bytes(const fs::path& file) {
  return fmt::format("{} of {} bytes", file.filename().string(), file_stamp(file).bytes);
}

/// Replaces the name of a file or folder by what tells it from others on every machine.
void settle_name(std::string& name) {
  const fs::path path(name);
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    name = of_bytes(path);
    return;
  }
  std::vector<std::string> files;
  for (fs::directory_iterator at(path, error), end; !error && at != end; at.increment(error)) {
    files.push_back(of_bytes(at->path()));
  }
  std::sort(files.begin(), files.end());
  name = fmt::format("folder of {}", fmt::join(files, ", "));
}

}  // namespace

std::uint64_t scene_checksum(scene::Scene scene) {
  for (std::string* name : scene::named_files(scene)) settle_name(*name);
  return checksum(scene::write_text(scene));
}

std::string still_mark(const scene::Scene& scene) {
  return fmt::format("{} {:016x}", program_mark(opencl::kernel_sources()), scene_checksum(scene));
}

}  // namespace aerostat::film

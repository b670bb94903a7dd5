#include "scene/installed.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/environment.hpp"

namespace aerostat::scene {

namespace fs = std::filesystem;

namespace {

constexpr const char* kExtension = ".json";

std::string first_comment(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  if (line.rfind("//", 0) != 0) return "";
  const auto start = line.find_first_not_of("/ ");
  return start == std::string::npos ? "" : line.substr(start);
}

bool is_scene(const fs::path& path) {
  const std::string name = path.filename().string();
  return path.extension() == kExtension && name.find(".schema.") == std::string::npos;
}

}  // namespace

fs::path installed_folder() {
  if (const auto folder = environment_variable("AEROSTAT_SCENE_DIR")) return *folder;
  std::error_code problem;
  const fs::path program = fs::read_symlink("/proc/self/exe", problem);
  return program.parent_path().parent_path() / "share/aerostat/scenes";
}

std::vector<InstalledScene> installed_scenes() {
  std::vector<InstalledScene> scenes;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(installed_folder(), problem)) {
    if (!is_scene(entry.path())) continue;
    scenes.push_back({entry.path().stem().string(), first_comment(entry.path())});
  }
  std::sort(scenes.begin(), scenes.end(),
            [](const InstalledScene& a, const InstalledScene& b) { return a.name < b.name; });
  return scenes;
}

fs::path find_scene(const fs::path& given) {
  std::error_code problem;
  if (given.has_parent_path() || given.has_extension() || fs::exists(given, problem)) return given;
  const fs::path installed = installed_folder() / (given.string() + kExtension);
  return !given.empty() && fs::exists(installed, problem) ? installed : given;
}

}  // namespace aerostat::scene

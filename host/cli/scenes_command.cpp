#include <algorithm>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "scene/installed.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {

int scenes(const ScenesOptions& options) {
  const std::string folder = scene::installed_folder().string();
  if (options.folder) {
    write_stdout(folder + "\n");
    return 0;
  }
  const auto scenes = scene::installed_scenes();
  if (scenes.empty()) {
    throw Error(ErrorKind::io, fmt::format("{}: expected scenes there, found none; set "
                                           "AEROSTAT_SCENE_DIR to the folder that has them",
                                           folder));
  }
  std::size_t width = 0;
  for (const auto& one : scenes) width = std::max(width, one.name.size());
  std::string text;
  for (const auto& one : scenes) {
    text += one.description.empty() ? one.name + "\n"
                                    : fmt::format("{:<{}}  {}\n", one.name, width, one.description);
  }
  write_stdout(text);
  return 0;
}

}  // namespace aerostat::cli

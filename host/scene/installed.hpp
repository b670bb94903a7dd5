#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// These functions find the scenes that are installed with the program.
namespace aerostat::scene {

/// Returns the folder of the installed scenes. It is the folder that AEROSTAT_SCENE_DIR names, or
/// else share/aerostat/scenes beside the folder of the executable. The folder need not exist.
std::filesystem::path installed_folder();

struct InstalledScene {
  std::string name;         // the name that find_scene takes, such as "snow"
  std::string description;  // the comment in the first line of the file, or empty
};

/// Returns all installed scenes, sorted by name. Returns none if the folder does not exist.
std::vector<InstalledScene> installed_scenes();

/// Returns the file that a user's word for a scene means. It is `given` if that exists. Otherwise
/// it is the installed scene of that name, if `given` is a bare name without an extension and
/// such a scene exists. In all other cases it is `given`.
std::filesystem::path find_scene(const std::filesystem::path& given);

}  // namespace aerostat::scene

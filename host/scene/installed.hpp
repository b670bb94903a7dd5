#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The scenes that come with the program.
namespace aerostat::scene {

/// Where they are: the folder that AEROSTAT_SCENE_DIR names, or else share/aerostat/scenes beside
/// the folder of the executable. It need not exist.
std::filesystem::path installed_folder();

struct InstalledScene {
  std::string name;         // what find_scene takes, such as "snow"
  std::string description;  // the comment in its first line; may be empty
};

/// All of them by name; none if there is no such folder.
std::vector<InstalledScene> installed_scenes();

/// The file that a user's word for a scene means: `given` if it exists, or else, if it is a bare
/// name without extension, the installed scene of that name; `given` if there is none either.
std::filesystem::path find_scene(const std::filesystem::path& given);

}  // namespace aerostat::scene

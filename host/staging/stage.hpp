#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "land/land.hpp"
#include "scene/io.hpp"
#include "scene/source.hpp"
#include "terrain/relief_cache.hpp"

/// Fills in what a scene on real land leaves open. A file of heights alone is enough for a picture.
namespace aerostat::staging {

/// A scene, and what was chosen for it.
struct Staged {
  scene::SceneSource source;
  /// Whole sentences for the user: what was found in the files, and what was chosen.
  std::vector<std::string> notes;
  /// The values that were chosen, in the order in which they were set.
  std::vector<scene::Override> chosen = {};
  /// The elevation data, or null if the scene has none.
  std::shared_ptr<const land::Land> land = nullptr;
};

/// Returns the scene with its open values chosen, if its ground is elevation data; other scenes
/// stay as they are. What the scene gives always wins. Chosen are
/// - the place, the balloon's position and the camera, by the measure of choose_views,
/// - the date and time of a September morning, as a sun that lights the view from the side,
/// - the biome, the snow line and the tree line, by latitude, height and season,
/// - whether there is a sea, the size of the ground, and the height of clouds.
/// `view` counts the chosen views from 0, the best one; if there are fewer, the last one counts.
/// Throws the errors of land::Land.
Staged stage(const scene::SceneSource& source, terrain::ReliefCache& reliefs, int view = 0);

/// Returns the scene with each of the `count` best views, the best one first. There are fewer, but
/// at least one, if the land has fewer views, if the scene gives its camera, or if it is not on
/// real land.
std::vector<Staged> stage_views(const scene::SceneSource& source, terrain::ReliefCache& reliefs,
                                int count);

/// Returns a scene around a file or folder of elevation data that gives nothing but its source.
scene::SceneSource scene_around(const std::filesystem::path& file);

/// Reads the land of a file or folder of elevation data. Throws the errors of terrain::real_land().
std::shared_ptr<const land::Land> land_of(const std::filesystem::path& file);

}  // namespace aerostat::staging

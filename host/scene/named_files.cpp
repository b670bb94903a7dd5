#include "scene/named_files.hpp"

#include <algorithm>

#include "scene/balloons.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {

std::vector<std::string*> named_files(Scene& scene) {
  std::vector<std::string*> names;
  for (std::string& name : scene.terrain.source) names.push_back(&name);
  names.push_back(&scene.terrain.drape.file);
  names.push_back(&scene.terrain.cover.source);
  for (Balloon* balloon : all_balloons(scene)) {
    if (balloon->track) names.push_back(&balloon->track->file);
    for (Artwork& artwork : balloon->artwork) names.push_back(&artwork.file);
    if (balloon->envelope) names.push_back(&balloon->envelope->file);
  }
  for (PlacedModel& model : scene.objects) names.push_back(&model.file);
  for (PlantSpecies& species : scene.vegetation.species) names.push_back(&species.file);
  std::erase_if(names, [](const std::string* name) { return name->empty(); });
  return names;
}

}  // namespace aerostat::scene

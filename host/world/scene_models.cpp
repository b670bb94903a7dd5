#include "world/scene_models.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "asset/read.hpp"
#include "core/error.hpp"
#include "core/grouped.hpp"
#include "core/log.hpp"
#include "material.h"
#include "scene/balloons.hpp"
#include "scene/scene.hpp"

namespace aerostat::world {
namespace {

/// Sizes beyond these make no sense in a landscape.
constexpr double kLeastSize_m = 0.01, kMostSize_m = 10'000.0;

/// Returns a length with as many decimals as it deserves.
std::string metres(double length) {
  if (length >= 100.0) return fmt::format("{:.0f}", length);
  if (length >= 1.0) return fmt::format("{:.1f}", length);
  return fmt::format("{:.2g}", length);
}

double largest(const dvec3& size) {
  return std::max({size.x, size.y, size.z});
}

/// Returns what mends a size that makes no sense, or nothing.
std::string advice(const dvec3& size) {
  const char* what = largest(size) < kLeastSize_m  ? "less than 1 cm"
                     : largest(size) > kMostSize_m ? "more than 10 km"
                                                   : nullptr;
  if (what == nullptr) return {};
  return fmt::format(
      " That is {}: \"height_m\" sets the height in metres, and \"scale\" the metres for each unit "
      "of the file.",
      what);
}

std::string name_of(const FileModel& model) {
  return model.key.file.filename().string();
}

}  // namespace

double scale_of(const scene::PlacedModel& placed, const FileModel& model) {
  if (placed.height_m && model.size.y > 0.0) return *placed.height_m / model.size.y;
  return placed.scale;
}

std::string size_note(const scene::PlacedModel& placed, const FileModel& model) {
  const dvec3 size = model.size * scale_of(placed, model);
  return fmt::format("{}: {} x {} x {} m (width, height, depth), {} triangles.{}", name_of(model),
                     metres(size.x), metres(size.y), metres(size.z), grouped(model.triangles),
                     advice(size));
}

std::shared_ptr<const SceneModels> ModelCache::models_of(const scene::Scene& scene) {
  Keys keys;
  for (const scene::PlacedModel& placed : scene.objects) {
    keys.objects.push_back({placed.file, placed.up});
  }
  for (const scene::PlantSpecies& species : scene.vegetation.species) {
    keys.species.push_back({species.file, species.up});
  }
  for (const scene::Balloon* balloon : scene::balloons_of(scene)) {
    const auto& envelope = balloon->envelope;
    keys.envelopes.push_back(envelope ? ModelKey{envelope->file, envelope->up} : ModelKey{});
  }
  // The models of the last scene stay while those of the next one are made.
  std::shared_ptr<const SceneModels> before;
  {
    const std::lock_guard lock(mutex_);
    before = held_;
  }
  const auto models = last_.get(keys, [&] { return make(keys); });
  const std::lock_guard lock(mutex_);
  held_ = models;
  tell(scene, *models);
  return models;
}

int ModelCache::files_read() const {
  const std::lock_guard lock(mutex_);
  return files_read_;
}

std::shared_ptr<const SceneModels> ModelCache::make(const Keys& keys) {
  auto set = std::make_shared<SceneModels>();
  std::map<ModelKey, std::size_t> number;
  const auto number_of = [&](const ModelKey& key) {
    const auto [entry, is_new] = number.try_emplace(key, set->models.size());
    if (is_new) {
      set->models.push_back(model(key));
      set->first_material.push_back(set->material_count);
      set->material_count += static_cast<std::uint32_t>(set->models.back()->materials.size());
    }
    return entry->second;
  };
  for (const ModelKey& key : keys.objects) set->of_object.push_back(number_of(key));
  for (const ModelKey& key : keys.species) {
    set->of_species.push_back(number_of(key));
    if (set->models[set->of_species.back()]->size.y > 0.0) continue;
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found a flat model, expected one with a height for a species of "
                            "plants",
                            key.file.string()));
  }
  for (const ModelKey& key : keys.envelopes) {
    set->envelopes.push_back(key.file.empty() ? nullptr : model(key));
  }
  if (set->material_count > AERO_MAX_FILE_MATERIALS) {
    throw Error(ErrorKind::bad_data,
                fmt::format("/objects: found {} materials in the models of the scene, expected at "
                            "most {}; fewer files, or files with fewer materials, mend that",
                            set->material_count, AERO_MAX_FILE_MATERIALS));
  }
  return set;
}

/// Returns a model from those that are in use, or reads its file.
std::shared_ptr<const FileModel> ModelCache::model(const ModelKey& key) {
  {
    const std::lock_guard lock(mutex_);
    if (auto known = known_[key].lock()) return known;
  }
  asset::ReadOptions options;
  options.up = key.up == scene::UpAxis::z ? asset::Axis::z : asset::Axis::y;
  auto read = std::make_shared<const FileModel>(file_model(key, asset::read(key.file, options)));
  for (const std::string& note : read->notes) {
    warn(fmt::format("{}: {}", name_of(*read), note));
  }
  const std::lock_guard lock(mutex_);
  known_[key] = read;
  ++files_read_;
  return read;
}

/// Tells the size of each model that was not told before. Of a model that stands in several places,
/// the least and the greatest size are told.
void ModelCache::tell(const scene::Scene& scene, const SceneModels& models) {
  for (std::size_t i = 0; i < models.of_species.size(); ++i) {
    const scene::PlantSpecies& species = scene.vegetation.species[i];
    scene::PlacedModel placed;
    if (species.height_m) placed.height_m = species.height_m->y * scene.vegetation.size;
    const std::string note = size_note(placed, *models.models[models.of_species[i]]);
    if (told_.insert(note).second) warn(note);
  }
  for (std::size_t i = 0; i < models.models.size(); ++i) {
    const scene::PlacedModel *least = nullptr, *most = nullptr;
    const FileModel& model = *models.models[i];
    for (std::size_t k = 0; k < models.of_object.size(); ++k) {
      if (models.of_object[k] != i) continue;
      const scene::PlacedModel& placed = scene.objects[k];
      if (least == nullptr || scale_of(placed, model) < scale_of(*least, model)) least = &placed;
      if (most == nullptr || scale_of(placed, model) > scale_of(*most, model)) most = &placed;
    }
    for (const scene::PlacedModel* placed : {least, most}) {
      if (placed == nullptr) continue;  // The model is only a species of plants.
      std::string note = size_note(*placed, model);
      if (told_.insert(note).second) warn(note);
    }
  }
}

}  // namespace aerostat::world

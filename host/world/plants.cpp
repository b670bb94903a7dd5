#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <oneapi/tbb/parallel_for.h>

#include "scatter/circles.hpp"
#include "scatter/sight.hpp"
#include "scene/at_rest.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"
#include "terrain/cover.hpp"
#include "terrain/drape.hpp"
#include "terrain/height_field.hpp"
#include "world/kinds.hpp"
#include "world/scene_models.hpp"
#include "world/strewn.hpp"

namespace aerostat::world {
namespace {

constexpr std::uint32_t kDetails = 4;

Object object_of(plant::Species species) {
  switch (species) {
    case plant::Species::boulder:
    case plant::Species::snowy_boulder:
    case plant::Species::driftwood:
      return {scene::ObjectId::stone, scene::MaterialId::stone, {}};
    default:
      return {scene::ObjectId::plant, scene::MaterialId::plant, {}};
  }
}

/// Makes each instance's model that of its detail: details of a model are numbered one after the
/// other.
void choose_details(const scene::ResolvedScene& scene, const std::vector<plant::ModelKey>& models,
                    std::vector<scatter::Instance>& instances) {
  const scene::PixelSize pixel = scene::pixel_size(*scene);
  const dvec3 eye = scene.eye() - scene.origin();
  tbb::parallel_for(std::size_t{0}, instances.size(), [&](std::size_t i) {
    scatter::Instance& instance = instances[i];
    // A species from a file has one detail, and follows those of the others.
    if (instance.model >= models.size()) {
      instance.model += static_cast<std::uint32_t>(models.size() * (kDetails - 1));
      return;
    }
    const plant::Detail detail = scatter::detail_of(instance, models[instance.model], eye, pixel);
    instance.model = instance.model * kDetails + static_cast<std::uint32_t>(detail);
  });
}

/// A picture on the ground shows the plants that are there, so that none are made where it covers
/// more than half of the ground's own colours.
void clear_pictures(const GroupInput& input, std::vector<scatter::Instance>& instances) {
  constexpr double kMostly = 0.5;
  const scene::ResolvedScene& scene = input.request.scene;
  const double blend = scene->terrain.drape.blend;
  if (blend <= kMostly) return;
  const auto drape = terrain::drape_of(scene->terrain, input.reliefs);
  if (!drape) return;
  const dvec3 origin = scene::place_of(*scene, scene.origin());
  std::erase_if(instances, [&](const scatter::Instance& instance) {
    const dvec3 place = origin + dvec3(instance.position);
    return blend * static_cast<double>(drape->at(place.x, place.z, 0.0).w) > kMostly;
  });
}

/// Returns land cover as plants look it up.
CoverLookup cover_lookup(const land::Cover* cover) {
  if (cover == nullptr) return {};
  const double cell_m = cover->ground().texel_m;
  return {[cover, cell_m](double x, double z) { return cover->at(x, z, cell_m); },
          static_cast<float>(cell_m)};
}

/// Plants do not stand in lakes and rivers.
void clear_water(const GroupInput& input, std::vector<scatter::Instance>& instances) {
  const terrain::HeightField field(input.local.terrain, input.request.carving, input.reliefs);
  if (!field.has_water()) return;
  std::vector<char> stands(instances.size());
  tbb::parallel_for(std::size_t{0}, instances.size(), [&](std::size_t i) {
    const vec3& p = instances[i].position;
    const auto level = field.water_level(p.x, p.z);
    stands[i] = level && static_cast<double>(p.y) < *level ? 0 : 1;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (stands[i] != 0) instances[kept++] = instances[i];
  }
  instances.resize(kept);
}

/// Plants leave room for models that are strewn over an area.
void clear_strewn(const GroupInput& input, std::vector<scatter::Instance>& instances) {
  // The room around a model, as a share of its width and in metres. Chosen by eye.
  constexpr double kShare = 0.6, kMargin_m = 1.0;
  const auto all = strew(input, scatter::Surface(*input.ground));
  if (all.empty()) return;
  scatter::Circles circles;
  for (const Strewn& strewn : all) {
    const FileModel& model = input.request.models->model_of(strewn.object);
    const double width = std::hypot(model.size.x, model.size.z);
    for (const scatter::Instance& one : strewn.instances) {
      const double radius_m = kShare * static_cast<double>(one.scale) * width + kMargin_m;
      circles.add({{one.position.x, one.position.z}, radius_m});
    }
  }
  circles.index();
  std::erase_if(instances, [&circles](const scatter::Instance& instance) {
    return circles.hold({instance.position.x, instance.position.z});
  });
}

/// Returns the sizes of the species from files.
std::vector<scatter::SpeciesModel> sizes_of(const SceneModels& models) {
  std::vector<scatter::SpeciesModel> sizes;
  for (const std::size_t number : models.of_species) {
    const dvec3& size = models.models[number]->size;
    sizes.push_back({size.y, std::hypot(size.x, size.z)});
  }
  return sizes;
}

/// Returns the model of a species from a file. In pictures with ids it is a plant.
InstanceModel species_model(const SceneModels& models, std::size_t species) {
  const std::size_t number = models.of_species[species];
  Objects parts = *models.models[number]->parts;
  for (Object& part : parts) part.id = scene::ObjectId::plant;
  InstanceModel model = instance_model(std::move(parts));
  model.first_file_material = models.first_material[number];
  return model;
}

Shape build(const GroupInput& input) {
  const scene::ResolvedScene& scene = input.request.scene;
  const std::shared_ptr<const land::Cover> cover = terrain::cover_of(scene->terrain, input.reliefs);
  const CoverLookup lookup = cover_lookup(cover.get());
  const SceneModels& models = *input.request.models;
  const auto species = sizes_of(models);
  scatter::Growth growth =
      scatter::scatter(scene, *input.ground, input.request.where, input.request.obstacles,
                       cover ? &lookup : nullptr, species);
  clear_pictures(input, growth.instances);
  clear_water(input, growth.instances);
  clear_strewn(input, growth.instances);
  choose_details(scene, growth.models, growth.instances);
  Instances plants;
  plants.places = std::move(growth.instances);
  const std::size_t own = growth.models.size() * kDetails;
  std::vector<std::uint32_t> number(own + species.size(), 0);
  for (const scatter::Instance& instance : plants.places) number[instance.model] = 1;
  std::vector<std::uint32_t> used;
  for (std::uint32_t k = 0; k < number.size(); ++k) {
    if (number[k] == 0) continue;
    number[k] = static_cast<std::uint32_t>(used.size());
    used.push_back(k);
  }
  plants.models.resize(used.size());
  tbb::parallel_for(std::size_t{0}, used.size(), [&](std::size_t i) {
    if (used[i] >= own) {
      plants.models[i] = species_model(models, used[i] - own);
      return;
    }
    const plant::ModelKey& key = growth.models[used[i] / kDetails];
    const auto detail = static_cast<plant::Detail>(used[i] % kDetails);
    Object model = object_of(key.species);
    model.mesh = plant::build(key, detail);
    plants.models[i] = instance_model({std::move(model)});
  });
  for (scatter::Instance& instance : plants.places) instance.model = number[instance.model];
  return plants;
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  if (now.where == scatter::Where::in_sight && !scatter::same_sight(now.scene, before.scene)) {
    return false;
  }
  if (!same_strewn(*now.scene, *before.scene)) return false;
  // The numbers of the materials of species go by all models of the scene.
  if (!now.models->of_species.empty() && now.models != before.models) return false;
  if (!scatter::same_room(now.scene, *now.ground, now.obstacles, before.obstacles)) return false;
  const scene::Scene &a = *now.scene, &b = *before.scene;
  return a.vegetation == b.vegetation && scene::at_rest(a.biome) == scene::at_rest(b.biome) &&
         a.terrain.drape == b.terrain.drape && a.camera.position == b.camera.position &&
         scene::point_of_view(a.camera) == scene::point_of_view(b.camera) &&
         scene::pixel_size(a) == scene::pixel_size(b);
}

}  // namespace

const GroupKind kPlants{
    .name = "plants", .footing = Footing::on_ground, .build = build, .same = same};

}  // namespace aerostat::world

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "scene/balloon.hpp"
#include "scene/film.hpp"
#include "scene/land.hpp"
#include "scene/light.hpp"
#include "scene/objects.hpp"
#include "scene/picture.hpp"
#include "scene/placed_model.hpp"

/// The scene description holds all values of a scene file, with every default filled in. Names,
/// units and nesting are those of the JSON, so that reading and writing lose nothing. Lengths are
/// in metres, angles in degrees with `_deg` in the name, and colours in linear Rec. 709. Who needs
/// only a part of a scene includes the header of that part.
namespace aerostat::scene {

struct Scene {
  Biome biome;
  Terrain terrain;
  Vegetation vegetation;
  Balloon balloon;
  std::vector<Balloon> balloons;  // further balloons
  Festival festival;              // and still more of them
  std::vector<PlacedModel> objects;
  Camera camera;
  Mood mood = Mood::none;
  Sun sun;
  Moon moon;
  Stars stars;
  std::vector<PointLight> lights;
  Sky sky;
  Air air;
  Haze haze;
  Fog fog;
  std::array<Material, kMaterialCount> materials;  // indexed by MaterialId
  Surfaces surfaces = Surfaces::full;
  Shading shading = Shading::phong;
  Integrator light = Integrator::local;
  int bounces = 6;  // of paths between surfaces
  Quality quality = Quality::standard;
  Image image;
  Film film;

  Material& material(MaterialId id) { return materials[static_cast<std::size_t>(id)]; }
  const Material& material(MaterialId id) const { return materials[static_cast<std::size_t>(id)]; }
};

}  // namespace aerostat::scene

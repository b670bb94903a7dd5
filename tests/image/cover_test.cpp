// Tests that land cover colours the ground where it says.
#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>

#include "real_land.hpp"
#include "support/temporary_folder.hpp"
#include "world/kinds.hpp"
#include "world/world.hpp"

namespace aerostat::test {
namespace {

/// A level plain, seen from straight above, whose north-west is built up and whose north-east is
/// under snow by land cover.
scene::Scene covered_plain(const TemporaryFolder& folder) {
  const auto heights = folder.path() / "land.asc", codes = folder.path() / "cover.asc";
  write_land(heights, 41, 30.0, [](double, double) { return 100.0; });
  write_land(codes, 41, 30.0, [](double east, double north) {
    return north < 0.0 ? 0.0 : east < 0.0 ? 50.0 : 70.0;
  });
  scene::Scene scene = bare_land(heights, 1000.0, 64);
  scene.terrain.cover.source = codes.string();
  scene.terrain.cover.crs = kCrs;
  scene.terrain.cover.scheme = CoverScheme::worldcover;
  scene.terrain.cover.classes = {{0, CoverClass::meadow}};
  scene.biome.ground.snow_line_m = 1e6;
  scene.camera = {};
  scene.camera.lens = scene::Lens::orthographic;
  scene.camera.position = {0.0, 2000.0, 0.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.view_height_m = 800.0;
  scene.image.width = scene.image.height = 64;
  return scene;
}

double brightness(const image::Film& film, int x, int y) {
  dvec3 sum(0.0);
  for (int j = y; j < y + 8; ++j)
    for (int i = x; i < x + 8; ++i) {
      sum += dvec3(film.radiance[static_cast<std::size_t>(j * film.width + i)]);
    }
  return sum.x + sum.y + sum.z;
}

TEST(Cover, ColoursTheGroundByItsClasses) {
  const TemporaryFolder folder;
  scene::Scene scene = covered_plain(folder);
  const image::Film film = shared_session().render(resolved(scene));
  const double built_up = brightness(film, 8, 8), snow = brightness(film, 48, 8);
  EXPECT_GT(snow, 2.5 * built_up);
  EXPECT_LT(snow, 8.0 * built_up);
  scene.terrain.cover.source.clear();
  const image::Film bare = shared_session().render(resolved(scene));
  EXPECT_LT(brightness(bare, 48, 8), 0.6 * snow);
}

/// Writes a model and returns its name.
std::string pyramid_in(const TemporaryFolder& folder) {
  const auto file = folder.path() / "pyramid.obj";
  std::ofstream(file) << "v 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\nv 1 3 1\n"
                         "f 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n";
  return file.string();
}

TEST(Cover, HoldsStrewnModelsToTheClassesOfTheirRule) {
  const TemporaryFolder folder;
  scene::Scene scene = covered_plain(folder);
  scene::PlacedModel& placed = scene.objects.emplace_back();
  placed.file = pyramid_in(folder);
  placed.count = 200;
  placed.area = scene::PlacedArea();
  const auto places = [&scene] {
    const world::World world = world::build(resolved(scene));
    const auto* models = world::shape_of<world::Instances>(world, world::kModels);
    return models->places;
  };
  // All of the area has some land cover.
  EXPECT_EQ(places().size(), 200u);
  placed.area->cover = {CoverClass::built_up};
  auto found = places();
  EXPECT_EQ(found.size(), 200u);
  for (const auto& one : found) {
    EXPECT_LT(one.position.x, 30.0f) << "cells are 30 m wide";
    EXPECT_LT(one.position.z, 30.0f);
  }
  placed.area->cover = {CoverClass::snow, CoverClass::built_up};
  found = places();
  for (const auto& one : found) EXPECT_LT(one.position.z, 30.0f);
  const auto is_east = [](const auto& one) { return one.position.x > 30.0f; };
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), is_east));
  placed.area->cover = {CoverClass::water, CoverClass::crops};
  EXPECT_TRUE(places().empty());
  placed.area->cover = {CoverClass::built_up};
  scene.terrain.cover.source.clear();
  EXPECT_TRUE(places().empty()) << "there is no land cover";
}

TEST(Cover, HoldsSpeciesOfPlantsToTheClassesOfTheirRule) {
  const TemporaryFolder folder;
  scene::Scene scene = covered_plain(folder);
  scene.vegetation.enabled = true;
  scene.vegetation.usual = false;
  scene.vegetation.reach_m = 3000.0;
  scene::PlantSpecies& species = scene.vegetation.species.emplace_back();
  species.file = pyramid_in(folder);
  species.grows = scene::PlantPlace::anywhere;
  species.cover = {CoverClass::snow};
  const world::World world = world::build(resolved(scene));
  const auto* plants = world::shape_of<world::Instances>(world, world::kPlants);
  int found = 0;
  for (const auto& one : plants->places) {
    const world::Objects& parts = *plants->models[one.model].parts;
    if (!parts[0].file_material) continue;  // a stone
    ++found;
    EXPECT_EQ(parts[0].id, scene::ObjectId::plant);
    // Shares go over from class to class within two cells.
    EXPECT_GT(one.position.x, -60.0f);
    EXPECT_LT(one.position.z, 60.0f);
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace aerostat::test

// Tests the furnace: an object that reflects all light cannot be seen under a sky that is even on
// all sides.
#include <algorithm>
#include <numbers>
#include <utility>

#include "flat_land.hpp"
#include "pack/pack_scene.hpp"
#include "render/device_worker.hpp"

namespace aerostat::test {
namespace {

constexpr int kWidth = 96, kHeight = 64, kSamples = 16;

const world::GroupKind kBalls{.name = "balls"};

/// Returns a ball of radius 1 m with smooth normals.
mesh::TriangleMesh ball(const vec3& centre) {
  constexpr std::uint32_t kRows = 24, kColumns = 48;
  mesh::TriangleMesh mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
      const float rise = kPi * (0.5f - static_cast<float>(row) / kRows);
      const vec3 n =
          direction_from_angles(2.0f * kPi * static_cast<float>(column) / kColumns, rise);
      mesh.positions.push_back(centre + n);
      mesh.normals.push_back(n);
      mesh.colors.emplace_back(1.0f);
      if (row == kRows || column == kColumns) continue;
      const std::uint32_t i = row * (kColumns + 1) + column;
      if (row > 0) mesh.triangles.emplace_back(i, i + 1, i + kColumns + 2);
      if (row + 1 < kRows) mesh.triangles.emplace_back(i, i + kColumns + 2, i + kColumns + 1);
    }
  }
  return mesh;
}

/// Returns a scene that looks at the origin from 6 m. The ground lies far below and out of sight.
scene::Scene furnace() {
  scene::Scene scene = flat_land();
  scene.terrain.base_m = -5000.0;
  scene.camera.position = {0.0, 0.0, 6.0};
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.image.width = kWidth;
  scene.image.height = kHeight;
  scene.image.spp = kSamples;
  scene.sky.ambient_occlusion = true;
  scene.sky.cloud_cover = 0.0;
  scene.sun.direction = glm::normalize(dvec3(0.3, 0.5, 0.4));
  return scene;
}

/// Returns light of radiance 1 from everywhere, without sun and air.
pack::PackedScene even_light(const scene::Scene& scene) {
  pack::PackedScene packed = pack::pack_scene(scene);
  AeroAir& air = packed.numbers.air;
  const AeroSkyCell one{{1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};
  std::fill(packed.sky_table.begin(), packed.sky_table.end(), one);
  for (auto& term : air.ambient) std::fill(std::begin(term), std::end(term), 0.0f);
  for (int c = 0; c < 3; ++c) {
    air.ambient[0][c] = packed.numbers.sky.sun_irradiance[c] = 1.0f;
    air.molecules[c] = air.haze_scattering[c] = air.haze_extinction[c] = 0.0f;
  }
  air.sun_heights[0] = 1e8f;
  air.sun_heights[1] = 2e8f;
  packed.numbers.sky.sun_cos = 1.0f;
  return packed;
}

/// Returns a scene that looks straight down on a white, level land.
scene::Scene white_land() {
  scene::Scene scene = flat_land();
  scene::Ground& ground = scene.biome.ground;
  ground.cover_a = ground.cover_b = ground.rock_a = ground.rock_b = vec3(1.0f);
  ground.snow = ground.beach = vec3(1.0f);
  scene.image.width = kWidth;
  scene.image.height = kHeight;
  scene.image.spp = kSamples;
  scene.sky.ambient_occlusion = true;
  return scene;
}

image::Film film_of(const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& balls) {
  world::World world = world::build(scene);
  world::Objects objects;
  for (const auto& mesh : balls)
    objects.push_back({scene::ObjectId::envelope, scene::MaterialId::envelope, mesh});
  world.groups.push_back(world::make_group(kBalls, std::move(objects)));
  const auto [tree, arrays] =
      render::only_frame(render::pack_world(std::move(world), nullptr, render::Meshes::release));

  render::DeviceWorker worker(devices().front(), {});
  worker.begin_programs();
  while (!worker.await_programs(std::chrono::milliseconds(100))) continue;
  worker.set_geometry(tree, arrays, {});
  scene::Scene white = scene;
  white.material(scene::MaterialId::envelope) = {};
  const render::Crop all{0, 0, kWidth, kHeight};
  worker.begin_frame(even_light(white), all.pixels());
  worker.begin_film(all);
  render::RowQueue queue(0, kHeight, 1);
  for (int sample = 0; sample < kSamples; ++sample) {
    queue.begin_pass();
    worker.trace({pack::pack_frame(scene), all, sample, 1, 0}, queue, 0,
                 [&](int) -> const render::FilmBuffer& { return worker.film(); }, {});
  }
  const render::FilmRows rows{0, kHeight, &worker.film()};
  return render::read_film(std::span(&rows, 1), {kWidth, kHeight, all, all}).film;
}

/// Expects a radiance of 1 in every pixel. Returns the number of pixels that an object covers.
int expect_nothing_seen(const image::Film& film) {
  int covered = 0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    covered += film.alpha[i] == 1.0f ? 1 : 0;
    const vec3 light = film.radiance[i];
    EXPECT_LT(glm::length(light - 1.0f), 2e-6f)
        << "pixel " << i % kWidth << ", " << i / kWidth << ": " << light.x;
    if (testing::Test::HasFailure()) break;
  }
  return covered;
}

TEST(Furnace, AWhiteBallInAnEvenSkyIsNotSeen) {
  EXPECT_GT(expect_nothing_seen(film_of(furnace(), {ball(vec3(0.0f))})), 400);
}

TEST(Furnace, AWhiteLandUnderAnEvenSkyIsNotSeen) {
  EXPECT_EQ(expect_nothing_seen(film_of(white_land(), {})), kWidth * kHeight);
}

/// Tests that two balls hide some of the sky from each other, so that the test above can fail.
TEST(Furnace, TwoBallsHideTheSkyFromEachOther) {
  const image::Film film =
      film_of(furnace(), {ball({-1.05f, 0.0f, 0.0f}), ball({1.05f, 0.0f, 0.0f})});
  float least = 1.0f;
  for (const vec3& light : film.radiance) least = std::min(least, light.y);
  EXPECT_LT(least, 0.8f);
}

}  // namespace
}  // namespace aerostat::test

// Tests that an independent ray tracer on the exported mesh, with the camera of the dump, agrees
// with the distances and objects of the film. 99.9 % of the pixels must agree within 0.1 %.
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "pictures.hpp"
#include "support/drape_files.hpp"

namespace aerostat::test {
namespace {

constexpr double kAgree = 0.999;
constexpr double kRelative = 1e-3;

struct Count {
  /// The number of pixels asked, and of those whose distances and objects agree.
  int asked = 0, distances = 0, objects = 0;

  double share(int agreed) const { return static_cast<double>(agreed) / asked; }
};

Count compare(const scene::Scene& scene, const image::Film& film,
              world::Placed instances = world::Placed::left_out) {
  const ExportedWorld world = exported_world(scene, instances);
  const Oracle oracle(world);
  const DumpedCamera camera(scene);
  Count count;
  for (int y = 0; y < film.height; y += Oracle::stride()) {
    for (int x = 0; x < film.width; x += Oracle::stride()) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                     static_cast<std::size_t>(x);
      const Oracle::Answer answer = oracle.nearest(camera.origin(x, y), camera.direction(x, y));
      const double found = film.distance_m[i];
      const bool same = std::isinf(answer.distance)
                            ? std::isinf(found)
                            : std::abs(found - answer.distance) <= kRelative * answer.distance;
      ++count.asked;
      count.distances += same ? 1 : 0;
      count.objects += film.object_id[i] == answer.object ? 1 : 0;
    }
  }
  return count;
}

class OracleAgrees : public testing::TestWithParam<const char*> {};

TEST_P(OracleAgrees, OnDistancesAndObjects) {
  const auto scene = small_scene(GetParam(), {320, 180, 1, 256});
  const Count count = compare(scene, shared_session().render(resolved(scene)));
  std::printf("%d pixels: %.3f %% of the distances, %.3f %% of the objects agree\n", count.asked,
              100.0 * count.share(count.distances), 100.0 * count.share(count.objects));
  EXPECT_GE(count.share(count.distances), kAgree);
  EXPECT_GE(count.share(count.objects), kAgree);
}

// Plants are instances of models in the film, and triangles of their own in the export.
TEST(Oracle, WithPlants) {
  for (const char* name : {"snow-basket", "tropical"}) {
    auto scene = planted_scene(name, {320, 180, 1, 256});
    scene.vegetation.reach_m = 1200.0;
    const image::Film film = shared_session().render(resolved(scene));
    const Count count = compare(scene, film, world::Placed::included);
    const auto plants =
        std::count_if(film.object_id.begin(), film.object_id.end(), [](std::uint32_t id) {
          return id == static_cast<std::uint32_t>(scene::ObjectId::plant) ||
                 id == static_cast<std::uint32_t>(scene::ObjectId::stone);
        });
    std::printf("%s: %td pixels of plants, %.3f %% of the distances agree\n", name, plants,
                100.0 * count.share(count.distances));
    EXPECT_GT(plants, 1000) << name;
    EXPECT_GE(count.share(count.distances), kAgree) << name;
    EXPECT_GE(count.share(count.objects), kAgree) << name;
  }
}

// Models are instances in the film, too. They are scaled, turned and far from the origin.
TEST(Oracle, WithModelsFromFiles) {
  const DrapeFolder folder;
  std::string text;
  for (int i = 0; i < 24; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / 24.0;
    text += fmt::format("v {} 0 {}\nv {} 3 {}\n", 2.0 * std::cos(turn), 2.0 * std::sin(turn),
                        std::cos(turn), std::sin(turn));
  }
  for (int i = 0; i < 24; ++i) {
    const int a = 2 * i + 1, b = (2 * i + 2) % 48 + 1;
    text += fmt::format("f {} {} {} {}\n", a, a + 1, b + 1, b);
  }
  auto scene = small_scene("snow", {320, 180, 1, 256});
  for (int i = 0; i < 12; ++i) {
    scene::PlacedModel& placed = scene.objects.emplace_back();
    placed.file = folder.write("cup.obj", text).string();
    const dvec3 ahead = *scene.camera.target - *scene.camera.position;
    const dvec3 aside = glm::normalize(glm::cross(ahead, dvec3(0, 1, 0)));
    placed.position = *scene.camera.position + (10.0 + 9.0 * i) * glm::normalize(ahead) +
                      (3.0 * (i % 5) - 6.0) * aside;
    placed.height_above = scene::HeightReference::sea;
    placed.position.y -= 2.0;
    placed.heading_deg = 40.0 * i - 180.0;
    placed.scale = 0.3 + 0.2 * i;
  }
  const image::Film film = shared_session().render(resolved(scene));
  const auto models = std::count(film.object_id.begin(), film.object_id.end(),
                                 static_cast<std::uint32_t>(scene::ObjectId::model));
  EXPECT_GT(models, 1000);
  const Count count = compare(scene, film);
  EXPECT_GE(count.share(count.distances), kAgree);
  EXPECT_GE(count.share(count.objects), kAgree);
}

TEST(Oracle, WithATiltedCameraOffTheMiddle) {
  auto scene = small_scene("snow", {173, 251, 1, 128});
  scene.camera.up = glm::normalize(dvec3(0.4, 1.0, 0.2));
  scene.camera.fov_y_deg = 95.0;
  const Count count = compare(scene, shared_session().render(resolved(scene)));
  EXPECT_GE(count.share(count.distances), kAgree);
  EXPECT_GE(count.share(count.objects), kAgree);
}

TEST(Oracle, WithAPanorama) {
  for (const char* name : {"snow", "tropical-basket"}) {
    auto scene = small_scene(name, {320, 160, 1, 128});
    scene.camera.lens = scene::Lens::panorama;
    const Count count = compare(scene, shared_session().render(resolved(scene)));
    EXPECT_GE(count.share(count.distances), kAgree) << name;
    EXPECT_GE(count.share(count.objects), kAgree) << name;
  }
}

TEST(Oracle, WithParallelRays) {
  auto scene = small_scene("sand", {320, 180, 1, 128});
  scene.camera.lens = scene::Lens::orthographic;
  for (const double height_m : {40.0, 900.0}) {
    scene.camera.view_height_m = height_m;
    scene.camera.position->y += height_m;
    const Count count = compare(scene, shared_session().render(resolved(scene)));
    EXPECT_GE(count.share(count.distances), kAgree) << height_m;
    EXPECT_GE(count.share(count.objects), kAgree) << height_m;
  }
}

TEST(Oracle, NotWithAnotherPicture) {
  auto scene = small_scene("snow", {160, 90, 1, 64});
  const image::Film film = shared_session().render(resolved(scene));
  scene.camera.fov_y_deg *= 1.02;
  const Count count = compare(scene, film);
  EXPECT_LT(count.share(count.distances), kAgree) << "the comparison sees nothing";
}

std::string test_name(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, OracleAgrees, testing::ValuesIn(kScenes), test_name);

}  // namespace
}  // namespace aerostat::test

// Tests that pictures far from the origin of the world's coordinates are as clean as those at the
// origin.
#include <algorithm>

#include "flat_land.hpp"
#include "scene/local_frame.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

const dvec3 kFar{1e6, 0.0, -1e6};

scene::Scene unresolved(const std::string& name) {
  scene::Scene scene =
      scene::read_file(std::string(AEROSTAT_SOURCE_DIR "/scenes/") + name + ".json",
                       {{"/image/width", "96"},
                        {"/image/height", "54"},
                        {"/quality", "\"standard\""},
                        {"/image/spp", "2"},
                        {"/terrain/cells", "256"},
                        {"/fog", R"({"enabled": true, "visibility_m": 20000, "top_m": 300})"},
                        {"/sky/cumulus/cover", "0.4"}});
  scene.vegetation.reach_m = 1000.0;
  scene::PointLight lamp;
  lamp.position = scene.balloon.position + dvec3(3.0, 300.0, 2.0);
  lamp.intensity = 500.0;
  scene.lights.push_back(lamp);
  return scene;
}

/// Moves everything in a scene by the same vector. Objects keep their places relative to each
/// other.
scene::Scene moved(scene::Scene scene, const dvec3& by) {
  scene.terrain.center += dvec2(by.x, by.z);
  scene.balloon.position += by;
  *scene.camera.position += by;
  *scene.camera.target += by;
  for (scene::PointLight& light : scene.lights) light.position += by;
  return scene;
}

image::Film render_resolved(const scene::Scene& scene) {
  return shared_session().render(world::resolve(scene));
}

class FarScene : public testing::TestWithParam<const char*> {};

// Tests that moving a scene keeps every bit. The sums with 1e6 are exact to 2^-33 m, which hardly
// ever changes a float.
TEST_P(FarScene, IsTheSamePictureToTheBit) {
  const scene::Scene scene = unresolved(GetParam());
  EXPECT_TRUE(same_bits(render_resolved(scene), render_resolved(moved(scene, kFar))));
}

/// Returns the mean difference of two pictures relative to their mean radiance.
double difference(const image::Film& a, const image::Film& b) {
  double apart = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    apart += glm::length(dvec3(a.radiance[i]) - dvec3(b.radiance[i]));
    sum += glm::length(dvec3(a.radiance[i]));
  }
  return apart / sum;
}

// Tests another origin of the meshes. Plants, patterns, waves, clouds, fog and light depend on
// places, so the origin changes nothing except the rounding. In a few places, rounding moves an
// edge or a shadow by a pixel. Sunlit wicker has the most of them: 0.8 % of the light.
TEST_P(FarScene, LooksTheSameFromAnotherOrigin) {
  const scene::ResolvedScene scene = world::resolve(unresolved(GetParam()));
  const image::Film film = shared_session().render(scene);
  const image::Film other = shared_session().render(scene.counted_from({4096.0, -4096.0, 8192.0}));
  EXPECT_FALSE(same_bits(film, other)) << "the origin is not used";
  EXPECT_LT(difference(film, other), 0.012);
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, FarScene,
                         testing::Values("snow", "tropical", "sand", "tropical-basket"),
                         [](const auto& name) {
                           std::string text = name.param;
                           std::replace(text.begin(), text.end(), '-', '_');
                           return text;
                         });

/// Returns a scene with a balloon at `where` over level land that is a thousand kilometres wide.
scene::Scene over_the_plain(const dvec3& where) {
  scene::Scene scene = flat_land();
  scene.terrain.size_m = 1e6;
  scene.balloon.enabled = true;
  scene.balloon.position = where + dvec3(0.0, 100.0, 0.0);
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.camera.position = where + dvec3(0.0, 102.0, 4.5);
  scene.camera.target = where + dvec3(0.0, 102.0, 0.0);
  scene.camera.fov_y_deg = 50.0;
  scene.terrain.base_m = where.y;
  scene.sun.irradiance = 3.0;
  scene.sun.direction = {0.4, 0.5, 0.6};
  scene.image.filter = scene::Filter::box;
  scene.image.width = 240;
  scene.image.height = 180;
  return scene;
}

double share_of(const image::Film& film, scene::ObjectId id) {
  const auto count =
      std::count(film.object_id.begin(), film.object_id.end(), static_cast<std::uint32_t>(id));
  return static_cast<double>(count) / static_cast<double>(film.object_id.size());
}

TEST(FarBalloon, KeepsItsRopesAndItsWicker) {
  const image::Film near = render_resolved(over_the_plain({0.0, 0.0, 0.0}));
  ASSERT_GT(share_of(near, scene::ObjectId::cables), 0.005);
  ASSERT_GT(share_of(near, scene::ObjectId::basket), 0.05);
  for (const dvec3& where :
       {dvec3(20000.0, 0.0, 0.0), dvec3(100000.0, 0.0, -100000.0), dvec3(-490000.0, 0.0, 490000.0),
        dvec3(1e6, 0.0, -1e6), dvec3(0.0, 100000.0, 0.0)}) {
    SCOPED_TRACE(testing::Message() << where.x << ", " << where.y << ", " << where.z);
    const image::Film film = render_resolved(over_the_plain(where));
    std::size_t others = 0, lit_otherwise = 0, balloon = 0;
    for (std::size_t i = 0; i < film.object_id.size(); ++i) {
      const bool same = film.object_id[i] == near.object_id[i];
      if (!same) ++others;
      if (!same || film.object_id[i] < static_cast<std::uint32_t>(scene::ObjectId::envelope)) {
        continue;
      }
      ++balloon;
      // Without air, light depends only on the balloon. Edges of shadows move by two millimetres,
      // the distance by which their rays are lifted off the surface. Rods of wicker 9.5 mm high
      // have such an edge each: 3.4 % of the balloon's pixels.
      const dvec3 a(film.radiance[i]), b(near.radiance[i]);
      lit_otherwise += glm::length(a - b) > 0.02 * glm::length(b) + 1e-4;
    }
    // Beyond the plain there is no ground.
    if (std::abs(where.x) < 5e5) {
      EXPECT_LT(others, film.object_id.size() / 200);
    }
    EXPECT_LT(lit_otherwise, balloon / 20);
    for (const auto id : {scene::ObjectId::cables, scene::ObjectId::basket}) {
      EXPECT_NEAR(share_of(film, id) / share_of(near, id), 1.0, 0.02) << scene::object_name(id);
    }
  }
}

/// Returns the basket seen by parallel rays from a distance of `distance_m`.
scene::Scene by_parallel_rays(double distance_m) {
  scene::Scene scene = over_the_plain({0.0, 0.0, 0.0});
  scene.terrain.size_m = 1000.0;
  scene.camera.lens = scene::Lens::orthographic;
  scene.camera.view_height_m = 5.0;
  scene.camera.target = {0.0, 101.5, 0.0};
  scene.camera.position = *scene.camera.target + distance_m * dvec3(0.6, 0.28, 0.75);
  return scene;
}

TEST(FarParallelRays, ShowTheSameAsNearOnes) {
  const image::Film near = render_resolved(by_parallel_rays(300.0));
  const image::Film far = render_resolved(by_parallel_rays(1e6));
  ASSERT_GT(share_of(near, scene::ObjectId::basket), 0.05);
  const dvec3 way(0.6, 0.28, 0.75);
  std::size_t others = 0;
  for (std::size_t i = 0; i < near.object_id.size(); ++i) {
    if (near.object_id[i] != far.object_id[i]) {
      ++others;
    } else if (near.object_id[i] != 0) {
      EXPECT_NEAR(far.distance_m[i] - near.distance_m[i], (1e6 - 300.0) * glm::length(way), 0.2);
    }
  }
  EXPECT_LT(others, near.object_id.size() / 200);
}

}  // namespace
}  // namespace aerostat::test

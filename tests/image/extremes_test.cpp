// Tests scenes with extreme numbers: cameras far away, under the ground and inside of things, tiny
// and huge lands, the sun at the zenith, below the horizon and over the poles, narrow and wide
// views, and pictures of odd shapes. Each film holds numbers that can be, and its distances agree
// with those of an independent ray tracer on the exported triangles.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "oracle.hpp"
#include "pictures.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

struct Extreme {
  const char* name;
  std::vector<scene::Override> changes;
};

std::vector<scene::Override> camera(const char* position, const char* target) {
  return {
      {"/camera/height_above", "sea"}, {"/camera/position", position}, {"/camera/target", target}};
}

std::vector<scene::Override> and_more(std::vector<scene::Override> changes,
                                      const std::vector<scene::Override>& more) {
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

const char* const kInside = "[0,510,0.5]";

const Extreme kExtremes[] = {
    {"a camera 1000 km away", camera("[1000000,2000,0]", "[0,1000,0]")},
    {"a camera 1700 km away, aslant", camera("[1000000,1000000,-1000000]", "[0,1000,0]")},
    {"a camera 1000 km up", camera("[0,1000000,0]", "[0,0,1]")},
    {"a camera under the ground", camera("[0,-500,0]", "[100,-500,0]")},
    {"a camera just under the ground, looking up", camera("[0,-3000,0]", "[0,0,1]")},
    {"a camera inside of the envelope",
     and_more(camera(kInside, "[0,512,4]"),
              {{"/balloon/height_above", "sea"}, {"/balloon/position", "[0,500,0]"}})},
    {"a camera inside of a cloud",
     and_more(camera("[0,1700,0]", "[0,1700,100]"),
              {{"/sky/cumulus/cover", "0.9"}, {"/sky/cumulus/base_m", "1500"}})},
    {"a land of 10 m", {{"/terrain/size_m", "10"}, {"/terrain/height_m", "1"}}},
    {"a land of 1000 km", {{"/terrain/size_m", "1000000"}}},
    {"a land of 1000 km from its rim",
     and_more(camera("[499000,9000,0]", "[0,0,0]"), {{"/terrain/size_m", "1000000"}})},
    {"a level land", {{"/terrain/height_m", "0"}}},
    {"a land of two cells", {{"/terrain/cells", "2"}}},
    {"the sun at the zenith", {{"/sun/elevation_deg", "90"}}},
    {"the sun at the horizon", {{"/sun/elevation_deg", "0"}}},
    {"the sun below the horizon", {{"/sun/elevation_deg", "-20"}}},
    {"the sun at the nadir", {{"/sun/elevation_deg", "-90"}}},
    {"the sun over the north pole",
     {{"/sun", R"({"date": "2024-06-21", "time": "12:00Z", "latitude_deg": 90,
                   "longitude_deg": 0})"}}},
    {"the night at the south pole",
     {{"/sun", R"({"date": "2024-06-21", "time": "12:00Z", "latitude_deg": -90,
                   "longitude_deg": 0})"}}},
    {"no light", {{"/sun/irradiance", "0"}}},
    {"a field of view of 1 degree", {{"/camera/fov_y_deg", "1"}}},
    {"a field of view of 170 degrees", {{"/camera/fov_y_deg", "170"}}},
    {"a picture of one pixel", {{"/image/width", "1"}, {"/image/height", "1"}}},
    {"a picture of one row", {{"/image/width", "32768"}, {"/image/height", "1"}}},
    {"a picture of one column", {{"/image/width", "1"}, {"/image/height", "32768"}}},
    {"paths in the last light", {{"/light", "path"}, {"/sun/elevation_deg", "0.1"}}},
    {"paths below a bright sun", {{"/light", "path"}, {"/sun/irradiance", "1000"}}}};

scene::Scene scene_of(const Extreme& extreme) {
  return scene::read_file(AEROSTAT_SOURCE_DIR "/scenes/snow.json",
                          and_more({{"/image/width", "96"},
                                    {"/image/height", "64"},
                                    {"/image/spp", "1"},
                                    {"/vegetation/enabled", "false"},
                                    {"/terrain/cells", "128"}},
                                   extreme.changes));
}

void expect_possible(const image::Film& film) {
  EXPECT_EQ(film.nan_pixels, 0u);
  ASSERT_FALSE(film.radiance.empty());
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const vec3& radiance = film.radiance[i];
    ASSERT_TRUE(is_finite(radiance)) << "pixel " << i;
    ASSERT_GE(std::min({radiance.x, radiance.y, radiance.z}), 0.0f) << "pixel " << i;
    ASSERT_LT(film.object_id[i], scene::kObjectCount) << "pixel " << i;
    ASSERT_EQ(film.object_id[i] == 0, std::isinf(film.distance_m[i])) << "pixel " << i;
    ASSERT_GE(film.distance_m[i], 0.0f) << "pixel " << i;
  }
}

/// Returns the share of the pixels whose distances agree with those of the oracle within 0.1 %.
/// With one sample, rays go through the middles of pixels. Exported positions count from the origin
/// of the scene.
double share_that_agrees(const scene::ResolvedScene& resolved, const image::Film& film) {
  const scene::Scene& scene = *resolved;
  const ExportedWorld world = exported_world(scene, world::Placed::left_out);
  const Oracle oracle(world);
  const DumpedCamera camera(scene);
  int asked = 0, same = 0;
  const int step_x = std::max(1, film.width / 128), step_y = std::max(1, film.height / 128);
  for (int y = 0; y < film.height; y += step_y) {
    for (int x = 0; x < film.width; x += step_x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                     static_cast<std::size_t>(x);
      const dvec3 eye = camera.origin(x, y) - resolved.origin();
      const double distance = oracle.nearest(eye, camera.direction(x, y)).distance;
      const double found = film.distance_m[i];
      const bool agree =
          std::isinf(distance) ? std::isinf(found) : std::abs(found - distance) <= 1e-3 * distance;
      ++asked;
      same += agree ? 1 : 0;
    }
  }
  return static_cast<double>(same) / asked;
}

TEST(Extremes, GiveNumbersThatCanBeAndTheRightDistances) {
  for (const Extreme& extreme : kExtremes) {
    SCOPED_TRACE(extreme.name);
    const scene::ResolvedScene scene = world::resolve(scene_of(extreme));
    const image::Film film = shared_session().render(scene);
    expect_possible(film);
    const double share = share_that_agrees(scene, film);
    std::printf("%s: %.2f %% of the distances agree\n", extreme.name, 100.0 * share);
    // A single ray of a row along the horizon may pass an edge on the other side.
    EXPECT_GE(share, 0.99);
  }
}

TEST(Extremes, APartOfAHugePictureTakesThatPartAlone) {
  const Extreme huge{"huge", {{"/image/width", "30000"}, {"/image/height", "30000"}}};
  const scene::ResolvedScene scene = world::resolve(scene_of(huge));
  const image::Film film =
      shared_session().render(scene, {}, {}, render::Crop{15000, 15000, 15040, 15020});
  EXPECT_EQ(film.width, 40);
  expect_possible(film);
}

}  // namespace
}  // namespace aerostat::test

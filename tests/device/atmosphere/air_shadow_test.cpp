// Tests the shadows of land and clouds in the air: the maps that the host makes, what the device
// reads from them, and the light of rays that pass shadows.
#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>

#include "clouds.hpp"
#include "core/copy.hpp"
#include "mesh/grid_mesh.hpp"
#include "pack/air_shadows.hpp"

namespace aerostat::test {
namespace {

constexpr float kAzimuth = 0.6f, kRise = 0.1f;
const vec2 kAlong(std::cos(kAzimuth), std::sin(kAzimuth));
const vec3 kPlace(40.0f, 7.0f, -90.0f);

/// A wall across the sun's azimuth on level ground, from this distance towards the sun on, and its
/// height, both from the ground and the point (0, 0) of the terrain.
constexpr float kWall = 500.0f, kThick = 60.0f, kHeight = 100.0f;

vec3 low_sun() {
  return glm::normalize(vec3(kAlong.x, kRise, kAlong.y));
}

/// Returns a level ground at sea level with the wall. Its vertices count from a point at kPlace.
mesh::GridMesh ground_with_wall() {
  std::vector<float> x, z;
  for (int i = 0; i <= 400; ++i) {
    x.push_back(static_cast<float>(10 * (i - 200)) - kPlace.x);
    z.push_back(static_cast<float>(10 * (i - 200)) - kPlace.z);
  }
  mesh::GridMesh ground(x, z);
  for (std::uint32_t j = 0; j < z.size(); ++j) {
    for (std::uint32_t i = 0; i < x.size(); ++i) {
      const float u = glm::dot(kAlong, vec2(x[i] + kPlace.x, z[j] + kPlace.z));
      const bool wall = u >= kWall && u <= kWall + kThick;
      ground.set(i, j, (wall ? kHeight : 0.0f) - kPlace.y, {0.0f, 1.0f, 0.0f});
    }
  }
  return ground;
}

pack::PackedScene with_shadows(pack::PackedScene packed, const mesh::GridMesh* ground,
                               const vec3& eye = vec3(0.0f)) {
  pack::ShadowCache cache;
  add_air_shadows(ground, 1, eye, cache, packed);
  return packed;
}

/// Returns the morning of a clear day with the wall in it, whose air is the same at all heights.
pack::PackedScene hazy_wall() {
  AeroScene scene = bare_scene();
  set3(scene.sky.sun_direction, low_sun());
  scene.sky.sun_shadows = 1;
  copy(scene.place, kPlace);
  scene.air.molecules_height = scene.air.haze_height = 1e7f;
  for (int i = 0; i < 3; ++i) {
    scene.air.molecules[i] = 1e-5f * static_cast<float>(i + 1);
    scene.air.haze_scattering[i] = 4e-4f;
    scene.air.haze_extinction[i] = 5e-4f;
  }
  const mesh::GridMesh ground = ground_with_wall();
  return with_shadows(with_even_sky(scene), &ground);
}

opencl::Buffer<std::uint32_t> texels_of(const pack::PackedScene& scene) {
  std::vector<std::uint32_t> words;
  for (const auto& part : scene.texels.parts()) {
    words.insert(words.end(), part.words.begin(), part.words.end());
  }
  return input(words);
}

class AirShadow : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  std::vector<float> lit(const pack::PackedScene& scene, const std::vector<vec3>& points) const {
    const std::size_t count = whole_packets(points.size());
    const auto share = output<float>(count);
    probe.run("probe_lit_in_air", count, uploaded(scene.numbers), texels_of(scene),
              input(planes(points)), share);
    auto values = share.read();
    values.resize(points.size());
    return values;
  }

  struct Light {
    vec3 added{0.0f}, shaded{0.0f};
  };

  /// Returns the mean light of rays from `origin` over many shifts.
  Light mean_light(const pack::PackedScene& scene, const vec3& origin, const vec3& direction,
                   float distance) const {
    constexpr std::size_t kShifts = 1024;
    std::vector<float> shifts(kShifts);
    for (std::size_t i = 0; i < kShifts; ++i) {
      shifts[i] = (static_cast<float>(i) + 0.5f) / static_cast<float>(kShifts);
    }
    const auto added = output<float>(3 * kShifts), shaded = output<float>(3 * kShifts);
    probe.run("probe_shaded_air", kShifts, uploaded(scene.numbers), texels_of(scene),
              input(planes(std::vector<vec3>(kShifts, origin))),
              input(planes(std::vector<vec3>(kShifts, direction))),
              input(std::vector<float>(kShifts, distance)), input(shifts), added, shaded);
    const auto add = added.read(), shade = shaded.read();
    Light mean;
    for (std::size_t i = 0; i < kShifts; ++i) {
      mean.added += from_planes(add, i) / static_cast<float>(kShifts);
      mean.shaded += from_planes(shade, i) / static_cast<float>(kShifts);
    }
    return mean;
  }
};

// The wall's shadow begins at it and ends where the sun's rays over its top have sunk to the height
// of the points.
TEST_P(AirShadow, OfAWallEndsWhereTheSunSeesOverIt) {
  const pack::PackedScene scene = hazy_wall();
  for (const float height : {5.0f, 20.0f, 60.0f, 99.0f, 120.0f}) {
    constexpr int kPoints = 4000;
    constexpr float kFrom = -1200.0f, kTo = 450.0f;
    std::vector<vec3> points;
    for (int i = 0; i < kPoints; ++i) {
      const float u = kFrom + (kTo - kFrom) * (static_cast<float>(i) + 0.5f) / kPoints;
      points.emplace_back(u * kAlong.x, height, u * kAlong.y);
    }
    const std::vector<float> share = lit(scene, points);
    const float mean = std::accumulate(share.begin(), share.end(), 0.0f) / kPoints;
    const float end = kWall - (kHeight - height) / kRise;
    const float expected = std::clamp((end - kFrom) / (kTo - kFrom), 0.0f, 1.0f);
    // The map's nodes are 11 m apart.
    EXPECT_NEAR(mean, expected, 12.0f / (kTo - kFrom)) << height;
  }
}

TEST_P(AirShadow, EndsAtTheRimOfTheLand) {
  const std::vector<vec3> beyond{{9000.0f, -50.0f, 0.0f}, {0.0f, -50.0f, -9000.0f}};
  EXPECT_EQ(lit(hazy_wall(), beyond), (std::vector<float>{1.0f, 1.0f}));
}

// In even air the light that reaches the eye from between two distances a and b is in proportion to
//   exp(-extinction a) - exp(-extinction b)
TEST_P(AirShadow, TakesTheLightOfItsPartOfTheRay) {
  const pack::PackedScene scene = hazy_wall();
  constexpr float kHigh = 20.0f, kStart = -1200.0f, kLength = 1600.0f;
  const vec3 origin(kStart * kAlong.x, kHigh, kStart * kAlong.y), ahead(kAlong.x, 0.0f, kAlong.y);
  const Light found = mean_light(scene, origin, ahead, kLength);
  const float begin = kWall - (kHeight - kHigh) / kRise - kStart;
  for (int i = 0; i < 3; ++i) {
    const float extinction = scene.numbers.air.molecules[i] + scene.numbers.air.haze_extinction[i];
    const float all = -std::expm1(-extinction * kLength);
    const float part = std::exp(-extinction * begin) - std::exp(-extinction * kLength);
    // All of this light is the sun's, because nothing is scattered twice here. Points are chosen by
    // the extinction of green.
    const float share = found.shaded[i] / (found.shaded[i] + found.added[i]);
    EXPECT_NEAR(share, part / all, 0.01f) << i;
  }
}

// In thick haze most of a step's light comes from its start.
TEST_P(AirShadow, TakesTheLightOfItsPartOfTheRayInThickHaze) {
  pack::PackedScene scene = hazy_wall();
  for (int i = 0; i < 3; ++i) scene.numbers.air.haze_extinction[i] = 4e-3f;
  constexpr float kHigh = 20.0f, kStart = -400.0f, kLength = 800.0f;
  const vec3 origin(kStart * kAlong.x, kHigh, kStart * kAlong.y), ahead(kAlong.x, 0.0f, kAlong.y);
  const Light found = mean_light(scene, origin, ahead, kLength);
  const float begin = kWall - (kHeight - kHigh) / kRise - kStart;
  const float extinction = scene.numbers.air.molecules[1] + scene.numbers.air.haze_extinction[1];
  const float part = std::exp(-extinction * begin) - std::exp(-extinction * kLength);
  const float share = found.shaded.y / (found.shaded.y + found.added.y);
  EXPECT_NEAR(share, part / -std::expm1(-extinction * kLength), 0.02f);
}

TEST_P(AirShadow, CostsARayOverItNoLight) {
  const Light over =
      mean_light(hazy_wall(), {0.0f, 130.0f, 0.0f}, {kAlong.x, 0.0f, kAlong.y}, 900.0f);
  EXPECT_EQ(over.shaded, vec3(0.0f));
  EXPECT_GT(over.added.x, 0.0f);
}

/// Tests that a sky ray loses the light of the part of its way that lies in shadow, and no more.
TEST_P(AirShadow, DarkensTheSkyBehindIt) {
  const pack::PackedScene scene = hazy_wall();
  const vec3 origin(-0.0f, 10.0f, 0.0f);
  const std::vector<vec3> directions{glm::normalize(vec3(kAlong.x, 0.05f, kAlong.y)),
                                     glm::normalize(vec3(-kAlong.x, 3.0f, -kAlong.y))};
  const std::size_t count = whole_packets(directions.size());
  const auto dark = output<float>(3 * count);
  probe.run("probe_sky_in_shadow", count, uploaded(scene.numbers), texels_of(scene),
            input(planes(std::vector<vec3>(count, origin))), input(planes(directions)), dark);
  const auto lost = dark.read();
  // Above the highest shadow there is none.
  const float top = scene.numbers.air.shadows.top;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const float way = (top - origin.y) / directions[i].y;
    const vec3 expected = mean_light(scene, origin, directions[i], way).shaded;
    EXPECT_NEAR(from_planes(lost, i).y, expected.y, 0.35f * expected.y + 1e-6f) << i;
  }
  EXPECT_GT(from_planes(lost, 0).y, 3.0f * from_planes(lost, 1).y);
}

/// Tests the map of clouds against the density that the device finds. Bulges are left out in the
/// map.
TEST_P(AirShadow, OfCloudsLiesWhereTheirShadowOnTheGroundDoes) {
  pack::PackedScene scene = broken_clouds(0.45);
  scene.numbers.sky.sun_shadows = 1;
  set3(scene.numbers.sky.sun_direction, glm::normalize(vec3(0.5f, 0.6f, -0.3f)));
  for (int i = 0; i < 2; ++i) scene.numbers.sky.cumulus.drift[i] = 777.0f;
  scene.numbers.sky.cumulus.chart = {};
  scene.cloud_chart = nullptr;
  scene = with_shadows(std::move(scene), nullptr);
  ASSERT_EQ(scene.numbers.air.shadows.by_clouds, 1u);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> far(-6000.0f, 6000.0f), high(0.0f, 300.0f);
  std::vector<vec3> points;
  for (int i = 0; i < 2048; ++i) points.emplace_back(far(random), high(random), far(random));
  const std::vector<float> found = lit(scene, points);
  const auto share = output<float>(points.size());
  const UploadedScene on_device(scene);
  probe.run("probe_cloud_shadow", points.size(), on_device.numbers, on_device.sky_table,
            on_device.cloud_chart, input(planes(points)),
            input(std::vector<float>(points.size(), 60.0f)), share);
  const std::vector<float> expected = share.read();
  double off = 0.0, sum = 0.0, sum_expected = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    off += std::abs(static_cast<double>(found[i] - expected[i]));
    sum += static_cast<double>(found[i]);
    sum_expected += static_cast<double>(expected[i]);
  }
  const auto count = static_cast<double>(points.size());
  EXPECT_NEAR(sum / count, sum_expected / count, 0.05);
  EXPECT_LT(off / count, 0.09);
  EXPECT_GT(sum_expected / count, 0.2);
  EXPECT_LT(sum_expected / count, 0.8);
}

TEST(AirShadowMaps, AreKeptUntilSunOrGroundChange) {
  const mesh::GridMesh ground = ground_with_wall();
  pack::ShadowCache cache;
  pack::PackedScene packed = broken_clouds(0.4);
  packed.numbers.sky.sun_shadows = 1;
  set3(packed.numbers.sky.sun_direction, low_sun());
  const auto make = [&](std::uint64_t revision, const vec3& eye) {
    pack::PackedScene again = packed;
    add_air_shadows(&ground, revision, eye, cache, again);
  };
  make(1, vec3(0.0f));
  make(1, vec3(1.0f, 0.0f, 1.0f));
  EXPECT_EQ(cache.land.count(), 1);
  EXPECT_EQ(cache.clouds.count(), 1);
  make(2, vec3(0.0f));
  EXPECT_EQ(cache.land.count(), 2);
  set3(packed.numbers.sky.sun_direction, glm::normalize(vec3(1.0f, 1.0f, 0.0f)));
  make(2, vec3(0.0f));
  EXPECT_EQ(cache.land.count(), 3);
  EXPECT_EQ(cache.clouds.count(), 2);
}

AEROSTAT_AT_EVERY_WIDTH(AirShadow);

}  // namespace
}  // namespace aerostat::test

// Tests the air on the device against closed forms and against the air of the host, which the
// host's own tests compare with physics.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "air/light.hpp"
#include "pack/daylight.hpp"
#include "pack/pack_scene.hpp"
#include "scene/io.hpp"
#include "shading_scene.hpp"
#include "support/resolved.hpp"

namespace aerostat::test {
namespace {

scene::Scene morning(double sun_elevation_deg = 15.0) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  const auto elevation = radians_from_degrees(static_cast<float>(sun_elevation_deg));
  scene.sun.direction = dvec3(direction_from_angles(radians_from_degrees(230.0f), elevation));
  scene.camera.position = {0.0, 400.0, 0.0};
  scene.sky.cloud_cover = 0.0;
  return scene;
}

struct Paths {
  std::vector<vec3> origins, directions;
  std::vector<float> distances;

  void add(const vec3& direction, float height, float distance) {
    origins.push_back({10.0f, height, -20.0f});
    directions.push_back(glm::normalize(direction));
    distances.push_back(distance);
  }
};

vec3 towards(float azimuth_deg, float elevation_deg) {
  return direction_from_angles(radians_from_degrees(azimuth_deg),
                               radians_from_degrees(elevation_deg));
}

class Air : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  std::vector<vec3> follow(const pack::PackedScene& scene, const Paths& paths,
                           const vec3& radiance) const {
    const std::size_t count = whole_packets(paths.distances.size());
    const auto arriving = output<float>(3 * count);
    const std::vector<vec3> from(paths.distances.size(), radiance);
    probe.run("probe_air", count, uploaded(scene.numbers), input(planes(paths.origins)),
              input(planes(paths.directions)), input(padded(paths.distances)), input(planes(from)),
              arriving);
    return vectors(arriving.read(), paths.distances.size());
  }

  /// Returns for each direction the light of the air, and the radiance with the sun.
  std::pair<std::vector<vec3>, std::vector<vec3>> look(const pack::PackedScene& scene,
                                                       const Paths& paths) const {
    const std::size_t count = whole_packets(paths.directions.size());
    const auto light = output<float>(3 * count), radiance = output<float>(3 * count);
    const UploadedScene on_device(scene);
    probe.run("probe_sky", count, on_device.numbers, on_device.sky_table, on_device.cloud_chart,
              input(planes(paths.origins)), input(planes(paths.directions)), light, radiance);
    return {vectors(light.read(), paths.directions.size()),
            vectors(radiance.read(), paths.directions.size())};
  }

  static std::vector<vec3> vectors(const std::vector<float>& values, std::size_t count) {
    std::vector<vec3> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(from_planes(values, i));
    return result;
  }
};

/// Returns the light of path `i` from a surface of this radiance, as the host follows it in
/// `steps`.
dvec3 arriving_light(const scene::Scene& scene, const air::Scattering& air, const Paths& paths,
                     std::size_t i, int steps, const vec3& surface) {
  const dvec3 direction(paths.directions[i]);
  const auto path = air.follow({paths.origins[i].y, direction, paths.distances[i]}, steps);
  const double phase =
      air::haze_phase(glm::dot(direction, air.sun()), air.atmosphere().haze_asymmetry);
  return scene.sun.irradiance * (path.add + phase * path.haze) +
         path.transmittance * dvec3(surface);
}

TEST_P(Air, ShowsTheHostsSky) {
  const scene::Scene scene = morning();
  const air::Light light(resolved(scene));
  std::mt19937 random(17);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  Paths paths;
  for (int i = 0; i < 500; ++i) {
    paths.add({uniform(random), uniform(random) * 0.4f, uniform(random)}, 400.0f, 1.0f);
  }
  for (const vec3& axis : {vec3(0, 1, 0), vec3(0, -1, 0), vec3(scene.sun.direction)}) {
    paths.add(axis, 400.0f, 1.0f);
  }
  const auto [sky, radiance] = look(pack::pack_scene(resolved(scene)), paths);
  for (std::size_t i = 0; i < sky.size(); ++i) {
    const dvec3 expected = light.sky.radiance(dvec3(paths.directions[i])) * scene.sun.irradiance;
    ASSERT_LT(glm::distance(dvec3(sky[i]), expected), 2e-3 * glm::length(expected))
        << paths.directions[i].x << ", " << paths.directions[i].y;
  }
}

TEST_P(Air, IsSeenOverADistanceAsTheHostFollowsIt) {
  for (const double sun_deg : {40.0, 15.0, 4.0, -2.0}) {
    SCOPED_TRACE("sun at " + std::to_string(sun_deg));
    const scene::Scene scene = morning(sun_deg);
    const air::Scattering air(air::atmosphere_of(scene), glm::normalize(scene.sun.direction));
    Paths paths;
    for (const float azimuth_deg : {20.0f, 130.0f, 215.0f}) {
      for (const float distance : {90.0f, 3000.0f, 25000.0f}) {
        paths.add(towards(azimuth_deg, -0.5f), 400.0f, distance);
        paths.add(towards(azimuth_deg, 4.0f), 400.0f, distance);
        paths.add(towards(azimuth_deg, -8.0f), 2500.0f, 0.5f * distance);
      }
    }
    const vec3 surface(0.3f, 0.2f, 0.1f);
    const auto arriving = follow(pack::pack_scene(resolved(scene)), paths, surface);
    for (std::size_t i = 0; i < arriving.size(); ++i) {
      const dvec3 expected = arriving_light(scene, air, paths, i, 300, surface);
      // The device's land is flat and its four steps are long, so there is an error of 2 % at 25 km
      // under a low sun.
      EXPECT_LT(glm::distance(dvec3(arriving[i]), expected), 0.03 * glm::length(expected)) << i;
    }
  }
}

TEST_P(Air, OfThickHazeIsSeenAsTheHostFollowsIt) {
  for (const double visibility_m : {50.0, 500.0, 3000.0}) {
    for (const double scale_height_m : {30.0, 1200.0, 1e6}) {
      SCOPED_TRACE(std::to_string(visibility_m) + " m, scale height " +
                   std::to_string(scale_height_m) + " m");
      scene::Scene scene = morning();
      scene.haze.visibility_m = visibility_m;
      scene.haze.scale_height_m = scale_height_m;
      scene::set_haze_droplets(scene.haze, visibility_m);
      scene.camera.position->y = std::min(0.3 * scale_height_m, 400.0);
      const air::Scattering air(air::atmosphere_of(scene), glm::normalize(scene.sun.direction));
      Paths paths;
      for (const float azimuth_deg : {20.0f, 130.0f}) {
        for (const float distance : {20.0f, 300.0f, 12000.0f}) {
          for (const float elevation_deg : {-0.5f, 4.0f, 40.0f}) {
            if (elevation_deg < 0.0f && distance > 1000.0f) continue;
            paths.add(towards(azimuth_deg, elevation_deg),
                      static_cast<float>(scene.camera.position->y), distance);
          }
        }
      }
      const vec3 surface(0.03f, 0.02f, 0.01f);
      const auto arriving = follow(pack::pack_scene(resolved(scene)), paths, surface);
      for (std::size_t i = 0; i < arriving.size(); ++i) {
        const dvec3 expected = arriving_light(scene, air, paths, i, 400, surface);
        // There are four steps. The first may hide the others and reach beyond the haze, so the
        // tolerance is wide.
        EXPECT_LT(glm::distance(dvec3(arriving[i]), expected), 0.2 * glm::length(expected) + 1e-6)
            << paths.directions[i].y << " over " << paths.distances[i];
      }
    }
  }
}

/// Tests that the light from behind so much haze is that of the sky, whatever stands there.
TEST_P(Air, HidesWhatIsFarBehindThickHaze) {
  for (const double visibility_m : {50.0, 200.0, 500.0}) {
    scene::Scene scene = morning();
    scene.haze.visibility_m = visibility_m;
    scene::set_haze_droplets(scene.haze, visibility_m);
    Paths paths;
    for (const float azimuth_deg : {20.0f, 130.0f, 215.0f}) {
      for (const float elevation_deg : {0.5f, 6.0f, 20.0f}) {
        paths.add(towards(azimuth_deg, elevation_deg), 400.0f, 7000.0f);
      }
    }
    const pack::PackedScene packed = pack::pack_scene(resolved(scene));
    const auto [sky, radiance] = look(packed, paths);
    const auto black = follow(packed, paths, vec3(0.0f)), white = follow(packed, paths, vec3(1.0f));
    for (std::size_t i = 0; i < sky.size(); ++i) {
      // This difference is less than a display shows.
      EXPECT_LT(glm::distance(white[i], black[i]), 0.01f * glm::length(sky[i])) << i;
      EXPECT_LT(glm::distance(black[i], sky[i]), 0.04f * glm::length(sky[i])) << i;
    }
  }
}

TEST_P(Air, OfAnyKindGivesLightAndNothingBelowIt) {
  std::mt19937 random(29);
  const auto between = [&random](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  for (int i = 0; i < 8; ++i) {
    scene::Scene scene = morning(between(-30.0, 90.0));
    scene.haze = {std::pow(10.0, between(1.0, 5.0)), std::pow(10.0, between(0.0, 6.0)),
                  between(-1.0, 4.0), between(0.0, 0.95),
                  vec3(dvec3(between(0.0, 1.0), 1.0, between(0.0, 1.0)))};
    scene.air.density = between(0.0, 10.0);
    scene.air.ozone_du = between(0.0, 3000.0);
    scene.fog.enabled = i % 4 == 0;
    SCOPED_TRACE(scene::write_text(scene));
    Paths paths;
    for (int k = 0; k < 200; ++k) {
      paths.add(vec3(dvec3(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0))),
                static_cast<float>(between(-500.0, 9000.0)),
                static_cast<float>(std::pow(10.0, between(0.0, 6.0))));
    }
    const pack::PackedScene packed = pack::pack_scene(resolved(scene));
    const auto [sky, radiance] = look(packed, paths);
    const auto arriving = follow(packed, paths, vec3(0.5f));
    for (std::size_t k = 0; k < sky.size(); ++k) {
      for (const vec3& light : {sky[k], radiance[k], arriving[k]}) {
        ASSERT_TRUE(is_finite(light)) << paths.directions[k].y;
        ASSERT_GE(std::min({light.x, light.y, light.z}), 0.0f) << paths.directions[k].y;
      }
    }
  }
}

/// A way of 120 km, and the largest difference from the sky behind it, as a share of the sky.
struct LongWay {
  double sun_deg;
  float elevation_deg, bound;
};

/// Where a land ends at the horizon, the haze before it meets the sky above it, and a band would
/// show. Of the differences there, 4 % are light from beyond the way. The rest, and that of higher
/// views, is due to four long steps over a flat land. The bounds are a tenth above the differences.
TEST_P(Air, OfAWayToItsEndIsTheSky) {
  for (const LongWay& way : std::initializer_list<LongWay>{{60.0, 0.1f, 0.03f},
                                                           {30.0, 0.1f, 0.051f},
                                                           {15.0, 0.1f, 0.075f},
                                                           {5.0, 0.1f, 0.117f},
                                                           {30.0, 8.0f, 0.025f},
                                                           {30.0, 15.0f, 0.043f},
                                                           {30.0, 30.0f, 0.09f},
                                                           {30.0, 70.0f, 0.205f}}) {
    Paths paths;
    for (const float azimuth_deg : {20.0f, 130.0f, 215.0f}) {
      paths.add(towards(azimuth_deg, way.elevation_deg), 400.0f, 1.2e5f);
    }
    const pack::PackedScene packed = pack::pack_scene(resolved(morning(way.sun_deg)));
    const auto [sky, radiance] = look(packed, paths);
    const auto arriving = follow(packed, paths, vec3(0.0f));
    for (std::size_t i = 0; i < sky.size(); ++i) {
      EXPECT_LT(glm::distance(arriving[i], sky[i]), way.bound * glm::length(sky[i]))
          << way.elevation_deg << " degrees up, sun at " << way.sun_deg << ", azimuth " << i;
    }
  }
}

TEST_P(Air, ThatOnlyAbsorbsFollowsBeersLaw) {
  AeroScene scene = bare_scene();
  set3(scene.air.haze_extinction, {2e-5f, 4e-5f, 8e-5f});
  Paths paths;
  for (const float slope : {-0.12f, -0.01f, 0.0f, 1e-4f, 0.02f, 0.3f, 0.9f}) {
    for (const float distance : {10.0f, 1000.0f, 12000.0f}) {
      paths.add({std::sqrt(1.0f - slope * slope), slope, 0.0f}, 1500.0f, distance);
    }
  }
  const auto arriving = follow(with_even_sky(scene), paths, vec3(1.0f));
  for (std::size_t i = 0; i < arriving.size(); ++i) {
    const double slope = paths.directions[i].y, distance = paths.distances[i];
    const double rise = slope * distance / 1200.0;
    const double mean = std::abs(rise) < 1e-6 ? 1.0 : -std::expm1(-rise) / rise;
    const double depth = 4e-5 * std::exp(-1500.0 / 1200.0) * mean * distance;
    const vec3 expected(std::exp(-0.5 * depth), std::exp(-depth), std::exp(-2.0 * depth));
    EXPECT_LT(glm::distance(arriving[i], expected), 2e-5f) << slope << " over " << distance;
  }
}

TEST_P(Air, BringsSunAndSkyToSurfacesAsOnTheHost) {
  const std::vector<float> heights{0.0f, 700.0f, 1500.0f, 2600.0f};
  const std::vector<vec3> normals(heights.size(), vec3(0, 1, 0));
  const std::size_t count = whole_packets(heights.size());
  // The second sun is below the horizon at the height of the sea.
  for (const double sun_deg : {6.0, -0.5}) {
    const scene::Scene scene = morning(sun_deg);
    const air::Scattering air(air::atmosphere_of(scene), glm::normalize(scene.sun.direction));
    const auto sun = output<float>(3 * count), ambient = output<float>(3 * count);
    probe.run("probe_sun", count, uploaded(pack::pack_scene(resolved(scene)).numbers),
              input(padded(heights)), input(planes(normals)), sun, ambient);
    const auto lit = sun.read(), around = ambient.read();
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const dvec3 expected = scene.sun.irradiance * air.sunlight(heights[i], air.sun().y);
      EXPECT_LT(glm::distance(dvec3(from_planes(lit, i)), expected),
                0.05 * glm::length(expected) + 1e-3)
          << heights[i] << " under " << sun_deg;
    }
    const air::Light light(resolved(scene));
    const auto& c = light.ambient;
    const dvec3 above = scene.sun.irradiance * (c[0] + c[1] - c[6] - c[8]);
    EXPECT_LT(glm::distance(dvec3(from_planes(around, 0)), above), 1e-5 * glm::length(above));
  }
}

TEST_P(Air, LightsTheHostsWhiteCard) {
  const std::vector<float> heights{-30.0f, 0.0f, 700.0f, 1500.0f, 2600.0f};
  const std::size_t count = whole_packets(heights.size());
  for (const double sun_deg : {40.0, 6.0, -0.5}) {
    const AeroScene scene = pack::pack_scene(resolved(morning(sun_deg))).numbers;
    const auto sun = output<float>(3 * count), ambient = output<float>(3 * count);
    probe.run("probe_sun", count, uploaded(scene), input(padded(heights)),
              input(planes(std::vector<vec3>(heights.size(), vec3(0, 1, 0)))), sun, ambient);
    const auto lit = sun.read();
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const dvec3 mean =
          dvec3(scene.air.ambient[0][0], scene.air.ambient[0][1], scene.air.ambient[0][2]);
      const dvec3 irradiance(scene.sky.sun_irradiance[0], scene.sky.sun_irradiance[1],
                             scene.sky.sun_irradiance[2]);
      const dvec3 expected = dvec3(from_planes(lit, i)) / std::numbers::pi + irradiance * mean;
      const dvec3 light = pack::daylight(scene, heights[i]);
      EXPECT_LT(glm::distance(light, expected), 1e-5 * glm::length(expected))
          << heights[i] << " under " << sun_deg;
    }
  }
}

TEST_P(Air, HoldsNumbersForEverySunAndDirection) {
  std::mt19937 random(23);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  for (const bool fog : {false, true}) {
    for (const double sun_deg : {-10.0, -0.3, 0.0, 5.0, 90.0}) {
      scene::Scene scene = morning(sun_deg);
      scene.fog.enabled = fog;
      scene.sky.cloud_cover = 0.8;
      Paths paths;
      for (int i = 0; i < 250; ++i) {
        const float reach = std::exp2(10.0f * uniform(random) + 10.0f);
        paths.add({uniform(random), uniform(random), uniform(random)}, 500.0f * uniform(random),
                  reach);
      }
      for (const vec3& axis : {vec3(0, 1, 0), vec3(0, -1, 0), vec3(1, 0, 0), vec3(0, 0, 1)}) {
        paths.add(axis, 0.0f, INFINITY);
      }
      const pack::PackedScene packed = pack::pack_scene(resolved(scene));
      const auto [sky, radiance] = look(packed, paths);
      const auto arriving = follow(packed, paths, vec3(0.5f));
      for (std::size_t i = 0; i < sky.size(); ++i) {
        for (const vec3& light : {sky[i], radiance[i], arriving[i]}) {
          ASSERT_TRUE(is_finite(light)) << sun_deg << ", " << paths.directions[i].y;
          ASSERT_GE(std::min({light.x, light.y, light.z}), 0.0f) << sun_deg;
        }
      }
    }
  }
}

TEST_P(Air, HoldsFogBelowItsTop) {
  scene::Scene scene = morning();
  scene.fog.enabled = true;
  scene.fog.visibility_m = 300.0;
  scene.fog.top_m = 200.0;
  scene.fog.softness_m = 10.0;
  scene.fog.billow_m = 0.0;
  Paths paths;
  paths.add({1.0f, 0.0f, 0.0f}, 50.0f, 300.0f);
  paths.add({1.0f, 0.0f, 0.0f}, 500.0f, 300.0f);
  const pack::PackedScene packed = pack::pack_scene(resolved(scene));
  const auto black = follow(packed, paths, vec3(0.0f)), white = follow(packed, paths, vec3(1.0f));
  EXPECT_NEAR(white[0].y - black[0].y, 0.02f, 0.002f) << "the visibility's contrast";
  EXPECT_GT(white[1].y - black[1].y, 0.98f) << "clear above";
  EXPECT_GT(black[0].y, 0.1f) << "lit";
}

AEROSTAT_AT_EVERY_WIDTH(Air);

}  // namespace
}  // namespace aerostat::test

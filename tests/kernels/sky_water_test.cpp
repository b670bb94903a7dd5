// Air and water: transmittances in closed form and their limits.
#include <cmath>
#include <random>

#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

class Sky : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  AeroScene scene() const {
    AeroScene scene = bare_scene();
    set3(scene.sky.zenith, {0.1f, 0.2f, 0.6f});
    set3(scene.sky.horizon, {0.5f, 0.6f, 0.7f});
    set3(scene.sky.glow, {0.9f, 0.6f, 0.3f});
    set3(scene.sky.sun_direction, glm::normalize(vec3(0.3f, 0.4f, -1.0f)));
    scene.sky.sun_cos = std::cos(radians_from_degrees(0.265f));
    return scene;
  }

  /// Gradient and radiance per direction.
  std::pair<std::vector<float>, std::vector<float>> look(
      const std::vector<vec3>& directions) const {
    const std::size_t count = whole_packets(directions.size());
    const auto gradient = output<float>(3 * count), radiance = output<float>(3 * count);
    probe.run("probe_sky", count, uploaded(scene()), input(planes(directions)), gradient, radiance);
    return {gradient.read(), radiance.read()};
  }
};

TEST_P(Sky, IsContinuousAcrossTheHorizon) {
  std::vector<vec3> directions;
  for (int i = 0; i < 64; ++i) {
    const float azimuth = static_cast<float>(i) * 0.1f;
    for (const float y : {1e-5f, 0.0f, -1e-5f}) {
      directions.push_back(glm::normalize(vec3(std::sin(azimuth), y, -std::cos(azimuth))));
    }
  }
  const auto [gradient, radiance] = look(directions);
  for (std::size_t i = 0; i < directions.size(); i += 3) {
    const vec3 above = from_planes(gradient, i), level = from_planes(gradient, i + 1);
    const vec3 below = from_planes(gradient, i + 2);
    ASSERT_LT(glm::distance(above, level), 2e-4f);
    ASSERT_LT(glm::distance(below, level), 2e-4f);
  }
}

TEST_P(Sky, GoesFromTheHorizonsColourToTheZeniths) {
  const auto [gradient, radiance] = look({{0, 1, 0}, {0, 0, 1}, {0, -1, 0}});
  // Away from the sun nothing glows.
  EXPECT_LT(glm::distance(from_planes(gradient, 1), vec3(0.5f, 0.6f, 0.7f)), 1e-6f);
  EXPECT_LT(glm::distance(from_planes(gradient, 2), vec3(0.5f, 0.6f, 0.7f)), 1e-6f);
  EXPECT_LT(glm::distance(from_planes(gradient, 0), vec3(0.1f, 0.2f, 0.6f)), 0.05f);
}

TEST_P(Sky, ShowsTheSunsDiscAndNothingOfItElsewhere) {
  const vec3 sun = glm::normalize(vec3(0.3f, 0.4f, -1.0f));
  const vec3 side = glm::normalize(glm::cross(sun, vec3(0, 1, 0)));
  const auto at = [&](float degrees) {
    const float a = radians_from_degrees(degrees);
    return glm::normalize(std::cos(a) * sun + std::sin(a) * side);
  };
  const auto [gradient, radiance] = look({sun, at(0.2f), at(0.35f), at(1.0f)});
  const auto extra = [&, &g = gradient, &r = radiance](std::size_t i) {
    return glm::length(from_planes(r, i) - from_planes(g, i));
  };
  EXPECT_GT(extra(0), 10.0f);
  EXPECT_GT(extra(1), 10.0f);
  EXPECT_EQ(extra(2), 0.0f);
  EXPECT_EQ(extra(3), 0.0f);
}

class Haze : public Sky {
 protected:
  struct Paths {
    std::vector<vec3> origins, directions;
    std::vector<float> distances;

    void add(float height, float slope_y, float distance) {
      origins.push_back({0.0f, height, 0.0f});
      directions.push_back({std::sqrt(1.0f - slope_y * slope_y), slope_y, 0.0f});
      distances.push_back(distance);
    }
  };

  /// Optical depths, then the radiance that arrives from surfaces of `radiance`.
  std::pair<std::vector<float>, std::vector<float>> follow(const Paths& paths,
                                                           const vec3& radiance) const {
    const std::size_t count = whole_packets(paths.distances.size());
    const auto depth = output<float>(count), arriving = output<float>(3 * count);
    const std::vector<vec3> from(paths.distances.size(), radiance);
    probe.run("probe_haze", count, uploaded(scene()), input(planes(paths.origins)),
              input(planes(paths.directions)), input(padded(paths.distances)), input(planes(from)),
              depth, arriving);
    return {depth.read(), arriving.read()};
  }
};

TEST_P(Haze, OnALevelPathFollowsBeersLaw) {
  Paths paths;
  for (const float distance : {0.0f, 100.0f, 5000.0f, 20000.0f}) paths.add(0.0f, 0.0f, distance);
  for (const float distance : {0.0f, 100.0f, 5000.0f, 20000.0f}) paths.add(600.0f, 0.0f, distance);
  const auto [depth, arriving] = follow(paths, vec3(0.0f));
  for (std::size_t i = 0; i < paths.distances.size(); ++i) {
    const double density = std::exp(-static_cast<double>(paths.origins[i].y) / 1200.0);
    const double expected = 4e-5 * density * static_cast<double>(paths.distances[i]);
    EXPECT_NEAR(depth[i], expected, 1e-5 * expected) << i;
  }
}

double depth_by_quadrature(double height, double slope, double distance) {
  const int steps = 20000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    sum += std::exp(-(height + slope * distance * (i + 0.5) / steps) / 1200.0);
  }
  return 4e-5 * sum * distance / steps;
}

TEST_P(Haze, OnASlopedPathIsTheIntegralOfItsDensity) {
  Paths paths;
  for (const float slope : {-0.5f, -0.1f, -0.01f, -1e-3f, 1e-4f, 1e-3f, 0.02f, 0.3f, 0.9f}) {
    for (const float distance : {10.0f, 1000.0f, 12000.0f}) paths.add(1500.0f, slope, distance);
  }
  const auto [depth, arriving] = follow(paths, vec3(0.0f));
  for (std::size_t i = 0; i < paths.distances.size(); ++i) {
    const double expected = depth_by_quadrature(1500.0, static_cast<double>(paths.directions[i].y),
                                                static_cast<double>(paths.distances[i]));
    // The difference of nearly equal densities costs digits just outside the series.
    EXPECT_NEAR(depth[i], expected, 3e-5 * expected)
        << "slope " << paths.directions[i].y << " over " << paths.distances[i];
  }
}

TEST_P(Haze, LeavesNearThingsAloneAndHidesFarOnesInTheHorizon) {
  Paths paths;
  paths.add(100.0f, 0.0f, 0.0f);
  paths.add(100.0f, 0.0f, 9e5f);
  paths.add(100.0f, -1e-4f, 9e5f);
  paths.add(100.0f, 0.0f, 20000.0f);
  const vec3 surface(3.0f, 2.0f, 1.0f);
  const auto [depth, arriving] = follow(paths, surface);
  EXPECT_EQ(from_planes(arriving, 0), surface);
  const auto [gradient, radiance] = look({paths.directions[1]});
  const vec3 air = from_planes(gradient, 0);
  EXPECT_LT(glm::distance(from_planes(arriving, 1), air), 1e-3f);
  EXPECT_LT(glm::distance(from_planes(arriving, 2), air), 1e-3f);
  const vec3 share = (from_planes(arriving, 3) - air) / (surface - air);
  EXPECT_GT(share.x, share.y);
  EXPECT_GT(share.y, share.z);
  EXPECT_NEAR(share.y, std::exp(-depth[3]), 1e-5f);
}

class Water : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  AeroScene scene() const {
    AeroScene scene = bare_scene();
    scene.water = {{0.35f, 0.06f, 0.015f}, {0.01f, 0.08f, 0.12f}, {0.6f, 0.5f, 0.4f}, 0, 6, 0.1f};
    return scene;
  }

  std::vector<vec3> body(const std::vector<float>& depths, float cosine, const vec3& light) const {
    const std::size_t count = whole_packets(depths.size());
    const std::vector<float> cosines(count, cosine);
    const auto radiance = output<float>(3 * count);
    probe.run("probe_water", count, uploaded(scene()), input(padded(depths)), input(cosines),
              input(planes(std::vector<vec3>(count, light))), radiance);
    const auto values = radiance.read();
    std::vector<vec3> result;
    for (std::size_t i = 0; i < depths.size(); ++i) result.push_back(from_planes(values, i));
    return result;
  }
};

TEST_P(Water, ReflectsAsFresnelSays) {
  std::vector<float> cosines;
  for (int i = 0; i < 64; ++i) cosines.push_back(static_cast<float>(i) / 63.0f);
  const auto reflectance = output<float>(cosines.size());
  probe.run("probe_fresnel", cosines.size(), input(cosines), reflectance);
  const auto shares = reflectance.read();
  EXPECT_NEAR(shares.back(), 0.0204f, 1e-6f) << "straight down";
  EXPECT_NEAR(shares.front(), 1.0f, 1e-6f) << "grazing";
  for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_LT(shares[i], shares[i - 1] + 1e-7f);
}

TEST_P(Water, ShowsItsBedWhereShallowAndItselfWhereDeep) {
  const vec3 light(2.0f, 1.0f, 0.5f);
  const auto radiance = body({0.0f, 1e-4f, 3.0f, 2000.0f, 1e5f}, 1.0f, light);
  EXPECT_LT(glm::distance(radiance[0], light * vec3(0.6f, 0.5f, 0.4f)), 1e-6f);
  EXPECT_LT(glm::distance(radiance[1], radiance[0]), 1e-3f);
  EXPECT_LT(glm::distance(radiance[3], light * vec3(0.01f, 0.08f, 0.12f)), 1e-6f);
  EXPECT_LT(glm::distance(radiance[4], light * vec3(0.01f, 0.08f, 0.12f)), 1e-6f);
  // Red goes first, blue last.
  const vec3 deep(0.01f, 0.08f, 0.12f), bed(0.6f, 0.5f, 0.4f);
  const vec3 through = (radiance[2] / light - deep) / (bed - deep);
  const float path = 3.0f * 2.15f;
  EXPECT_NEAR(through.x, std::exp(-0.35f * path), 1e-5f);
  EXPECT_NEAR(through.y, std::exp(-0.06f * path), 1e-5f);
  EXPECT_NEAR(through.z, std::exp(-0.015f * path), 1e-5f);
}

TEST_P(Water, IsDarkerOnASlantWithoutBound) {
  const vec3 down = body({2.0f}, 1.0f, vec3(1.0f))[0], slant = body({2.0f}, 0.02f, vec3(1.0f))[0];
  EXPECT_LT(slant.x, down.x);
  EXPECT_GT(slant.z, 0.3f);
}

TEST_P(Water, WavesFlattenWithDistanceAndTheirSlopeTurnsToRoughness) {
  std::mt19937 random(91);
  std::uniform_real_distribution<float> coordinate(-500.0f, 500.0f);
  const std::size_t count = 256;
  std::vector<vec3> positions(count);
  std::vector<float> footprints(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = coordinate(random);
    positions[i] = {x, 0.0f, coordinate(random)};
    footprints[i] = i < count / 2 ? 0.01f : 100.0f;
  }
  const auto normals = output<float>(3 * count), roughness = output<float>(count);
  probe.run("probe_waves", count, uploaded(scene()), input(planes(positions)), input(footprints),
            normals, roughness);
  const auto n = normals.read(), rough = roughness.read();
  float steepest = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 normal = from_planes(n, i);
    ASSERT_NEAR(glm::length(normal), 1.0f, 1e-6f);
    ASSERT_GT(normal.y, 0.3f);
    if (i >= count / 2) {
      ASSERT_EQ(normal, vec3(0, 1, 0));
    }
    steepest = std::max(steepest, std::hypot(normal.x, normal.z));
  }
  EXPECT_GT(steepest, 0.02f);
  EXPECT_LT(rough[0], rough[count - 1]);
}

AEROSTAT_AT_EVERY_WIDTH(Sky);
AEROSTAT_AT_EVERY_WIDTH(Haze);
AEROSTAT_AT_EVERY_WIDTH(Water);

}  // namespace
}  // namespace aerostat::test

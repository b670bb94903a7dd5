// What materials make of light, and how they choose directions, where the answer is an integral.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

struct Material {
  const char* name;
  float diffuse = 1.0f, specular = 0.0f, shininess = 1.0f, translucency = 0.0f;
  vec3 albedo{1.0f};
  float softness = 0.0f, roughness = 0.0f, foam = 0.0f;
  int kind = AERO_MATERIAL_PLAIN;
  float metallic = 0.0f;

  std::vector<float> coefficients() const {
    return {1.0f,     diffuse,  specular, shininess, translucency, albedo.x,
            albedo.y, albedo.z, softness, roughness, foam,         static_cast<float>(kind),
            0.0f,     0.0f,     metallic};
  }
};

/// The kinds of material, with lobes wide enough for the grids below.
std::vector<Material> materials() {
  return {{.name = "Lambert", .albedo = {0.8f, 0.4f, 0.2f}},
          {.name = "sand", .softness = 1.0f},
          {.name = "cloth", .diffuse = 0.6f, .translucency = 0.4f},
          {.name = "steel", .diffuse = 0.3f, .specular = 0.7f, .shininess = 30.0f},
          {.name = "glossy leaf",
           .diffuse = 0.5f,
           .specular = 0.4f,
           .shininess = 12.0f,
           .translucency = 0.3f},
          {.name = "satin", .diffuse = 0.0f, .specular = 0.9f, .shininess = 4.0f},
          {.name = "storm",
           .specular = 1.0f,
           .albedo = vec3(0.1f),
           .roughness = 0.15f,
           .kind = AERO_MATERIAL_WATER},
          {.name = "sea",
           .specular = 1.0f,
           .albedo = vec3(0.1f),
           .roughness = 0.03f,
           .kind = AERO_MATERIAL_WATER},
          {.name = "breakers",
           .specular = 1.0f,
           .albedo = vec3(0.3f),
           .roughness = 0.06f,
           .foam = 0.5f,
           .kind = AERO_MATERIAL_WATER},
          {.name = "plastic",
           .specular = 0.04f,
           .albedo = {0.9f, 0.5f, 0.2f},
           .roughness = 0.16f,
           .kind = AERO_MATERIAL_MODEL},
          {.name = "paper",
           .specular = 0.04f,
           .translucency = 0.3f,
           .albedo = vec3(1.0f),
           .roughness = 1.0f,
           .kind = AERO_MATERIAL_MODEL},
          {.name = "brass",
           .specular = 0.04f,
           .albedo = {0.9f, 0.7f, 0.3f},
           .roughness = 0.3f,
           .kind = AERO_MATERIAL_MODEL,
           .metallic = 1.0f}};
}

/// Views that look down on the surface.
std::vector<vec3> views() {
  return {{0, 1, 0}, tilted(35.0f), tilted(65.0f)};
}

constexpr int kRows = 512, kColumns = 512;
constexpr std::size_t kDirections = std::size_t{kRows} * kColumns;

/// Directions that stand for equal parts of the sphere: rows by height, columns by azimuth.
std::vector<vec3> whole_sphere() {
  std::vector<vec3> directions;
  directions.reserve(kDirections);
  for (int row = 0; row < kRows; ++row) {
    const float y = 1.0f - 2.0f * (static_cast<float>(row) + 0.5f) / kRows;
    for (int column = 0; column < kColumns; ++column) {
      const float turn = 2.0f * kPi * (static_cast<float>(column) + 0.5f) / kColumns;
      const float level = std::sqrt(1.0f - y * y);
      directions.emplace_back(level * std::cos(turn), y, level * std::sin(turn));
    }
  }
  return directions;
}

struct Evaluated {
  std::vector<vec3> values;
  std::vector<float> densities;
};

struct Sampled {
  std::vector<vec3> directions, weights;
  std::vector<float> densities;
};

class Materials : public LaneTest {
 protected:
  const Probe probe{"materials.cl", GetParam()};
  const vec3 up{0.0f, 1.0f, 0.0f};

  Evaluated evaluate(const Material& material, const std::vector<vec3>& viewers,
                     const std::vector<vec3>& directions) const {
    const std::size_t count = whole_packets(directions.size());
    const auto values = output<float>(3 * count), densities = output<float>(count);
    probe.run("probe_evaluate", count, input(material.coefficients()),
              input(planes(std::vector<vec3>(count, up))), input(planes(viewers)),
              input(planes(directions)), values, densities);
    Evaluated result;
    const auto read = values.read();
    for (std::size_t i = 0; i < directions.size(); ++i) {
      result.values.push_back(from_planes(read, i));
    }
    result.densities = densities.read();
    result.densities.resize(directions.size());
    return result;
  }

  Evaluated evaluate_all(const Material& material, const vec3& viewer) const {
    static const std::vector<vec3> sphere = whole_sphere();
    return evaluate(material, std::vector<vec3>(sphere.size(), viewer), sphere);
  }

  Sampled sample(const Material& material, const vec3& viewer, std::size_t count) const {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<vec3> numbers;
    for (std::size_t i = 0; i < count; ++i) {
      const float u = unit(random), v = unit(random);
      numbers.emplace_back(std::min(u, 0.9999999f), v, unit(random));
    }
    const auto directions = output<float>(3 * count), weights = output<float>(3 * count);
    const auto densities = output<float>(count);
    probe.run("probe_sample", count, input(material.coefficients()),
              input(planes(std::vector<vec3>(count, up))),
              input(planes(std::vector<vec3>(count, viewer))), input(planes(numbers)), directions,
              weights, densities);
    Sampled result;
    const auto d = directions.read(), w = weights.read();
    for (std::size_t i = 0; i < count; ++i) {
      result.directions.push_back(from_planes(d, i));
      result.weights.push_back(from_planes(w, i));
    }
    result.densities = densities.read();
    return result;
  }
};

constexpr double kPart = 4.0 * std::numbers::pi / static_cast<double>(kDirections);

// Densities add up to the share of samples that found a direction: a wave that faces away from the
// viewer has none.
TEST_P(Materials, DensitiesAddUpToTheChoices) {
  constexpr std::size_t kSamples = 1u << 16;
  for (const Material& material : materials()) {
    for (const vec3& viewer : views()) {
      double sum = 0.0, found = 0.0;
      for (const float density : evaluate_all(material, viewer).densities) {
        ASSERT_GE(density, 0.0f) << material.name;
        sum += static_cast<double>(density) * kPart;
      }
      for (const float density : sample(material, viewer, kSamples).densities) {
        found += density > 0.0f ? 1.0 / kSamples : 0.0;
      }
      EXPECT_NEAR(sum, found, 0.002) << material.name << " from " << viewer.y;
      // Facets of rough surfaces mirror some directions into the surface.
      const double least = material.kind == AERO_MATERIAL_MODEL ? 0.9 : 0.98;
      EXPECT_GT(found, least) << material.name << " from " << viewer.y;
    }
  }
}

constexpr int kBinRows = 16, kBinColumns = 16;

std::size_t bin_of(const vec3& direction) {
  const double turns =
      std::atan2(static_cast<double>(direction.z), static_cast<double>(direction.x)) /
      (2.0 * std::numbers::pi);
  const int row =
      std::clamp(static_cast<int>((1.0f - direction.y) * 0.5f * kBinRows), 0, kBinRows - 1);
  const int column =
      std::clamp(static_cast<int>((turns - std::floor(turns)) * kBinColumns), 0, kBinColumns - 1);
  return static_cast<std::size_t>(row * kBinColumns + column);
}

/// A histogram of choices is what the densities say, within five standard deviations of each count
/// and what the grid leaves out of a lobe.
TEST_P(Materials, ChoicesFollowTheDensities) {
  constexpr std::size_t kSamples = 1u << 16;
  for (const Material& material : materials()) {
    for (const vec3& viewer : views()) {
      static const std::vector<vec3> sphere = whole_sphere();
      const auto densities = evaluate_all(material, viewer).densities;
      std::array<double, kBinRows * kBinColumns> expected{}, found{};
      for (std::size_t i = 0; i < sphere.size(); ++i) {
        expected[bin_of(sphere[i])] += static_cast<double>(densities[i]) * kPart * kSamples;
      }
      const Sampled chosen = sample(material, viewer, kSamples);
      for (std::size_t i = 0; i < kSamples; ++i) {
        if (chosen.densities[i] == 0.0f) continue;
        ASSERT_NEAR(glm::length(chosen.directions[i]), 1.0f, 1e-5f) << material.name;
        found[bin_of(chosen.directions[i])] += 1.0;
      }
      for (std::size_t bin = 0; bin < expected.size(); ++bin) {
        EXPECT_NEAR(found[bin], expected[bin],
                    5.0 * std::sqrt(expected[bin]) + 0.02 * expected[bin] + 3.0)
            << material.name << " from " << viewer.y << ", bin " << bin;
      }
    }
  }
}

/// The mean of the weights of choices is the share of an even light that comes back; of materials
/// that exist this is no more than arrives.
TEST_P(Materials, WeightsGiveTheIntegralWhichKeepsTheEnergy) {
  constexpr std::size_t kSamples = 1u << 16;
  for (const Material& material : materials()) {
    for (const vec3& viewer : views()) {
      dvec3 integral(0.0), mean(0.0);
      for (const vec3& value : evaluate_all(material, viewer).values) {
        integral += dvec3(value) * (kPart / std::numbers::pi);
      }
      for (const vec3& weight : sample(material, viewer, kSamples).weights) {
        mean += dvec3(weight) / static_cast<double>(kSamples);
      }
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(mean[i], integral[i], 0.015 * integral[i] + 2e-3)
            << material.name << " from " << viewer.y;
        EXPECT_LT(integral[i], 1.005) << material.name << " from " << viewer.y;
      }
    }
  }
}

/// Light that goes the other way is scattered alike: all lobes but Phong's and the way through
/// water, which are not made so.
TEST_P(Materials, EvenLobesAreReciprocal) {
  const std::vector<vec3> sphere = whole_sphere();
  std::vector<vec3> one, other;
  for (std::size_t i = 5; i < sphere.size(); i += 4099) {
    for (std::size_t j = 11; j < sphere.size(); j += 3907) {
      if (sphere[i].y < 0.05f || std::fabs(sphere[j].y) < 0.05f) continue;
      one.push_back(sphere[i]);
      other.push_back(sphere[j]);
    }
  }
  for (const Material& material : materials()) {
    if (material.specular > 0.0f) continue;
    const auto there = evaluate(material, one, other), back = evaluate(material, other, one);
    for (std::size_t i = 0; i < one.size(); ++i) {
      // A viewer is always in front: seen from behind, the surface is turned around.
      if (other[i].y < 0.0f) continue;
      EXPECT_NEAR(there.values[i].x / other[i].y, back.values[i].x / one[i].y, 2e-5f)
          << material.name;
    }
  }
}

/// Waves over a black bed mirror of an even light from above what Fresnel's equations say for light
/// that falls straight down, however rough they are.
TEST_P(Materials, WavesMirrorTheirShare) {
  for (const float roughness : {0.015f, 0.03f, 0.06f}) {
    const Material sea{.name = "sea",
                       .specular = 1.0f,
                       .albedo = vec3(0.0f),
                       .roughness = roughness,
                       .kind = AERO_MATERIAL_WATER};
    double mirrored = 0.0;
    for (const vec3& value : evaluate_all(sea, up).values) {
      mirrored += static_cast<double>(value.x) * kPart / std::numbers::pi;
    }
    EXPECT_NEAR(mirrored, 0.0204, 1e-4) << roughness;
  }
}

/// White surfaces whose coefficients add up to more than 1 scatter what arrives and no more, at
/// every exponent of Phong's lobe.
TEST_P(Materials, ScatterNoMoreThanArrives) {
  for (const float shininess : {0.0f, 1.0f, 4.0f, 28.0f, 300.0f}) {
    for (const float specular : {0.1f, 1.0f}) {
      const Material bright{.name = "bright",
                            .diffuse = 0.85f,
                            .specular = specular,
                            .shininess = shininess,
                            .translucency = 0.3f};
      for (const vec3& viewer : views()) {
        double sum = 0.0;
        for (const vec3& value : evaluate_all(bright, viewer).values) {
          sum += static_cast<double>(value.x) * kPart / std::numbers::pi;
        }
        EXPECT_LT(sum, 1.002) << shininess << ", " << specular << " from " << viewer.y;
        // Seen from above, all of a narrow lobe lies over the surface.
        if (viewer == up && shininess >= 28.0f) {
          EXPECT_NEAR(sum, 1.0, 0.01) << shininess << ", " << specular;
        }
      }
    }
  }
}

/// A white surface of a model scatters no more than arrives, however rough it is and from wherever
/// it is seen. Of metal, facets that reflect light among themselves lose some, as
/// ggx_mirror_share() says. What is no metal loses less than 0.2.
TEST_P(Materials, ModelsScatterNoMoreThanArrives) {
  for (const float metallic : {0.0f, 1.0f}) {
    for (const float rough : {0.35f, 0.6f, 0.8f, 1.0f}) {
      for (const float turn_deg : {0.0f, 50.0f, 80.0f}) {
        const Material white{.name = "white",
                             .specular = 0.04f,
                             .roughness = rough * rough,
                             .kind = AERO_MATERIAL_MODEL,
                             .metallic = metallic};
        double sum = 0.0;
        for (const vec3& value : evaluate_all(white, tilted(turn_deg)).values) {
          sum += static_cast<double>(value.x) * kPart / std::numbers::pi;
        }
        EXPECT_LT(sum, 1.005) << rough << ", " << metallic << " from " << turn_deg;
        if (metallic > 0.0f) {
          const double kept = 1.0 - static_cast<double>(white.roughness) *
                                        (0.29 + 0.36 * std::cos(glm::radians(double{turn_deg})));
          EXPECT_NEAR(sum, kept, 0.1) << rough << " from " << turn_deg;
        } else {
          EXPECT_GT(sum, 0.8) << rough << " from " << turn_deg;
        }
      }
    }
  }
}

/// The mirror of metal is reciprocal: it reflects light alike in both directions.
TEST_P(Materials, MetalIsReciprocal) {
  const Material metal{.name = "metal",
                       .specular = 0.04f,
                       .albedo = {0.9f, 0.7f, 0.3f},
                       .roughness = 0.4f,
                       .kind = AERO_MATERIAL_MODEL,
                       .metallic = 1.0f};
  std::vector<vec3> one, other;
  for (const float turn_deg : {10.0f, 30.0f, 55.0f, 75.0f}) {
    for (const vec3& direction : {vec3(0.3f, 0.9f, 0.1f), vec3(-0.7f, 0.5f, 0.2f)}) {
      one.push_back(tilted(turn_deg));
      other.push_back(glm::normalize(direction));
    }
  }
  const auto there = evaluate(metal, one, other), back = evaluate(metal, other, one);
  for (std::size_t i = 0; i < one.size(); ++i) {
    const float a = there.values[i].x / other[i].y, b = back.values[i].x / one[i].y;
    EXPECT_GT(a, 0.0f);
    EXPECT_NEAR(a, b, 1e-4f * a + 1e-6f) << i;
  }
}

TEST_P(Materials, ClothSendsItsShareThrough) {
  const Material cloth{.name = "cloth", .diffuse = 0.6f, .translucency = 0.4f};
  double front = 0.0, behind = 0.0;
  const std::vector<vec3> sphere = whole_sphere();
  const auto values = evaluate_all(cloth, tilted(20.0f)).values;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    (sphere[i].y > 0.0f ? front : behind) +=
        static_cast<double>(values[i].x) * kPart / std::numbers::pi;
  }
  EXPECT_NEAR(front, 0.6, 1e-3);
  EXPECT_NEAR(behind, 0.4, 1e-3);
}

AEROSTAT_AT_EVERY_WIDTH(Materials);

}  // namespace
}  // namespace aerostat::test

// What shading reads at a hit.
#include <random>

#include "shading_scene.hpp"
#include "trace_triangle.h"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kHits = 256;

struct Surface {
  std::vector<AeroFace> faces;
  std::vector<AeroVertex> vertices;
};

AeroVertex vertex_of(const vec3& position, const vec3& normal, const vec3& color) {
  AeroVertex vertex{};
  set3(vertex.position, position);
  set3(vertex.normal, normal);
  set3(vertex.color, color);
  return vertex;
}

Surface random_surface() {
  std::mt19937 random(21);
  Surface surface;
  for (int i = 0; i < 90; ++i) {
    surface.vertices.push_back(vertex_of(random_point(random, 5.0f), random_direction(random),
                                         glm::abs(random_point(random, 1.0f))));
  }
  for (std::uint32_t i = 0; i < 30; ++i) {
    surface.faces.push_back({{3 * i + 2, 3 * i, 3 * i + 1}, i % 11});
  }
  return surface;
}

/// Hits on random faces at the corners (0 to 2) in turn, or anywhere inside (3).
struct Hits {
  std::vector<float> tuv = std::vector<float>(3 * kHits);
  std::vector<std::uint32_t> slots = std::vector<std::uint32_t>(kHits);
};

Hits random_hits(std::size_t faces) {
  std::mt19937 random(22);
  std::uniform_real_distribution<float> weight(0.0f, 0.5f);
  Hits hits;
  for (std::size_t i = 0; i < kHits; ++i) {
    hits.slots[i] = static_cast<std::uint32_t>(random() % faces);
    hits.tuv[kHits + i] = i % 4 == 3 ? weight(random) : i % 4 == 1 ? 1.0f : 0.0f;
    hits.tuv[2 * kHits + i] = i % 4 == 3 ? weight(random) : i % 4 == 2 ? 1.0f : 0.0f;
  }
  return hits;
}

vec3 vector_of(const aero_float* v) {
  return {v[0], v[1], v[2]};
}

class SurfaceProbe : public LaneTest {
 protected:
  const Probe probe{"surface.cl", GetParam()};

  std::vector<float> lift(const Surface& surface, const Hits& hits, float side) const {
    const auto lifted = output<float>(3 * kHits);
    probe.run("probe_lift", kHits, input(surface.faces), input(surface.vertices), input(hits.tuv),
              input(hits.slots), input(std::vector<float>(kHits, side)), lifted);
    return lifted.read();
  }
};

TEST_P(SurfaceProbe, LanesReadTheFacesTheyHit) {
  const Surface surface = random_surface();
  Hits hits = random_hits(surface.faces.size());
  for (std::size_t i = 0; i < kHits; i += 5) hits.slots[i] = kNoTriangle;
  const auto loaded = output<std::uint32_t>(4 * kHits);
  probe.run("probe_faces", kHits, input(surface.faces), input(hits.slots), loaded);
  const auto words = loaded.read();
  for (std::size_t i = 0; i < kHits; ++i) {
    // Without a hit the first face stands in.
    const AeroFace& face = surface.faces[hits.slots[i] == kNoTriangle ? 0 : hits.slots[i]];
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(words[k * kHits + i], face.vertex[k]) << i;
    ASSERT_EQ(words[3 * kHits + i], face.object) << i;
  }
}

TEST_P(SurfaceProbe, AttributesAreTheVerticesAtCornersAndMixedBetween) {
  const Surface surface = random_surface();
  const Hits hits = random_hits(surface.faces.size());
  const auto attributes = output<float>(9 * kHits), planes = output<float>(3 * kHits);
  probe.run("probe_interpolation", kHits, input(surface.faces), input(surface.vertices),
            input(hits.tuv), input(hits.slots), attributes, planes);
  const auto values = attributes.read(), normals = planes.read();
  for (std::size_t i = 0; i < kHits; ++i) {
    const AeroFace& face = surface.faces[hits.slots[i]];
    const float u = hits.tuv[kHits + i], v = hits.tuv[2 * kHits + i];
    const AeroVertex* corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = &surface.vertices[face.vertex[k]];
    for (std::size_t k = 0; k < 9; ++k) {
      const auto word = [&](int c) { return reinterpret_cast<const float*>(corner[c])[k]; };
      const float mixed = (1.0f - u - v) * word(0) + u * word(1) + v * word(2);
      const float actual = values[k * kHits + i];
      if (i % 4 < 3) {
        ASSERT_EQ(actual, word(static_cast<int>(i % 4))) << i;
      }
      ASSERT_NEAR(actual, mixed, 2e-6f) << i;
    }
    const vec3 a = vector_of(corner[0]->position);
    const vec3 plane = glm::normalize(
        glm::cross(vector_of(corner[1]->position) - a, vector_of(corner[2]->position) - a));
    ASSERT_LT(glm::distance(from_planes(normals, i), plane), 1e-4f) << i;
  }
}

/// A triangle in the plane y = 3 whose normals lean apart by `lean`.
Surface tent(float lean) {
  const vec3 corners[] = {{-2, 3, -1}, {2, 3, -1}, {0, 3, 2}};
  Surface surface;
  for (const vec3& corner : corners) {
    const vec3 normal = glm::normalize(vec3(corner.x * lean, 1.0f, corner.z * lean));
    surface.vertices.push_back(vertex_of(corner, normal, vec3(1.0f)));
  }
  surface.faces.push_back({{0, 2, 1}, 1});
  return surface;
}

TEST_P(SurfaceProbe, FlatNormalsLiftNothing) {
  const Surface flat = tent(0.0f);
  const Hits hits = random_hits(1);
  for (const float side : {1.0f, -1.0f}) {
    const auto lifted = lift(flat, hits, side);
    for (std::size_t i = 0; i < kHits; ++i) ASSERT_NEAR(lifted[kHits + i], 3.0f, 1e-6f) << i;
  }
}

TEST_P(SurfaceProbe, CurvedNormalsLiftPointsOntoTheCurveOnItsOuterSideOnly) {
  const Surface curved = tent(0.3f);
  const Hits hits = random_hits(1);
  const auto outer = lift(curved, hits, 1.0f), inner = lift(curved, hits, -1.0f);
  for (std::size_t i = 0; i < kHits; ++i) {
    if (i % 4 < 3) {
      ASSERT_NEAR(outer[kHits + i], 3.0f, 1e-5f) << "a corner stays";
    } else {
      ASSERT_GT(outer[kHits + i], 3.0f) << i;
      ASSERT_LT(outer[kHits + i], 4.0f) << i;
    }
    ASSERT_NEAR(inner[kHits + i], 3.0f, 1e-5f) << "a hollow needs no lift";
  }
}

AEROSTAT_AT_EVERY_WIDTH(SurfaceProbe);

}  // namespace
}  // namespace aerostat::test

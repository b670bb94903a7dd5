// Tests the values that shading reads at a hit.
#include <cmath>
#include <random>

#include "height_grid.h"
#include "scene_params.h"
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
    surface.faces.push_back({{3 * i + 2, 3 * i, 3 * i + 1}, i % 11, i % 7});
  }
  return surface;
}

/// Hits on random faces, at the corners (0 to 2) in turn or anywhere inside (3).
struct Hits {
  std::vector<float> tuv = std::vector<float>(3 * kHits);
  std::vector<std::uint32_t> slots = std::vector<std::uint32_t>(2 * kHits, kNoTriangle);
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
    probe.run("probe_lift", kHits, input(std::vector<AeroInstance>()), input(no_grid()),
              input(surface.faces), input(surface.vertices), input(hits.tuv), input(hits.slots),
              input(std::vector<float>(kHits, side)), lifted);
    return lifted.read();
  }
};

/// Expects the position, normal and colour of a hit on a triangle with these corners.
void expect_mixed(const std::vector<float>& values, std::size_t i, const AeroVertex* const* corner,
                  const Hits& hits, float tolerance) {
  const float u = hits.tuv[kHits + i], v = hits.tuv[2 * kHits + i];
  for (std::size_t k = 0; k < 9; ++k) {
    const auto word = [&](int c) { return reinterpret_cast<const float*>(corner[c])[k]; };
    const float mixed = (1.0f - u - v) * word(0) + u * word(1) + v * word(2);
    ASSERT_NEAR(values[k * kHits + i], mixed, tolerance) << i << ", " << k;
  }
}

void expect_plane(const std::vector<float>& normals, std::size_t i,
                  const AeroVertex* const* corner) {
  const vec3 a = vector_of(corner[0]->position);
  const vec3 plane = glm::normalize(
      glm::cross(vector_of(corner[1]->position) - a, vector_of(corner[2]->position) - a));
  ASSERT_LT(glm::distance(from_planes(normals, i), plane), 1e-4f) << i;
}

mesh::GridMesh random_ground() {
  std::mt19937 random(23);
  const std::vector<float> x{-3.0f, -1.0f, 0.5f, 1.0f, 4.0f}, z{-2.0f, -1.5f, 0.0f, 3.0f};
  mesh::GridMesh grid(x, z);
  for (std::uint32_t j = 0; j <= grid.rows(); ++j) {
    for (std::uint32_t i = 0; i <= grid.columns(); ++i) {
      vec3 normal = random_direction(random);
      normal.y = std::fabs(normal.y) + 0.01f;
      grid.set(i, j, random_point(random, 2.0f).y, glm::normalize(normal));
    }
  }
  return grid;
}

/// A triangle of a cell with its number in the kernels and its corners.
struct GroundTriangle {
  std::uint32_t number;
  AeroVertex corners[3];
};

std::vector<GroundTriangle> triangles_of(const mesh::GridMesh& grid) {
  const mesh::TriangleMesh mesh = mesh::to_triangles(grid);
  std::vector<GroundTriangle> triangles;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t cell = t / 2;
    GroundTriangle triangle{AERO_GRID_TRIANGLE | cell / grid.columns() << AERO_GRID_ROW_SHIFT |
                                cell % grid.columns() << AERO_GRID_COLUMN_SHIFT | t % 2,
                            {}};
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t][k];
      triangle.corners[k] = vertex_of(mesh.positions[v], mesh.normals[v], vec3(1.0f));
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<AeroInstance> three_instances() {
  std::mt19937 random(24);
  std::vector<AeroInstance> instances;
  for (int i = 0; i < 3; ++i) instances.push_back(random_instance(random, 2.0f, 0));
  return instances;
}

AeroVertex standing(const AeroVertex& vertex, const AeroInstance& instance) {
  const vec3 foot = placed(instance, vec3(0.0f));
  const vec3 normal = (placed(instance, vector_of(vertex.normal)) - foot) / instance.scale;
  return vertex_of(placed(instance, vector_of(vertex.position)), normal,
                   vector_of(vertex.color) * vector_of(instance.tint));
}

// Tests only meshes, only ground, and both among the lanes of a packet, some of which hit nothing.
TEST_P(SurfaceProbe, LanesReadTheTriangleTheyHit) {
  const Surface surface = random_surface();
  const mesh::GridMesh grid = random_ground();
  const std::vector<GroundTriangle> ground = triangles_of(grid);
  const std::vector<float> words(grid.words().begin(), grid.words().end());
  const std::vector<AeroInstance> stand = three_instances();
  for (const int kind : {0, 1, 2}) {
    Hits hits = random_hits(surface.faces.size());
    std::vector<std::size_t> on_ground(kHits, ground.size());
    for (std::size_t i = 0; i < kHits; ++i) {
      if (kind == 1 || (kind == 2 && i * 7 % 3 == 0)) {
        on_ground[i] = i * 31 % ground.size();
        hits.slots[i] = ground[on_ground[i]].number;
      } else if (kind > 0 && i % 4 == 1) {
        hits.slots[kHits + i] = static_cast<std::uint32_t>(i % 3);
      }
      if (i % 5 == 4) hits.slots[i] = kNoTriangle;
    }
    const auto attributes = output<float>(9 * kHits), planes = output<float>(3 * kHits);
    // The objects come first, then the materials.
    const auto owners = output<std::uint32_t>(2 * kHits);
    probe.run("probe_interpolation", kHits, input(stand), input(words), input(surface.faces),
              input(surface.vertices), input(hits.tuv), input(hits.slots), attributes, planes,
              owners);
    const auto values = attributes.read(), normals = planes.read();
    const auto met = owners.read();
    for (std::size_t i = 0; i < kHits; ++i) {
      if (hits.slots[i] == kNoTriangle) continue;
      const AeroVertex* corner[3];
      AeroVertex stood[3];
      const bool is_ground = on_ground[i] < ground.size();
      for (int k = 0; k < 3; ++k) {
        corner[k] = is_ground ? &ground[on_ground[i]].corners[k]
                              : &surface.vertices[surface.faces[hits.slots[i]].vertex[k]];
        if (hits.slots[kHits + i] != kNoTriangle) {
          stood[k] = standing(*corner[k], stand[hits.slots[kHits + i]]);
          corner[k] = &stood[k];
        }
      }
      expect_mixed(values, i, corner, hits, 2e-5f);
      expect_plane(normals, i, corner);
      const AeroFace of_ground{{}, AERO_OBJECT_TERRAIN, AERO_GRID_MATERIAL};
      const AeroFace& face = is_ground ? of_ground : surface.faces[hits.slots[i]];
      ASSERT_EQ(met[i], face.object) << i;
      ASSERT_EQ(met[kHits + i], face.material) << i;
    }
  }
}

/// Returns a triangle in the plane y = 3 whose normals lean apart by `lean`.
Surface tent(float lean) {
  const vec3 corners[] = {{-2, 3, -1}, {2, 3, -1}, {0, 3, 2}};
  Surface surface;
  for (const vec3& corner : corners) {
    const vec3 normal = glm::normalize(vec3(corner.x * lean, 1.0f, corner.z * lean));
    surface.vertices.push_back(vertex_of(corner, normal, vec3(1.0f)));
  }
  surface.faces.push_back({{0, 2, 1}, 1, 1});
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

// Tests that no ray slips between triangles that share an edge or a vertex.
#include <algorithm>
#include <array>
#include <ostream>

#include "closed_meshes.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kRaysPerCase = 130000;

struct Case {
  const char* name;
  Soup (*mesh)();
  float scale;
  vec3 offset;
  /// The range of the eye's distance from the mesh's centre, in scales.
  float near_distance, far_distance;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.name;
}

/// A point of an edge or a vertex, with the faces around it.
struct Target {
  dvec3 point;
  const std::vector<std::uint32_t>* faces;
};

class Targets {
 public:
  explicit Targets(const Soup& soup) : soup_(soup), around_vertex_(soup.positions.size()) {
    for (std::uint32_t f = 0; f < soup.triangles.size(); ++f) {
      const uvec3 t = soup.triangles[f];
      const dvec3 a(soup.positions[t.x]), b(soup.positions[t.y]), c(soup.positions[t.z]);
      normals_.push_back(glm::normalize(glm::cross(b - a, c - a)));
      for (int k = 0; k < 3; ++k) {
        around_vertex_[t[k]].push_back(f);
        around_edge_[std::minmax(t[k], t[(k + 1) % 3])].push_back(f);
      }
    }
    edges_.assign(around_edge_.begin(), around_edge_.end());
    // A point of an edge may be practically at its end.
    for (auto& [ends, faces] : edges_) {
      is_closed_ = is_closed_ && faces.size() == 2;
      for (const std::uint32_t end : {ends.first, ends.second}) {
        faces.insert(faces.end(), around_vertex_[end].begin(), around_vertex_[end].end());
      }
    }
  }

  bool is_closed() const { return is_closed_; }

  /// Returns a random target. Every fourth one is a vertex, and the others lie on edges, some in
  /// their middle.
  Target pick(std::mt19937& random) const {
    if (random() % 4 == 0) {
      const std::size_t v = random() % soup_.positions.size();
      return {dvec3(soup_.positions[v]), &around_vertex_[v]};
    }
    const auto& [ends, faces] = edges_[random() % edges_.size()];
    const double t = random() % 4 == 0 ? 0.5 : std::uniform_real_distribution<>(0.0, 1.0)(random);
    const dvec3 a(soup_.positions[ends.first]), b(soup_.positions[ends.second]);
    return {a + t * (b - a), &faces};
  }

  /// Returns whether all faces around the target turn the same side to the ray, and none is nearly
  /// edge-on. The faces then surround the target also as the ray sees it, so even a ray with a
  /// slight error must hit.
  bool surrounded(const Target& target, const vec3& direction) const {
    const double first = glm::dot(normals_[target.faces->front()], dvec3(direction));
    return std::all_of(target.faces->begin(), target.faces->end(), [&](std::uint32_t f) {
      const double cosine = glm::dot(normals_[f], dvec3(direction));
      return cosine * first > 0.0 && std::abs(cosine) > 0.05;
    });
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  const Soup& soup_;
  std::vector<dvec3> normals_;
  std::vector<std::vector<std::uint32_t>> around_vertex_;
  std::map<Edge, std::vector<std::uint32_t>> around_edge_;
  std::vector<std::pair<Edge, std::vector<std::uint32_t>>> edges_;
  bool is_closed_ = true;
};

struct Aimed {
  std::vector<Ray> rays;
  std::vector<double> distances;
};

/// Returns rays in bundles of 16 from one eye, as the packets of a picture are.
Aimed aim(const Case& test, const Targets& targets, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> reach(test.near_distance, test.far_distance);
  Aimed aimed;
  while (aimed.rays.size() < kRaysPerCase) {
    const vec3 eye = test.offset + random_direction(random) * (reach(random) * test.scale);
    for (int i = 0; i < 16;) {
      const Target target = targets.pick(random);
      const Ray ray = ray_towards(eye, target.point);
      if (!targets.surrounded(target, ray.direction)) continue;
      aimed.rays.push_back(ray);
      aimed.distances.push_back(glm::distance(dvec3(eye), target.point));
      ++i;
    }
  }
  return aimed;
}

const std::array kCases{
    Case{"sphere", [] { return icosphere(4); }, 1.0f, vec3(0.0f), 1.5f, 6.0f},
    Case{"sphere_inside", [] { return icosphere(4); }, 1.0f, vec3(0.0f), 0.0f, 0.8f},
    Case{"box", [] { return subdivided_box(16); }, 1.0f, vec3(0.0f), 2.0f, 8.0f},
    Case{"box_inside", [] { return subdivided_box(16); }, 1.0f, vec3(0.0f), 0.0f, 0.9f},
    Case{"torus", [] { return torus(48, 24); }, 1.0f, vec3(0.0f), 1.6f, 6.0f},
    Case{"far_box", [] { return subdivided_box(32); }, 40.0f, vec3(7013.0f, 311.0f, -9027.0f), 2.0f,
         400.0f},
    Case{"far_sphere", [] { return icosphere(4); }, 12.0f, vec3(-8011.7f, 933.3f, 4021.1f), 1.5f,
         300.0f},
    Case{"far_torus", [] { return torus(48, 24); }, 100.0f, vec3(3000.5f, 1200.25f, 15000.0f), 1.6f,
         100.0f},
};

class Watertight : public testing::TestWithParam<Case> {};

TEST_P(Watertight, NoRayAtAnEdgeOrAVertexIsLost) {
  const Case& test = GetParam();
  const Soup soup = placed(test.mesh(), test.scale, test.offset);
  const Targets targets(soup);
  ASSERT_TRUE(targets.is_closed());
  const TracedMesh mesh(soup);
  unsigned seed = 701;
  for (const int lanes : {16, 1}) {
    const Aimed aimed = aim(test, targets, ++seed);
    const std::vector<Hit> hits = mesh.trace(aimed.rays, lanes);
    std::size_t lost = 0, behind = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      // A ray that slipped through the front would hit the far side.
      const double tolerance = 1e-4 * aimed.distances[i] + 1e-3 * static_cast<double>(test.scale);
      lost += hits[i].met() ? 0 : 1;
      behind += hits[i].met() && static_cast<double>(hits[i].t) > aimed.distances[i] + tolerance;
    }
    EXPECT_EQ(lost, 0u) << "of " << hits.size() << " at " << lanes << " lanes";
    EXPECT_EQ(behind, 0u) << "of " << hits.size() << " at " << lanes << " lanes";
  }
}

// Tests rays straight along an axis or in a plane of the grid, which run exactly along the faces of
// the tree's boxes.
TEST(WatertightGrid, RaysInThePlanesOfTheGridHitItsVertices) {
  const int cells = 12;
  const vec3 offset(3.0f, -7.0f, 11.0f);
  const TracedMesh mesh(placed(subdivided_box(cells), 1.0f, offset));
  std::vector<Ray> rays;
  std::vector<float> distances;
  for (int i = 0; i < 6 * 2 * 11 * 11; ++i) {
    const int axis = i / 2 % 3, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const float side = i / 6 % 2 == 0 ? 1.0f : -1.0f;
    const auto at = [](int step) { return static_cast<float>(1 + step) * (2.0f / cells) - 1.0f; };
    vec3 target;
    target[axis] = side;
    target[u] = at(i / 12 % 11);
    target[v] = at(i / 132 % 11);
    vec3 eye = target;
    eye[axis] = side * 6.0f;
    if (i % 2 == 1) eye[u] = 0.25f;
    rays.push_back(ray_towards(offset + eye, dvec3(offset + target)));
    distances.push_back(glm::distance(eye, target));
  }
  for (const int lanes : {1, 16}) {
    const std::vector<Hit> hits = mesh.trace(rays, lanes);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      ASSERT_TRUE(hits[i].met()) << i << " at " << lanes << " lanes";
      ASSERT_NEAR(hits[i].t, distances[i], 1e-4f) << i << " at " << lanes << " lanes";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Watertight, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace aerostat::test

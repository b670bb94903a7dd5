#include "oracle.hpp"

#ifdef AEROSTAT_EMBREE
#include "support/embree_mesh.hpp"
#endif

namespace aerostat::test {

#ifdef AEROSTAT_EMBREE

struct Oracle::State {
  explicit State(const ExportedWorld& given)
      : world(given), mesh(world.positions, world.triangles) {}
  const ExportedWorld& world;
  EmbreeMesh mesh;
};

Oracle::Answer Oracle::nearest(const dvec3& origin, const dvec3& direction) const {
  const EmbreeMesh::Hit hit = state_->mesh.nearest(vec3(origin), vec3(direction));
  if (!hit.met()) return {};
  return {hit.distance, state_->world.objects[hit.triangle], hit.triangle};
}

int Oracle::stride() {
  return 1;
}

#else

struct Oracle::State {
  explicit State(const ExportedWorld& given) : world(given) {}
  const ExportedWorld& world;
};

Oracle::Answer Oracle::nearest(const dvec3& origin, const dvec3& direction) const {
  const ExportedWorld& world = state_->world;
  Answer answer;
  for (std::size_t i = 0; i < world.triangles.size(); ++i) {
    const uvec3& t = world.triangles[i];
    const dvec3 v0(world.positions[t.x]);
    const dvec3 e1 = dvec3(world.positions[t.y]) - v0, e2 = dvec3(world.positions[t.z]) - v0;
    const dvec3 p = glm::cross(direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0.0) continue;
    const dvec3 s = origin - v0;
    const double u = glm::dot(s, p) / determinant;
    if (u < 0.0 || u > 1.0) continue;
    const dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(direction, q) / determinant;
    const double distance = glm::dot(e2, q) / determinant;
    if (v < 0.0 || u + v > 1.0 || distance <= 0.0 || distance >= answer.distance) continue;
    answer = {distance, world.objects[i], i};
  }
  return answer;
}

int Oracle::stride() {
  return 16;
}

#endif

Oracle::Oracle(const ExportedWorld& world) : state_(std::make_unique<State>(world)) {}

Oracle::~Oracle() = default;

}  // namespace aerostat::test

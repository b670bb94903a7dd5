#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "plant/foliage.hpp"
#include "plant/random.hpp"
#include "plant/species.hpp"

// This file builds boulders and driftwood.
namespace aerostat::plant {
namespace {

/// The albedos of stone and snow. Chosen by eye.
const vec3 kStone{0.19f, 0.183f, 0.175f};
const vec3 kSnow{0.80f, 0.82f, 0.85f};

/// Returns the unit icosahedron with every triangle split in four, repeated `splits` times.
mesh::TriangleMesh unit_sphere(int splits) {
  const float g = 0.5f + 0.5f * std::sqrt(5.0f);
  mesh::TriangleMesh mesh;
  for (const vec3 p : {vec3(-1, g, 0), vec3(1, g, 0), vec3(-1, -g, 0), vec3(1, -g, 0),
                       vec3(0, -1, g), vec3(0, 1, g), vec3(0, -1, -g), vec3(0, 1, -g),
                       vec3(g, 0, -1), vec3(g, 0, 1), vec3(-g, 0, -1), vec3(-g, 0, 1)}) {
    mesh.positions.push_back(glm::normalize(p));
  }
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int split = 0; split < splits; ++split) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto next = static_cast<std::uint32_t>(mesh.positions.size());
      const auto [found, added] = middles.try_emplace(std::minmax(a, b), next);
      if (added) {
        mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      }
      return found->second;
    };
    std::vector<uvec3> finer;
    for (const uvec3& t : mesh.triangles) {
      const uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
      finer.insert(finer.end(), {{t.x, m.x, m.z}, {t.y, m.y, m.x}, {t.z, m.z, m.y}, m});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// A boulder as a function of the direction from its middle. It is a polyhedron of random planes
/// with worn edges, covered with the grain of the rock.
class Boulder {
 public:
  explicit Boulder(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 15; ++i) planes_.push_back({random_.direction(), random_.range(0.68, 1.0)});
    for (int i = 0; i < 18; ++i) {
      const double frequency = 2.2 * std::pow(1.22, i);
      waves_.push_back({random_.direction() * frequency, random_.turn(), 0.075 / std::pow(1.2, i)});
    }
    stretch_ = {random_.range(1.0, 1.35), random_.range(0.72, 0.95), random_.range(0.85, 1.1)};
  }

  /// Returns the surface in a direction from the middle. The distance is a smooth minimum over the
  /// distances of the planes, computed as a sum of powers.
  dvec3 at(const dvec3& direction) const {
    double sum = 0.0;
    for (const Plane& plane : planes_) {
      const double slope = std::max(glm::dot(direction, plane.normal), 0.0) / plane.distance;
      sum += std::pow(slope, 22.0);
    }
    const double radius = std::min(std::pow(sum, -1.0 / 22.0), 1.5);
    return direction * stretch_ * (radius + grain(direction * radius));
  }

  double grain(const dvec3& p) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) {
      sum += wave.height * (std::abs(std::sin(glm::dot(p, wave.vector) + wave.phase)) - 0.64);
    }
    return sum * 0.8;
  }

 private:
  struct Plane {
    dvec3 normal;
    double distance;
  };
  struct Wave {
    dvec3 vector;
    double phase, height;
  };
  Random random_;
  std::vector<Plane> planes_;
  std::vector<Wave> waves_;
  dvec3 stretch_{1.0};
};

}  // namespace

void build_boulder(mesh::TriangleMesh& mesh, int variant, bool snowy, Detail detail) {
  const int splits[3] = {4, 3, 1};
  mesh = unit_sphere(at_level(splits, detail));
  const Boulder boulder(static_cast<std::uint64_t>(500 + variant));
  std::vector<dvec3> directions(mesh.positions.begin(), mesh.positions.end());
  for (vec3& p : mesh.positions) p = vec3(boulder.at(dvec3(p)) + dvec3(0.0, 0.28, 0.0));
  mesh::compute_normals(mesh);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const vec3& n = mesh.normals[i];
    const double grain = boulder.grain(directions[i] * 1.7);
    const double near_ground = std::clamp(0.6 + 1.1 * mesh.positions[i].y, 0.6, 1.0);
    const vec3 stone = kStone * static_cast<float>((1.0 + 1.6 * grain) * near_ground);
    const float lies = std::clamp((n.y - 0.55f + static_cast<float>(grain)) * 9.0f, 0.0f, 1.0f);
    mesh.colors.push_back(snowy ? glm::mix(stone, kSnow, lies) : stone);
  }
}

void build_driftwood(mesh::TriangleMesh& mesh, int variant, Detail detail) {
  Random random(static_cast<std::uint64_t>(520 + variant));
  const vec3 grey(0.29f, 0.265f, 0.23f);
  const int sides[3] = {12, 7, 3};
  const int pieces[3] = {26, 10, 3};
  const int count = at_level(pieces, detail);
  std::vector<dvec3> trunk;
  for (int i = 0; i <= count; ++i) {
    const double s = static_cast<double>(i) / count;
    trunk.emplace_back(4.2 * s - 2.1, 0.12 + 0.05 * std::sin(7.0 * s), 0.25 * std::sin(2.6 * s));
  }
  add_wood(mesh, trunk, 0.17, 0.05, at_level(sides, detail), grey);
  for (int k = 0; k < 4; ++k) {
    const dvec3 from = trunk[static_cast<std::size_t>((count * (k + 1) + 3) / 6)];
    const double around = random.turn();
    const dvec3 out = level_direction(around) * 0.5 + dvec3(0.3, 0.36, 0.0);
    const double length = random.range(0.5, 1.1);
    const dvec3 path[3] = {from, from + out * (0.5 * length),
                           from + out * length + dvec3(0.1, -0.06, 0.0)};
    add_wood(mesh, path, 0.07, 0.02, std::max(at_level(sides, detail) / 2 + 1, 3), grey * 0.95f);
  }
}

}  // namespace aerostat::plant

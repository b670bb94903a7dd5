// Tests that the box tests lose no child that a ray hits, and that they let few others through.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "bvh_node.h"
#include "probe.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kPacket = 16;
constexpr std::size_t kNodes = 1000;

struct BoxRay {
  vec3 origin, direction;
  float t_max = kInfinity;
};

float uniform(std::mt19937& random, float lo, float hi) {
  return std::uniform_real_distribution<float>(lo, hi)(random);
}

vec3 in_cube(std::mt19937& random, float half) {
  const float x = uniform(random, -half, half), y = uniform(random, -half, half);
  return {x, y, uniform(random, -half, half)};
}

vec3 unit(std::mt19937& random) {
  vec3 v = in_cube(random, 1.0f);
  while (glm::length(v) < 0.1f) v = in_cube(random, 1.0f);
  return glm::normalize(v);
}

AeroBvhNode empty_node() {
  AeroBvhNode node{};
  for (int c = 0; c < AERO_BVH_WIDTH; ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      node.lo[axis][c] = kInfinity;
      node.hi[axis][c] = -kInfinity;
    }
    node.child[c] = AERO_BVH_EMPTY;
  }
  return node;
}

void set_child(AeroBvhNode& node, int c, const vec3& lo, const vec3& hi) {
  for (int axis = 0; axis < 3; ++axis) {
    node.lo[axis][c] = lo[axis];
    node.hi[axis][c] = hi[axis];
  }
  node.child[c] = static_cast<std::uint32_t>(c) + 1;
}

/// Returns a node with boxes of many sizes in [-10, 10]^3. Every sixth box is flat on an axis, and
/// the last slots may be empty.
AeroBvhNode random_node(std::mt19937& random, float scale) {
  AeroBvhNode node = empty_node();
  const int children = 4 + static_cast<int>(random() % 5);
  for (int c = 0; c < children; ++c) {
    const vec3 centre = in_cube(random, 10.0f * scale);
    const float size = std::pow(10.0f, uniform(random, -2.0f, 0.8f)) * scale;
    vec3 half = glm::abs(in_cube(random, 1.0f)) * size;
    if (random() % 6 == 0) half[static_cast<int>(random() % 3)] = 0.0f;
    set_child(node, c, centre - half, centre + half);
  }
  return node;
}

struct Answers {
  std::vector<std::uint32_t> met, kept;
  std::vector<float> enter;
  /// Tells which packets made a frustum. It is empty if frustums were not requested.
  std::vector<std::uint32_t> frustums;
};

/// Runs the general tests, and replaces their answers by those of frustums if `by_frustum` is true.
Answers ask(const Probe& probe, const std::vector<AeroBvhNode>& nodes,
            const std::vector<BoxRay>& rays, bool by_frustum = false) {
  std::vector<vec3> origins, directions;
  std::vector<float> reaches;
  for (const BoxRay& ray : rays) {
    origins.push_back(ray.origin);
    directions.push_back(ray.direction);
    reaches.push_back(ray.t_max);
  }
  const std::size_t packets = rays.size() / static_cast<std::size_t>(probe.lanes());
  const auto met = output<std::uint32_t>(rays.size()), kept = output<std::uint32_t>(packets);
  const auto enter = output<float>(8 * packets);
  probe.run("probe_children", rays.size(), input(nodes), input(planes(origins)),
            input(planes(directions)), input(reaches), met, kept, enter);
  if (!by_frustum) return {met.read(), kept.read(), enter.read(), {}};
  const auto frustums = output<std::uint32_t>(packets);
  probe.run("probe_frustum", rays.size(), input(nodes), input(planes(origins)),
            input(planes(directions)), input(reaches), met, kept, enter, frustums);
  return {met.read(), kept.read(), enter.read(), frustums.read()};
}

struct Slab {
  double enter = 0.0, leave = 0.0;
  bool met = false;
};

/// Returns the closed slab test in double precision. Each side of the box is moved outwards by
/// `margin`.
Slab exact_slab(const AeroBvhNode& node, int c, const BoxRay& ray, double margin) {
  double enter = 0.0, leave = static_cast<double>(ray.t_max);
  for (int axis = 0; axis < 3; ++axis) {
    const double o = static_cast<double>(ray.origin[axis]);
    const double d = static_cast<double>(ray.direction[axis]);
    const double lo = static_cast<double>(node.lo[axis][c]) - margin - o;
    const double hi = static_cast<double>(node.hi[axis][c]) + margin - o;
    if (d == 0.0) {
      if (lo > 0.0 || hi < 0.0) return {};
      continue;
    }
    enter = std::max(enter, std::min(lo / d, hi / d));
    leave = std::min(leave, std::max(lo / d, hi / d));
  }
  return {enter, leave, enter <= leave};
}

/// Adds the rays of a packet, towards its node and around it.
using MakePacket = std::function<void(std::mt19937&, const AeroBvhNode&, std::vector<BoxRay>&)>;

struct Scenario {
  const char* name;
  float scale;
  MakePacket make;
};

vec3 point_in(std::mt19937& random, const AeroBvhNode& node, int c) {
  vec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] =
        node.lo[axis][c] + (node.hi[axis][c] - node.lo[axis][c]) * uniform(random, 0.0f, 1.0f);
  }
  return p;
}

BoxRay aimed(std::mt19937& random, const AeroBvhNode& node, const vec3& eye) {
  const vec3 target = point_in(random, node, static_cast<int>(random() % 4));
  return {eye, glm::normalize(target - eye + 1e-6f * unit(random))};
}

float size_of(const AeroBvhNode& node) {
  return std::abs(node.lo[0][0]) + std::abs(node.hi[1][0]) + std::abs(node.lo[2][1]);
}

void along_axes(std::mt19937& random, const AeroBvhNode& node, std::vector<BoxRay>& rays) {
  for (std::size_t i = 0; i < kPacket; ++i) {
    vec3 direction(random() % 2 == 0 ? 0.0f : -0.0f);
    const int axis = static_cast<int>(random() % 3);
    direction[axis] = random() % 2 == 0 ? 1.0f : -1.0f;
    const vec3 target = point_in(random, node, static_cast<int>(random() % 4));
    rays.push_back({target - direction * uniform(random, -1.0f, 1.0f) * size_of(node), direction});
  }
}

void in_a_plane(std::mt19937& random, const AeroBvhNode& node, std::vector<BoxRay>& rays) {
  const vec3 eye = unit(random) * size_of(node);
  for (std::size_t i = 0; i < kPacket; ++i) {
    BoxRay ray = aimed(random, node, eye);
    const int axis = static_cast<int>(random() % 3);
    ray.origin[axis] = point_in(random, node, static_cast<int>(random() % 4))[axis];
    ray.direction[axis] = 0.0f;
    ray.direction = glm::normalize(ray.direction);
    rays.push_back(ray);
  }
}

std::vector<Scenario> scenarios() {
  const auto coherent = [](std::mt19937& random, const AeroBvhNode& node, auto& rays) {
    const vec3 eye = unit(random) * 3.0f * size_of(node);
    for (std::size_t i = 0; i < kPacket; ++i) rays.push_back(aimed(random, node, eye));
  };
  const auto scattered = [](std::mt19937& random, const AeroBvhNode& node, auto& rays) {
    for (std::size_t i = 0; i < kPacket; ++i) {
      rays.push_back(aimed(random, node, unit(random) * size_of(node)));
    }
  };
  const auto inside = [](std::mt19937& random, const AeroBvhNode& node, auto& rays) {
    for (std::size_t i = 0; i < kPacket; ++i) {
      rays.push_back({point_in(random, node, static_cast<int>(random() % 4)), unit(random)});
    }
  };
  const auto one_lane = [=](std::mt19937& random, const AeroBvhNode& node, auto& rays) {
    const std::size_t first = rays.size();
    scattered(random, node, rays);
    const std::size_t on = random() % kPacket;
    for (std::size_t i = 0; i < kPacket; ++i) {
      if (i != on) rays[first + i].t_max = -1.0f;
    }
  };
  const auto short_rays = [=](std::mt19937& random, const AeroBvhNode& node, auto& rays) {
    const std::size_t first = rays.size();
    coherent(random, node, rays);
    for (std::size_t i = 0; i < kPacket; ++i) {
      rays[first + i].t_max = uniform(random, 0.0f, 6.0f) * size_of(node);
    }
  };
  return {{"coherent", 1.0f, coherent},     {"scattered", 1.0f, scattered},
          {"inside", 1.0f, inside},         {"along_axes", 1.0f, along_axes},
          {"in_a_plane", 1.0f, in_a_plane}, {"one_lane", 1.0f, one_lane},
          {"short_rays", 1.0f, short_rays}, {"huge", 1e6f, coherent},
          {"tiny", 1e-4f, scattered}};
}

class Boxes : public LaneTest {
 protected:
  const Probe probe{"box.cl", GetParam()};
  const std::size_t lanes = static_cast<std::size_t>(GetParam());
};

/// The errors over all rays and children of a scenario.
struct Tally {
  int met = 0, missed = 0, far_off = 0, culled = 0, late = 0;
};

void compare(const Answers& answers, const std::vector<AeroBvhNode>& nodes,
             const std::vector<BoxRay>& rays, std::size_t lanes, Tally& tally) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const AeroBvhNode& node = nodes[i / kPacket];
    const std::uint32_t kept = answers.kept[i / lanes];
    for (int c = 0; c < AERO_BVH_WIDTH; ++c) {
      if (node.child[c] == AERO_BVH_EMPTY) {
        tally.far_off += static_cast<int>(kept >> c & 1u);
        continue;
      }
      const bool met = (answers.met[i] >> c & 1u) != 0;
      const Slab slab = exact_slab(node, c, rays[i], 0.0);
      const double reach = glm::length(dvec3(rays[i].origin)) + static_cast<double>(size_of(node));
      if (rays[i].t_max < 0.0f) {
        tally.far_off += met ? 1 : 0;
        continue;
      }
      tally.met += slab.met ? 1 : 0;
      tally.missed += slab.met && !met ? 1 : 0;
      // The tolerance is a few roundings of the distances involved.
      tally.far_off += met && !exact_slab(node, c, rays[i], 1e-5 * reach).met &&
                       static_cast<double>(rays[i].t_max) > slab.enter * 1.00001;
      tally.culled += (met || slab.met) && (kept >> c & 1u) == 0 ? 1 : 0;
      const double bound = static_cast<double>(answers.enter[i / lanes * 8 + std::size_t(c)]);
      tally.late += slab.met && bound > slab.enter * (1.0 + 1e-6) + 1e-6 * reach ? 1 : 0;
    }
  }
}

TEST_P(Boxes, NoChildThatARayMeetsIsLeftOut) {
  for (const Scenario& scenario : scenarios()) {
    std::mt19937 random(77);
    std::vector<AeroBvhNode> nodes;
    std::vector<BoxRay> rays;
    for (std::size_t n = 0; n < kNodes; ++n) {
      nodes.push_back(random_node(random, scenario.scale));
      scenario.make(random, nodes.back(), rays);
    }
    Tally tally;
    compare(ask(probe, nodes, rays), nodes, rays, lanes, tally);
    EXPECT_GT(tally.met, 500) << scenario.name;
    EXPECT_EQ(tally.missed, 0) << scenario.name << ": hit_child misses what a ray meets";
    EXPECT_EQ(tally.culled, 0) << scenario.name << ": cull_children drops what a ray meets";
    EXPECT_EQ(tally.late, 0) << scenario.name << ": a distance is no lower bound";
    EXPECT_EQ(tally.far_off, 0) << scenario.name << ": children far from a ray are met";
  }
}

TEST_P(Boxes, NoChildThatAFrustumMeetsIsLeftOut) {
  for (const Scenario& scenario : scenarios()) {
    std::mt19937 random(78);
    std::vector<AeroBvhNode> nodes;
    std::vector<BoxRay> rays;
    for (std::size_t n = 0; n < kNodes; ++n) {
      nodes.push_back(random_node(random, scenario.scale));
      scenario.make(random, nodes.back(), rays);
    }
    const Answers answers = ask(probe, nodes, rays, true);
    Tally tally;
    compare(answers, nodes, rays, lanes, tally);
    const auto frustums = std::count(answers.frustums.begin(), answers.frustums.end(), 1u);
    if (scenario.name == std::string("coherent")) {
      EXPECT_GT(frustums * 4, static_cast<std::ptrdiff_t>(answers.frustums.size()));
    }
    if (scenario.name == std::string("along_axes")) {
      EXPECT_EQ(frustums, 0);
    }
    EXPECT_EQ(tally.missed, 0) << scenario.name << ": hit_child_by_cone misses what a ray meets";
    EXPECT_EQ(tally.culled, 0) << scenario.name << ": cull_by_frustum drops what a ray meets";
    EXPECT_EQ(tally.late, 0) << scenario.name << ": a distance is no lower bound";
    EXPECT_EQ(tally.far_off, 0) << scenario.name << ": children far from a ray are met";
  }
}

// Tests rays that graze a box exactly: along its faces and edges, and towards its corners.
TEST_P(Boxes, FacesEdgesAndCornersBelongToTheBox) {
  std::vector<AeroBvhNode> nodes;
  std::vector<BoxRay> rays;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      AeroBvhNode node = empty_node();
      set_child(node, 0, {-1, -1, -1}, {2, 2, 2});
      vec3 flat_hi(2.0f);
      flat_hi[(axis + 1) % 3] = -1.0f;
      set_child(node, 1, vec3(-1.0f), flat_hi);
      nodes.push_back(node);
      for (std::size_t i = 0; i < kPacket; ++i) {
        BoxRay ray{vec3(0.5f), vec3(i % 2 == 0 ? 0.0f : -0.0f)};
        ray.origin[axis] = i < 8 ? -5.0f : 7.0f;
        ray.direction[axis] = i < 8 ? 1.0f : -1.0f;
        ray.origin[(axis + 1) % 3] = corner % 2 == 0 ? -1.0f : 2.0f;
        if (i % 4 < 2) ray.origin[(axis + 2) % 3] = corner < 2 ? -1.0f : 2.0f;
        rays.push_back(ray);
      }
    }
  }
  Tally tally;
  compare(ask(probe, nodes, rays), nodes, rays, lanes, tally);
  EXPECT_GT(tally.met, 200);
  EXPECT_EQ(tally.missed, 0) << "hit_child misses what a ray meets";
  EXPECT_EQ(tally.culled, 0) << "cull_children drops what a ray meets";
}

AEROSTAT_AT_EVERY_WIDTH(Boxes);

}  // namespace
}  // namespace aerostat::test

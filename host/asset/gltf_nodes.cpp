#include "asset/gltf_nodes.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace aerostat::asset {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr std::array<double, 16> kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

dmat4 local_of(const JsonValue& node) {
  const JsonValue translation = node["translation"], rotation = node["rotation"];
  const JsonValue scale = node["scale"], matrix = node["matrix"];
  if (!matrix.exists()) {
    const auto t = translation.numbers<3>({0, 0, 0});
    const auto r = rotation.numbers<4>({0, 0, 0, 1});
    const auto s = scale.numbers<3>({1, 1, 1});
    if (r == std::array<double, 4>{}) rotation.fail("a quaternion of length 1");
    return composed({t[0], t[1], t[2]}, {r[0], r[1], r[2], r[3]}, {s[0], s[1], s[2]});
  }
  if (translation.exists() || rotation.exists() || scale.exists()) {
    matrix.fail("either a matrix or translation, rotation and scale");
  }
  const std::array<double, 16> m = matrix.numbers<16>(kIdentity);
  if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0) {
    matrix.fail("a matrix whose last row is 0, 0, 0, 1");
  }
  dmat4 local;
  for (int i = 0; i < 16; ++i) local[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
  return local;
}

/// Computes the transforms of all nodes. Parents come before their children.
class Composer {
 public:
  Composer(const JsonValue& nodes, const Limits& limits, std::vector<GltfNode>& result)
      : nodes_(nodes), limits_(limits), result_(result), children_(nodes.size()) {}

  void compose() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const JsonValue children = nodes_.at(i)["children"];
      for (std::size_t k = 0; k < children.size(); ++k) {
        const std::size_t child = children.at(k).index(nodes_.size(), "nodes");
        if (result_[child].parent) children.at(k).fail("a node that has no other parent");
        result_[child].parent = i;
        children_[i].push_back(child);
      }
    }
    std::size_t reached = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!result_[i].parent) reached += compose_below(i);
    }
    if (reached < nodes_.size()) {
      nodes_.fail("nodes that are their own parents", "trees of nodes");
    }
  }

  void show(std::size_t top) {
    std::vector<std::size_t> waiting = {top};
    while (!waiting.empty()) {
      const std::size_t i = waiting.back();
      waiting.pop_back();
      result_[i].is_shown = true;
      waiting.insert(waiting.end(), children_[i].begin(), children_[i].end());
    }
  }

 private:
  struct Step {
    std::size_t node, depth;
  };

  /// Returns the number of nodes of a tree.
  std::size_t compose_below(std::size_t top) {
    std::size_t count = 0;
    std::vector<Step> waiting = {{top, 1}};
    while (!waiting.empty()) {
      const auto [i, depth] = waiting.back();
      waiting.pop_back();
      ++count;
      if (depth > limits_.node_depth) {
        nodes_.at(i).fail("deeper nesting of nodes",
                          fmt::format("at most {} levels", limits_.node_depth));
      }
      GltfNode& node = result_[i];
      node.global = local_of(nodes_.at(i));
      if (node.parent) node.global = result_[*node.parent].global * node.global;
      for (const std::size_t child : children_[i]) waiting.push_back({child, depth + 1});
    }
    return count;
  }

  const JsonValue& nodes_;
  const Limits& limits_;
  std::vector<GltfNode>& result_;
  std::vector<std::vector<std::size_t>> children_;
};

}  // namespace

dmat4 composed(const dvec3& translation, const dvec4& rotation, const dvec3& scale) {
  const double length = glm::length(rotation);
  const dvec4 q = length > 0.0 ? rotation / length : dvec4(0.0, 0.0, 0.0, 1.0);
  const dvec3 v(q);
  const auto turned = [&](const dvec3& p) {
    return p + 2.0 * glm::cross(v, glm::cross(v, p) + q.w * p);
  };
  return {dvec4(turned({scale.x, 0.0, 0.0}), 0.0), dvec4(turned({0.0, scale.y, 0.0}), 0.0),
          dvec4(turned({0.0, 0.0, scale.z}), 0.0), dvec4(translation, 1.0)};
}

std::vector<GltfNode> read_gltf_nodes(const JsonValue& root, Budget& budget) {
  const JsonValue nodes = root["nodes"], scenes = root["scenes"], scene = root["scene"];
  budget.take_nodes(nodes.size());
  std::vector<GltfNode> result(nodes.size());
  Composer composer(nodes, budget.limits(), result);
  composer.compose();
  if (scene.exists() || scenes.size() > 0) {
    const std::size_t shown = scene.exists() ? scene.index(scenes.size(), "scenes") : 0;
    const JsonValue tops = scenes.at(shown)["nodes"];
    for (std::size_t i = 0; i < tops.size(); ++i) {
      const std::size_t top = tops.at(i).index(nodes.size(), "nodes");
      if (result[top].parent) tops.at(i).fail("a node that has no parent");
      if (!result[top].is_shown) composer.show(top);
    }
    return result;
  }
  for (GltfNode& node : result) node.is_shown = true;
  return result;
}

}  // namespace aerostat::asset

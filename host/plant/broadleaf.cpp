#include <algorithm>
#include <cmath>
#include <vector>

#include "plant/foliage.hpp"
#include "plant/random.hpp"
#include "plant/species.hpp"

namespace aerostat::plant {
namespace {

/// The shape of a crown of leaf clusters over a trunk that forks. It ranges from rain forest giants
/// to acacias and shrubs. All values are chosen by eye.
struct Tree {
  /// The height of the crown's middle in metres.
  double crown_y;
  /// The half axes of the crown in metres.
  dvec3 crown;
  /// The radius of a cluster in metres.
  double cluster_m;
  /// The height of a cluster divided by its width.
  double flat;
  /// The height in metres at which limbs leave the trunk. With 0 they rise from the ground.
  double fork_y;
  /// The radius of the trunk at its foot in metres.
  double trunk_m;
  /// The share of the crown's half height above which clusters lie, from -1 to 1.
  double lowest;
  /// The share of the crown's radius beyond which clusters lie.
  double hollow;
  /// The length in metres of a leaf or spray at the near level.
  double leaf_m;
  /// The width of a leaf divided by its length.
  double leaf_wide;
  /// The light inside the crown.
  double dark;
  vec3 green;
  vec3 bark;
};
const Tree kBroadleaves[] = {{.crown_y = 9.0,
                              .crown = {4.9, 3.7, 4.9},
                              .cluster_m = 1.35,
                              .flat = 0.75,
                              .fork_y = 4.6,
                              .trunk_m = 0.34,
                              .lowest = -0.62,
                              .hollow = 0.5,
                              .leaf_m = 0.44,
                              .leaf_wide = 0.5,
                              .dark = 0.5,
                              .green = {0.086f, 0.150f, 0.034f},
                              .bark = {0.15f, 0.13f, 0.105f}},
                             {.crown_y = 12.6,
                              .crown = {5.6, 3.0, 5.6},
                              .cluster_m = 1.5,
                              .flat = 0.6,
                              .fork_y = 8.2,
                              .trunk_m = 0.42,
                              .lowest = -0.5,
                              .hollow = 0.5,
                              .leaf_m = 0.46,
                              .leaf_wide = 0.48,
                              .dark = 0.5,
                              .green = {0.074f, 0.140f, 0.036f},
                              .bark = {0.19f, 0.175f, 0.15f}},
                             {.crown_y = 7.0,
                              .crown = {3.9, 4.0, 3.9},
                              .cluster_m = 1.2,
                              .flat = 0.85,
                              .fork_y = 2.6,
                              .trunk_m = 0.27,
                              .lowest = -0.8,
                              .hollow = 0.45,
                              .leaf_m = 0.4,
                              .leaf_wide = 0.55,
                              .dark = 0.5,
                              .green = {0.100f, 0.160f, 0.034f},
                              .bark = {0.13f, 0.11f, 0.09f}}};
const Tree kBirches[] = {{.crown_y = 8.6,
                          .crown = {2.5, 4.9, 2.5},
                          .cluster_m = 0.95,
                          .flat = 1.05,
                          .fork_y = 4.4,
                          .trunk_m = 0.15,
                          .lowest = -0.85,
                          .hollow = 0.3,
                          .leaf_m = 0.26,
                          .leaf_wide = 0.6,
                          .dark = 0.55,
                          .green = {0.105f, 0.155f, 0.036f},
                          .bark = {0.52f, 0.50f, 0.46f}},
                         {.crown_y = 10.6,
                          .crown = {2.8, 5.4, 2.8},
                          .cluster_m = 1.05,
                          .flat = 1.0,
                          .fork_y = 6.2,
                          .trunk_m = 0.18,
                          .lowest = -0.8,
                          .hollow = 0.3,
                          .leaf_m = 0.28,
                          .leaf_wide = 0.6,
                          .dark = 0.55,
                          .green = {0.098f, 0.150f, 0.036f},
                          .bark = {0.50f, 0.48f, 0.44f}}};
/// The albedo of birch leaves in autumn.
const vec3 kGoldenLeaves{0.40f, 0.265f, 0.035f};
const Tree kAcacias[] = {{.crown_y = 4.7,
                          .crown = {3.9, 0.75, 3.9},
                          .cluster_m = 0.85,
                          .flat = 0.42,
                          .fork_y = 1.5,
                          .trunk_m = 0.17,
                          .lowest = -0.6,
                          .hollow = 0.15,
                          .leaf_m = 0.2,
                          .leaf_wide = 0.4,
                          .dark = 0.7,
                          .green = {0.085f, 0.098f, 0.046f},
                          .bark = {0.15f, 0.12f, 0.095f}},
                         {.crown_y = 6.1,
                          .crown = {4.8, 0.9, 4.4},
                          .cluster_m = 0.95,
                          .flat = 0.4,
                          .fork_y = 2.1,
                          .trunk_m = 0.21,
                          .lowest = -0.6,
                          .hollow = 0.15,
                          .leaf_m = 0.21,
                          .leaf_wide = 0.4,
                          .dark = 0.7,
                          .green = {0.078f, 0.095f, 0.042f},
                          .bark = {0.14f, 0.11f, 0.085f}}};
const Tree kShrubs[] = {{.crown_y = 0.72,
                         .crown = {1.1, 0.85, 1.1},
                         .cluster_m = 0.45,
                         .flat = 0.85,
                         .fork_y = 0.0,
                         .trunk_m = 0.045,
                         .lowest = -0.75,
                         .hollow = 0.45,
                         .leaf_m = 0.2,
                         .leaf_wide = 0.5,
                         .dark = 0.5,
                         .green = {0.062f, 0.122f, 0.026f},
                         .bark = {0.13f, 0.11f, 0.085f}},
                        {.crown_y = 1.02,
                         .crown = {1.25, 1.3, 1.25},
                         .cluster_m = 0.5,
                         .flat = 0.9,
                         .fork_y = 0.0,
                         .trunk_m = 0.055,
                         .lowest = -0.8,
                         .hollow = 0.45,
                         .leaf_m = 0.24,
                         .leaf_wide = 0.42,
                         .dark = 0.5,
                         .green = {0.080f, 0.130f, 0.028f},
                         .bark = {0.13f, 0.11f, 0.085f}}};

struct Level {
  int clusters;
  /// The number of leaves in a cluster.
  int leaves;
  /// The length of a leaf in radii of a cluster. With 0 it is `leaf_m`.
  double leaf_reach;
  int limbs;
  /// Tells whether limbs divide into a twig for every other cluster.
  bool fine;
  /// The number of clusters with a dark core.
  int cores;
  /// The size of a core in sizes of its cluster.
  double core;
};
constexpr Level kLevels[3] = {{78, 96, 0.0, 9, true, 78, 0.62},
                              {40, 17, 0.75, 5, false, 32, 0.7},
                              {20, 4, 1.7, 0, false, 5, 0.9}};

class TreeBuilder {
 public:
  TreeBuilder(mesh::TriangleMesh& mesh, const Tree& tree, const Level& level, std::uint64_t seed)
      : mesh_(mesh), tree_(tree), level_(level), random_(seed) {
    middle_ = {0.0, tree.crown_y, 0.0};
    crown_ = ellipsoid_crown(middle_, tree.crown + dvec3(0.4 * tree.cluster_m), tree.dark);
  }

  void build() {
    place_clusters();
    if (tree_.fork_y > 0.0) add_trunk();
    if (!level_.fine) {
      // Between few clusters, one large core keeps the light out.
      const dvec3 radii = tree_.crown * 0.66 + dvec3(0.0, 0.35 * tree_.cluster_m, 0.0);
      add_core(mesh_, middle_, radii, tree_.green * 0.6f, 0.4, crown_);
    }
    add_limbs();
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      if (static_cast<int>(i * static_cast<std::size_t>(level_.cores) / clusters_.size()) !=
          static_cast<int>((i + 1) * static_cast<std::size_t>(level_.cores) / clusters_.size())) {
        add_core(mesh_, clusters_[i] - dvec3(0.0, 0.12 * tree_.cluster_m, 0.0),
                 cluster_size(i) * (level_.core * std::min(0.4 + 0.8 * tree_.flat, 1.0)),
                 tree_.green * 0.6f, random_.turn(), crown_);
      }
      add_leaves(i);
    }
  }

 private:
  dvec3 cluster_size(std::size_t i) const {
    return dvec3(1.0, tree_.flat, 1.0) * (tree_.cluster_m * sizes_[i]);
  }

  /// Places clusters evenly around the crown, from its lowest cluster to its top, at uneven depths.
  void place_clusters() {
    const double share = static_cast<double>(kLevels[0].clusters) / level_.clusters;
    const double swell = std::pow(share, 0.28);
    for (int k = 0; k < level_.clusters; ++k) {
      const double u = (k + 0.5) / level_.clusters;
      const double y = tree_.lowest + (0.98 - tree_.lowest) * u + random_.range(-0.06, 0.06);
      const double level = std::sqrt(std::max(1.0 - y * y, 0.02));
      const double around = 2.399963 * k + random_.range(-0.3, 0.3);
      const double deep = tree_.hollow + (0.92 - tree_.hollow) * std::sqrt(random_.unit());
      const dvec3 direction = level_direction(around) * level + dvec3(0.0, y, 0.0);
      clusters_.push_back(middle_ + direction * tree_.crown * deep);
      sizes_.push_back(swell * random_.range(0.75, 1.2));
    }
  }

  void add_trunk() {
    const dvec3 path[4] = {
        {0.0, -0.4, 0.0},
        {0.05, 0.1 * tree_.fork_y, 0.02},
        {-0.06, 0.6 * tree_.fork_y, 0.05},
        {0.0, level_.limbs > 0 ? tree_.fork_y + 0.2 * tree_.cluster_m : tree_.crown_y, 0.0}};
    const int sides = level_.fine ? 10 : (level_.limbs > 0 ? 5 : 3);
    add_wood(mesh_, path, tree_.trunk_m, 0.62 * tree_.trunk_m, sides, tree_.bark);
  }

  /// Adds nearly straight limbs from the fork outwards and up, and twigs from their ends to the
  /// clusters.
  void add_limbs() {
    const double radius = tree_.trunk_m * (tree_.fork_y > 0.0 ? 0.42 : 0.6);
    std::vector<dvec3> ends;
    for (int i = 0; i < level_.limbs; ++i) {
      const auto target = clusters_.size() * (2 * static_cast<std::size_t>(i) + 1) /
                          (2 * static_cast<std::size_t>(level_.limbs));
      const dvec3 from(0.0, std::max(tree_.fork_y * random_.range(0.85, 1.0), 0.02), 0.0);
      const dvec3 reach = clusters_[target] - from;
      const dvec3 end = from + reach * dvec3(0.55, 0.7, 0.55);
      const dvec3 bow = 0.06 * glm::length(reach) * random_.direction();
      const dvec3 path[4] = {from, glm::mix(from, end, 0.35) + bow, glm::mix(from, end, 0.7) + bow,
                             end};
      add_wood(mesh_, path, radius, 0.5 * radius, level_.fine ? 6 : 3, tree_.bark);
      ends.push_back(end);
    }
    for (std::size_t i = 0; i < clusters_.size() && !ends.empty(); i += level_.fine ? 2 : 4) {
      add_twig(ends, clusters_[i], 0.45 * radius);
    }
  }

  void add_twig(const std::vector<dvec3>& ends, const dvec3& to, double radius) {
    const dvec3 from = *std::min_element(ends.begin(), ends.end(), [&](auto& a, auto& b) {
      return glm::distance(a, to) < glm::distance(b, to);
    });
    const dvec3 middle =
        glm::mix(from, to, 0.5) + 0.08 * glm::distance(from, to) * random_.direction();
    const dvec3 path[3] = {from, middle, to};
    add_wood(mesh_, path, radius, 0.3 * radius, level_.fine ? 4 : 3, tree_.bark);
  }

  /// Adds the leaves of a cluster. They lie on it like tiles, with their tips outwards and down.
  void add_leaves(std::size_t cluster) {
    const vec3 green = random_.varied(tree_.green, 0.24, 0.2);
    const double length =
        level_.leaf_reach > 0.0 ? level_.leaf_reach * tree_.cluster_m : tree_.leaf_m;
    for (int i = 0; i < level_.leaves; ++i) {
      dvec3 out = random_.direction();
      if (out.y < -0.35) out.y = -out.y;
      const dvec3 place =
          clusters_[cluster] + out * cluster_size(cluster) * random_.range(0.55, 1.0);
      const dvec3 face = glm::normalize(out + dvec3(0.0, 0.55, 0.0) + 0.6 * random_.direction());
      const Across axes = across(face);
      const double turn = random_.turn();
      const dvec3 along = glm::normalize(axes.right * std::cos(turn) + axes.up * std::sin(turn) +
                                         0.35 * out - dvec3(0.0, 0.25, 0.0));
      const double size = length * random_.range(0.75, 1.25);
      const dvec3 wide = glm::normalize(glm::cross(face, along));
      add_leaf(mesh_,
               {place - along * (0.5 * size), place + along * (0.5 * size),
                wide * (0.5 * tree_.leaf_wide * size), 0.45, 0.3, random_.varied(green, 0.25, 0.14),
                1.1},
               crown_);
    }
  }

  mesh::TriangleMesh& mesh_;
  const Tree& tree_;
  const Level& level_;
  Random random_;
  dvec3 middle_{0.0};
  std::vector<dvec3> clusters_;
  std::vector<double> sizes_;
  Crown crown_;
};

void build_tree(mesh::TriangleMesh& mesh, const Tree& tree, Detail detail, std::uint64_t seed) {
  TreeBuilder(mesh, tree, at_level(kLevels, detail), seed).build();
}

}  // namespace

void build_broadleaf(mesh::TriangleMesh& mesh, int variant, Detail detail) {
  build_tree(mesh, kBroadleaves[variant], detail, static_cast<std::uint64_t>(300 + variant));
}

void build_birch(mesh::TriangleMesh& mesh, int variant, bool golden, Detail detail) {
  Tree tree = kBirches[variant];
  if (golden) tree.green = kGoldenLeaves;
  build_tree(mesh, tree, detail, static_cast<std::uint64_t>(310 + variant));
}

void build_acacia(mesh::TriangleMesh& mesh, int variant, Detail detail) {
  build_tree(mesh, kAcacias[variant], detail, static_cast<std::uint64_t>(320 + variant));
}

void build_shrub(mesh::TriangleMesh& mesh, int variant, Detail detail) {
  build_tree(mesh, kShrubs[variant], detail, static_cast<std::uint64_t>(340 + variant));
}

}  // namespace aerostat::plant

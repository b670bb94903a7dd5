#include "plant/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/math.hpp"

namespace aerostat::plant {
namespace {

// The rows and columns of the views that are drawn, and the number of views. Chosen by eye.
constexpr int kRows = 48, kColumns = 64, kViews = 5;
// The rings of the body, and its corners around. Chosen by eye.
constexpr int kRings = 7, kSides = 6;
// The share of the light that leaves of a crown leave to each other. It makes woods of outlines as
// bright as woods of far models in scenes/snow.json.
constexpr float kSelfShade = 0.78f;
// How much normals point up, as those of crowns (see shade() of conifers). Chosen by eye.
constexpr float kUp = 0.5f;

/// What is seen in a row of all views: the covered width in metres, and the sum of the colours of
/// covered cells.
struct Row {
  float width = 0.0f, cells = 0.0f;
  vec3 color{0.0f};
};

struct Extent {
  float foot = 0.0f, top = 0.0f, reach = 0.0f;
};

Extent extent_of(const mesh::TriangleMesh& mesh) {
  Extent extent;
  for (const vec3& p : mesh.positions) {
    extent.foot = std::min(extent.foot, p.y);
    extent.top = std::max(extent.top, p.y);
    extent.reach = std::max(extent.reach, std::hypot(p.x, p.z));
  }
  return extent;
}

/// A view of a plant from the side, without perspective: the nearest colour of every cell.
class View {
 public:
  View(const mesh::TriangleMesh& mesh, const Extent& extent, float yaw)
      : mesh_(mesh),
        extent_(extent),
        cosine_(std::cos(yaw)),
        sine_(std::sin(yaw)),
        depth_(kRows * kColumns, -kInfinity),
        seen_(kRows * kColumns, vec3(0.0f)) {
    for (const uvec3& triangle : mesh.triangles) draw(triangle);
  }

  void add_to(std::vector<Row>& rows) const {
    for (int row = 0; row < kRows; ++row) {
      Row& sum = rows[static_cast<std::size_t>(row)];
      for (int column = 0; column < kColumns; ++column) {
        const auto at = static_cast<std::size_t>(row * kColumns + column);
        if (depth_[at] == -kInfinity) continue;
        sum.cells += 1.0f;
        sum.width += 2.0f * extent_.reach / (kColumns * kViews);
        sum.color += seen_[at];
      }
    }
  }

 private:
  /// Returns a point as column, row and depth.
  vec3 place(const vec3& p) const {
    const float across = cosine_ * p.x + sine_ * p.z, ahead = cosine_ * p.z - sine_ * p.x;
    return {(across / extent_.reach + 1.0f) * (0.5f * kColumns),
            (p.y - extent_.foot) / (extent_.top - extent_.foot) * kRows, ahead};
  }

  void draw(const uvec3& triangle) {
    const vec3 a = place(mesh_.positions[triangle.x]), b = place(mesh_.positions[triangle.y]),
               c = place(mesh_.positions[triangle.z]);
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0.0f) return;
    const vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    const int last_row = std::min(static_cast<int>(high.y) + 1, kRows);
    const int last_column = std::min(static_cast<int>(high.x) + 1, kColumns);
    for (int row = std::max(static_cast<int>(low.y), 0); row < last_row; ++row) {
      for (int column = std::max(static_cast<int>(low.x), 0); column < last_column; ++column) {
        const float x = static_cast<float>(column) + 0.5f, y = static_cast<float>(row) + 0.5f;
        const float u = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
        const float v = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
        if (u < 0.0f || v < 0.0f || u + v > 1.0f) continue;
        const vec3 weight(1.0f - u - v, u, v);
        const float depth = weight.x * a.z + weight.y * b.z + weight.z * c.z;
        const auto at = static_cast<std::size_t>(row * kColumns + column);
        if (depth <= depth_[at]) continue;
        depth_[at] = depth;
        seen_[at] = weight.x * mesh_.colors[triangle.x] + weight.y * mesh_.colors[triangle.y] +
                    weight.z * mesh_.colors[triangle.z];
      }
    }
  }

  const mesh::TriangleMesh& mesh_;
  const Extent& extent_;
  float cosine_, sine_;
  std::vector<float> depth_;
  std::vector<vec3> seen_;
};

/// Returns the mean of the rows from `first` to before `end`.
Row mean_of(const std::vector<Row>& rows, int first, int end) {
  Row mean;
  for (int i = first; i < end; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    mean.width += row.width / static_cast<float>(end - first);
    mean.cells += row.cells;
    mean.color += row.color;
  }
  if (mean.cells > 0.0f) mean.color /= mean.cells;
  return mean;
}

/// Appends a ring of corners. Every second one is turned by half a side, so that no edge runs up
/// the whole body.
void add_ring(mesh::TriangleMesh& body, float height, float radius, const vec3& color,
              bool turned) {
  for (int k = 0; k < kSides; ++k) {
    const float around = 2.0f * std::numbers::pi_v<float> *
                         (static_cast<float>(k) + (turned ? 0.5f : 0.0f)) / kSides;
    const vec3 outward(std::cos(around), 0.0f, std::sin(around));
    body.positions.push_back(outward * radius + vec3(0.0f, height, 0.0f));
    body.normals.push_back(glm::normalize(outward + vec3(0.0f, kUp, 0.0f)));
    body.colors.push_back(color);
  }
}

/// Joins ring `i` to the next one by two triangles a side, whose order makes them face outwards.
void join_rings(mesh::TriangleMesh& body, std::uint32_t i) {
  const std::uint32_t low = i * kSides, high = low + kSides;
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const std::uint32_t next = (k + 1) % kSides;
    // The upper corner between two lower ones is k in even rings, and one further in odd ones.
    const std::uint32_t between = i % 2 == 0 ? k : next;
    const std::uint32_t after = (between + 1) % kSides;
    body.triangles.emplace_back(low + k, high + between, low + next);
    body.triangles.emplace_back(low + next, high + between, high + after);
  }
}

/// Closes the last ring by a middle above it.
void add_top(mesh::TriangleMesh& body, float height) {
  const auto middle = static_cast<std::uint32_t>(body.positions.size()), ring = middle - kSides;
  const vec3 color = body.colors.back();
  body.positions.emplace_back(0.0f, height, 0.0f);
  body.normals.emplace_back(0.0f, 1.0f, 0.0f);
  body.colors.push_back(color);
  for (std::uint32_t k = 0; k < kSides; ++k) {
    body.triangles.emplace_back(ring + k, middle, ring + (k + 1) % kSides);
  }
}

}  // namespace

mesh::TriangleMesh outline_of(const mesh::TriangleMesh& mesh) {
  const Extent extent = extent_of(mesh);
  std::vector<Row> rows(kRows);
  for (int i = 0; i < kViews; ++i) {
    View(mesh, extent, std::numbers::pi_v<float> * static_cast<float>(i) / kViews).add_to(rows);
  }
  mesh::TriangleMesh body;
  // A regular prism is narrower from the side than its circle: the mean width of a convex figure is
  // its girth divided by pi.
  const float half_widths =
      std::numbers::pi_v<float> /
      (2.0f * kSides * std::sin(std::numbers::pi_v<float> / static_cast<float>(kSides)));
  const float least = 0.004f * (extent.top - extent.foot);
  vec3 color(0.0f);
  for (int ring = 0; ring < kRings; ++ring) {
    const float at = static_cast<float>(ring) / (kRings - 1);
    const int middle = static_cast<int>(at * (kRows - 1));
    constexpr int kAround = kRows / kRings / 2;
    const Row row =
        mean_of(rows, std::max(middle - kAround, 0), std::min(middle + kAround + 1, kRows));
    if (row.cells > 0.0f) color = kSelfShade * row.color;
    const float radius = std::max(row.width * half_widths, least);
    add_ring(body, glm::mix(extent.foot, 0.98f * extent.top, at), radius, color, ring % 2 == 1);
    if (ring > 0) join_rings(body, static_cast<std::uint32_t>(ring - 1));
  }
  add_top(body, extent.top);
  return body;
}

}  // namespace aerostat::plant

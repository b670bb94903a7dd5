#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "terrain_mesh.hpp"

namespace aerostat::terrain {
namespace {

constexpr float kShoreMargin = 0.5f;    // metres of ground above the level that still get a cell
constexpr float kHorizonM = 100000.0f;  // distance of the sea's edge, beyond every horizon
constexpr float kOceanDepth = 400.0f;
constexpr std::uint32_t kUnused = 0xffffffffu;

class WaterBuilder {
 public:
  WaterBuilder(const scene::Terrain& terrain, float level, const mesh::GridMesh& ground)
      : cells_(static_cast<std::uint32_t>(terrain.cells)),
        center_(terrain.center),
        level_(level),
        ground_(ground),
        slot_(std::size_t{cells_ + 1} * (cells_ + 1), kUnused) {}

  void add_cells();
  void add_ocean();

  mesh::TriangleMesh take() { return std::move(mesh_); }

 private:
  /// Returns the position of a ground vertex. Vertices are numbered row by row.
  vec3 ground(std::uint32_t vertex) const {
    return ground_.position(vertex % (cells_ + 1), vertex / (cells_ + 1));
  }

  std::uint32_t add_vertex(float x, float z, float depth) {
    mesh_.positions.emplace_back(x, level_, z);
    mesh_.normals.emplace_back(0.0f, 1.0f, 0.0f);
    mesh_.colors.emplace_back(depth, 0.0f, 0.0f);
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  std::uint32_t over(std::uint32_t ground_vertex) {
    std::uint32_t& slot = slot_[ground_vertex];
    if (slot == kUnused) {
      const vec3 p = ground(ground_vertex);
      slot = add_vertex(p.x, p.z, std::max(level_ - p.y, 0.0f));
    }
    return slot;
  }

  std::vector<std::uint32_t> rim() const;

  std::uint32_t cells_;
  dvec2 center_;
  float level_;
  const mesh::GridMesh& ground_;
  std::vector<std::uint32_t> slot_;  // water vertex over each ground vertex
  mesh::TriangleMesh mesh_;
};

void WaterBuilder::add_cells() {
  const std::uint32_t side = cells_ + 1;
  const float limit = level_ + kShoreMargin;
  for (std::uint32_t j = 0; j < cells_; ++j)
    for (std::uint32_t i = 0; i < cells_; ++i) {
      const std::uint32_t a = j * side + i;
      const std::array<std::uint32_t, 4> corners = {a, a + 1, a + side, a + side + 1};
      if (std::none_of(corners.begin(), corners.end(),
                       [&](std::uint32_t v) { return ground(v).y <= limit; }))
        continue;
      std::array<std::uint32_t, 4> v{};
      std::transform(corners.begin(), corners.end(), v.begin(),
                     [this](std::uint32_t corner) { return over(corner); });
      mesh_.triangles.emplace_back(v[0], v[2], v[3]);
      mesh_.triangles.emplace_back(v[0], v[3], v[1]);
    }
}

/// Returns the vertices of the terrain's border once around, counter-clockwise as seen from
/// above.
std::vector<std::uint32_t> WaterBuilder::rim() const {
  const std::uint32_t side = cells_ + 1;
  std::vector<std::uint32_t> loop;
  for (std::uint32_t j = 0; j < cells_; ++j) loop.push_back(j * side);
  for (std::uint32_t i = 0; i < cells_; ++i) loop.push_back(cells_ * side + i);
  for (std::uint32_t j = cells_; j > 0; --j) loop.push_back(j * side + cells_);
  for (std::uint32_t i = cells_; i > 0; --i) loop.push_back(i);
  return loop;
}

/// Adds rings of growing width from the border outwards. The first ring uses the border's own
/// vertices, because shared edges leave no crack.
void WaterBuilder::add_ocean() {
  const std::vector<std::uint32_t> border = rim();
  std::vector<std::uint32_t> inner(border.size());
  std::transform(border.begin(), border.end(), inner.begin(),
                 [this](std::uint32_t v) { return over(v); });
  const vec3 middle(static_cast<float>(center_.x), 0.0f, static_cast<float>(center_.y));
  const float half = std::fabs(ground(border[0]).x - middle.x);
  for (float reach = 1.0f; reach * half < kHorizonM;) {
    reach = std::min(1.7f * reach, std::max(kHorizonM / half, reach));
    std::vector<std::uint32_t> outer(border.size());
    for (std::size_t k = 0; k < border.size(); ++k) {
      const vec3 out = (ground(border[k]) - middle) * reach + middle;
      outer[k] = add_vertex(out.x, out.z, kOceanDepth);
    }
    for (std::size_t k = 0; k < border.size(); ++k) {
      const std::size_t next = (k + 1) % border.size();
      mesh_.triangles.emplace_back(inner[k], outer[k], outer[next]);
      mesh_.triangles.emplace_back(inner[k], outer[next], inner[next]);
    }
    inner = std::move(outer);
    if (reach * half >= kHorizonM * 0.999f) break;
  }
}

}  // namespace

mesh::TriangleMesh water_mesh(const scene::Terrain& terrain, const scene::Water& water,
                              const mesh::GridMesh& ground) {
  if (!water.enabled) return {};
  const auto cells = static_cast<std::uint32_t>(terrain.cells);
  if (ground.columns() != cells || ground.rows() != cells)
    throw Error(ErrorKind::internal, "water_mesh: the ground is not the mesh of this terrain");
  WaterBuilder builder(terrain, static_cast<float>(water.level_m), ground);
  builder.add_cells();
  if (terrain.kind == scene::TerrainKind::island) builder.add_ocean();
  return builder.take();
}

}  // namespace aerostat::terrain

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "terrain_mesh.hpp"

namespace aerostat::terrain {
namespace {

constexpr float kShoreMargin = 0.5f;    // metres of ground above the level that still get a cell
constexpr float kHorizonM = 100000.0f;  // distance of the sea's edge, beyond every horizon
constexpr float kOceanDepth = 400.0f;
constexpr std::uint32_t kUnused = 0xffffffffu;

using LevelOf = std::function<float(std::uint32_t vertex)>;

class WaterBuilder {
 public:
  /// `level_of` returns the level of the water over a ground vertex, NaN without water. `calm` is
  /// 1 for inland water.
  WaterBuilder(const scene::Terrain& terrain, const mesh::GridMesh& ground, LevelOf level_of,
               float calm)
      : cells_(static_cast<std::uint32_t>(terrain.cells)),
        center_(terrain.center),
        ground_(ground),
        level_of_(std::move(level_of)),
        calm_(calm),
        slot_(std::size_t{cells_ + 1} * (cells_ + 1), kUnused) {
    if (ground.columns() != cells_ || ground.rows() != cells_)
      throw Error(ErrorKind::internal, "a water mesh: the ground is not the mesh of this terrain");
  }

  /// Adds the cells that have a corner less than `margin_m` above the level.
  void add_cells(float margin_m);
  void add_ocean();

  mesh::TriangleMesh take() { return std::move(mesh_); }

 private:
  /// Returns the position of a ground vertex. Vertices are numbered row by row.
  vec3 ground(std::uint32_t vertex) const {
    return ground_.position(vertex % (cells_ + 1), vertex / (cells_ + 1));
  }

  std::uint32_t add_vertex(const vec3& position, float depth) {
    mesh_.positions.push_back(position);
    mesh_.normals.emplace_back(0.0f, 1.0f, 0.0f);
    mesh_.colors.emplace_back(depth, calm_, 0.0f);
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  /// Returns the water over a ground vertex. Where no level is known, it is that of the cell.
  std::uint32_t over(std::uint32_t ground_vertex, float level_of_cell) {
    std::uint32_t& slot = slot_[ground_vertex];
    if (slot == kUnused) {
      const vec3 p = ground(ground_vertex);
      const float own = level_of_(ground_vertex);
      const float level = std::isnan(own) ? level_of_cell : own;
      slot = add_vertex({p.x, level, p.z}, std::max(level - p.y, 0.0f));
    }
    return slot;
  }

  std::vector<std::uint32_t> rim() const;

  std::uint32_t cells_;
  dvec2 center_;
  const mesh::GridMesh& ground_;
  LevelOf level_of_;
  float calm_;
  std::vector<std::uint32_t> slot_;  // water vertex over each ground vertex
  mesh::TriangleMesh mesh_;
};

void WaterBuilder::add_cells(float margin_m) {
  const std::uint32_t side = cells_ + 1;
  for (std::uint32_t j = 0; j < cells_; ++j)
    for (std::uint32_t i = 0; i < cells_; ++i) {
      const std::uint32_t a = j * side + i;
      const std::array<std::uint32_t, 4> corners = {a, a + 1, a + side, a + side + 1};
      const auto wet = std::find_if(corners.begin(), corners.end(), [&](std::uint32_t v) {
        return ground(v).y <= level_of_(v) + margin_m;
      });
      if (wet == corners.end()) continue;
      std::array<std::uint32_t, 4> v{};
      std::transform(corners.begin(), corners.end(), v.begin(),
                     [&](std::uint32_t corner) { return over(corner, level_of_(*wet)); });
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
                 [this](std::uint32_t v) { return over(v, level_of_(v)); });
  const vec3 middle(static_cast<float>(center_.x), 0.0f, static_cast<float>(center_.y));
  const float half = std::fabs(ground(border[0]).x - middle.x);
  for (float reach = 1.0f; reach * half < kHorizonM;) {
    reach = std::min(1.7f * reach, std::max(kHorizonM / half, reach));
    std::vector<std::uint32_t> outer(border.size());
    for (std::size_t k = 0; k < border.size(); ++k) {
      const vec3 out = (ground(border[k]) - middle) * reach + middle;
      outer[k] = add_vertex({out.x, mesh_.positions[inner[k]].y, out.z}, kOceanDepth);
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
  const auto level = static_cast<float>(water.level_m);
  const double fall = scene::ground_fall(terrain);
  const auto level_of = [&, side = ground.columns() + 1](std::uint32_t vertex) {
    if (!(fall > 0.0)) return level;
    const double x = ground.x(vertex % side) - terrain.center.x;
    const double z = ground.z(vertex / side) - terrain.center.y;
    return static_cast<float>(level - fall * (x * x + z * z));
  };
  WaterBuilder builder(terrain, ground, level_of, 0.0f);
  builder.add_cells(kShoreMargin);
  if (terrain.kind == scene::TerrainKind::island) builder.add_ocean();
  return builder.take();
}

mesh::TriangleMesh inland_water_mesh(const scene::Terrain& terrain, const HeightField& field,
                                     const mesh::GridMesh& ground) {
  if (!field.has_water()) return {};
  const std::uint32_t side = ground.columns() + 1;
  const auto spacing = [](const auto& line, std::uint32_t at, std::uint32_t count) {
    const std::uint32_t before = at > 0 ? at - 1 : at, after = std::min(at + 1, count);
    return (line(after) - line(before)) / static_cast<float>(after - before);
  };
  const auto x = [&ground](std::uint32_t i) { return ground.x(i); };
  const auto z = [&ground](std::uint32_t j) { return ground.z(j); };
  std::vector<float> levels(std::size_t{side} * (ground.rows() + 1));
  tbb::parallel_for(0u, ground.rows() + 1, [&, stop = current_stop()](std::uint32_t j) {
    stop_if_asked(stop);
    Points points;
    Block block;
    for (std::uint32_t first = 0; first < side; first += kBlockSize) {
      points.count = static_cast<int>(std::min<std::uint32_t>(kBlockSize, side - first));
      for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(points.count); ++k) {
        points.x[k] = static_cast<float>(ground.x(first + k) - terrain.center.x);
        points.z[k] = static_cast<float>(ground.z(j) - terrain.center.y);
        points.spacing[k] =
            std::max(spacing(x, first + k, ground.columns()), spacing(z, j, ground.rows()));
      }
      field.water_levels(points, block);
      std::copy_n(block.begin(), points.count,
                  levels.begin() + static_cast<std::ptrdiff_t>(std::size_t{j} * side + first));
    }
  });
  WaterBuilder builder(
      terrain, ground, [&](std::uint32_t vertex) { return levels[vertex]; }, 1.0f);
  builder.add_cells(0.0f);
  return builder.take();
}

}  // namespace aerostat::terrain

#include "scatter/height_tiles.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace aerostat::scatter {
namespace {

constexpr float kNone = -1e30f;

/// The vertices whose cells a tile touches along one side. There are none if first > last.
struct Run {
  std::uint32_t first = 1, last = 0;
  /// Tells whether the whole tile lies on the ground.
  bool whole = false;
};

/// Returns the run of each tile along one side of the map. `line(i)` is the position of line i of
/// the ground's `lines` lines.
template <class Line>
std::vector<Run> runs_of(const TileMap& map, double corner, std::uint32_t lines, const Line& line) {
  std::vector<Run> runs(static_cast<std::size_t>(map.side));
  const auto at = [&line](std::uint32_t i) { return static_cast<double>(line(i)); };
  std::uint32_t first = 0;
  for (int k = 0; k < map.side; ++k) {
    const double from = corner + k * map.tile_m, to = from + map.tile_m;
    if (to < at(0) || from > at(lines - 1)) continue;
    while (first + 2 < lines && at(first + 1) <= from) ++first;
    std::uint32_t last = first + 1;
    while (last + 1 < lines && at(last) < to) ++last;
    runs[static_cast<std::size_t>(k)] = {first, last, from >= at(0) && to <= at(lines - 1)};
  }
  return runs;
}

/// Combines the values of the tiles up to `reach` tiles away with `combine(a, b)`, first along x
/// and then along z.
template <class T, class Combine>
std::vector<T> gathered(const TileMap& map, const std::vector<T>& values, int reach,
                        const Combine& combine) {
  std::vector<T> along_x(values.size()), result(values.size());
  const auto gather = [&](const std::vector<T>& from, int i, int j, int di, int dj) {
    const int middle = di != 0 ? i : j;
    const int low = std::max(-reach, -middle), high = std::min(reach, map.side - 1 - middle);
    T value = from[map.at(i + low * di, j + low * dj)];
    for (int k = low + 1; k <= high; ++k) {
      value = combine(value, from[map.at(i + k * di, j + k * dj)]);
    }
    return value;
  };
  tbb::parallel_for(0, map.side, [&](int j) {
    for (int i = 0; i < map.side; ++i) along_x[map.at(i, j)] = gather(values, i, j, 1, 0);
  });
  tbb::parallel_for(0, map.side, [&](int j) {
    for (int i = 0; i < map.side; ++i) result[map.at(i, j)] = gather(along_x, i, j, 0, 1);
  });
  return result;
}

}  // namespace

HeightTiles height_tiles(const TileMap& map, const mesh::GridMesh& ground) {
  HeightTiles tiles{std::vector<float>(map.count(), kNone), std::vector<float>(map.count(), kNone)};
  const auto columns = runs_of(map, map.corner.x, ground.columns() + 1,
                               [&](std::uint32_t i) { return ground.x(i); });
  const auto rows =
      runs_of(map, map.corner.y, ground.rows() + 1, [&](std::uint32_t j) { return ground.z(j); });
  tbb::parallel_for(0, map.side, [&](int row) {
    const Run v = rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < map.side; ++column) {
      const Run u = columns[static_cast<std::size_t>(column)];
      if (u.first > u.last || v.first > v.last) continue;
      float lowest = ground.height(u.first, v.first), highest = lowest;
      for (std::uint32_t j = v.first; j <= v.last; ++j) {
        for (std::uint32_t i = u.first; i <= u.last; ++i) {
          lowest = std::min(lowest, ground.height(i, j));
          highest = std::max(highest, ground.height(i, j));
        }
      }
      if (u.whole && v.whole) tiles.lowest[map.at(column, row)] = lowest;
      tiles.highest[map.at(column, row)] = highest;
    }
  });
  return tiles;
}

std::vector<float> least_around(const TileMap& map, const std::vector<float>& values, int reach) {
  return gathered(map, values, reach, [](float a, float b) { return std::min(a, b); });
}

std::vector<char> any_around(const TileMap& map, const std::vector<char>& flags, int reach) {
  return gathered(map, flags, reach, [](char a, char b) { return static_cast<char>(a | b); });
}

}  // namespace aerostat::scatter

#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"

namespace aerostat::scatter {

/// A square piece of the map in square tiles.
struct TileMap {
  /// The least x and z.
  dvec2 corner{0.0};
  double tile_m = 1.0;
  /// The number of tiles along x and along z.
  int side = 0;

  int column(double x) const { return whole((x - corner.x) / tile_m); }
  int row(double z) const { return whole((z - corner.y) / tile_m); }
  bool holds(int column, int row) const {
    return column >= 0 && row >= 0 && column < side && row < side;
  }
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(column);
  }
  std::size_t count() const { return at(0, side); }
  dvec2 middle(int column, int row) const {
    return corner + tile_m * dvec2(column + 0.5, row + 0.5);
  }

 private:
  // Rounds down. std::floor is not used because it is a call without SSE 4.
  static int whole(double value) {
    const int cut = static_cast<int>(value);
    return cut - (value < cut ? 1 : 0);
  }
};

/// The lowest and the highest ground of each tile. If a part of a tile has no ground, the lowest is
/// far below everything. If no part of it has ground, the highest is far below everything too.
struct HeightTiles {
  std::vector<float> lowest, highest;
};
HeightTiles height_tiles(const TileMap& map, const mesh::GridMesh& ground);

/// Returns for each tile the least value among the tiles up to `reach` tiles away in x and z.
/// `any_around` returns whether one of these tiles has a flag. There are no tiles beyond the map.
std::vector<float> least_around(const TileMap& map, const std::vector<float>& values, int reach);
std::vector<char> any_around(const TileMap& map, const std::vector<char>& flags, int reach);

}  // namespace aerostat::scatter

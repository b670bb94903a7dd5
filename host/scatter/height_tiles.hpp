#pragma once

#include <vector>

#include "mesh/grid_mesh.hpp"

namespace aerostat::scatter {

/// A square piece of the map in square tiles.
struct TileMap {
  dvec2 corner{0.0};  // least x and z
  double tile_m = 1.0;
  int side = 0;  // tiles along x and along z

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
  // Rounds down; without SSE 4 std::floor is a call.
  static int whole(double value) {
    const int cut = static_cast<int>(value);
    return cut - (value < cut ? 1 : 0);
  }
};

/// The lowest and the highest ground of each tile. Where some of the tile has no ground the lowest
/// is far below everything, where none has the highest is, too.
struct HeightTiles {
  std::vector<float> lowest, highest;
};
HeightTiles height_tiles(const TileMap& map, const mesh::GridMesh& ground);

/// The least value, and whether there is any flag, among the tiles up to `reach` tiles away in x
/// and z; beyond the map there are none.
std::vector<float> least_around(const TileMap& map, const std::vector<float>& values, int reach);
std::vector<char> any_around(const TileMap& map, const std::vector<char>& flags, int reach);

}  // namespace aerostat::scatter

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aerostat::terrain {

/// The steps to the eight neighbours of a node, of which the four nearest come first.
inline constexpr std::array<std::array<int, 2>, 8> kNeighbors = {
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Returns the direction that leads back from a neighbour.
constexpr int opposite(int direction) {
  return (direction & 4) | ((direction + 2) & 3);
}

/// The layout of a square grid's nodes in arrays with a rim of one node around them, so that
/// every node has eight neighbours. Node (0, 0) comes after a row and a node of the rim.
struct RimmedGrid {
  int nodes = 0;  // nodes along a side, without the rim
  float spacing_m = 1.0f;

  int stride() const { return nodes + 2; }
  std::size_t size() const {
    return static_cast<std::size_t>(stride()) * static_cast<std::size_t>(stride());
  }
  int at(int i, int j) const { return (j + 1) * stride() + i + 1; }

  /// Returns the difference from a node's place to that of its neighbour.
  int step(int direction) const {
    return kNeighbors[direction][1] * stride() + kNeighbors[direction][0];
  }
  /// Returns the metres between a node and its neighbour.
  float length(int direction) const { return spacing_m * (direction < 4 ? 1.0f : 1.41421356f); }
};

/// One value for each node of a rimmed grid.
template <typename T>
using Rimmed = std::vector<T>;

}  // namespace aerostat::terrain

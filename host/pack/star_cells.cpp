#include "pack/star_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace aerostat::pack {
namespace {

constexpr int kSide = AERO_STAR_SIDE;
static_assert(AERO_STAR_CELLS == 6 * AERO_STAR_SIDE * AERO_STAR_SIDE);

/// Returns the cells that a blur reaches into. They are found by points on circles around the star
/// that reach a little farther than the blur and lie closer together than a cell is wide, so that a
/// cell of which only a corner is reached is not missed.
std::vector<std::uint32_t> cells_of(const dvec3& star, double reach) {
  // The cells at the corners of the cube are the smallest.
  constexpr double kCell = 2.0 / kSide / 3.0;
  const double outer = 1.4 * reach + 1e-6;
  const int circles = static_cast<int>(std::ceil(outer / (0.5 * kCell)));
  const dvec3 other = std::abs(star.z) < 0.9 ? dvec3(0.0, 0.0, 1.0) : dvec3(1.0, 0.0, 0.0);
  const dvec3 right = glm::normalize(glm::cross(star, other)), up = glm::cross(right, star);
  std::vector<std::uint32_t> cells{star_cell(star)};
  for (int circle = 1; circle <= circles; ++circle) {
    const double radius = outer * circle / circles;
    const int points = std::max(24, static_cast<int>(8.0 * std::numbers::pi * radius / kCell));
    for (int i = 0; i < points; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / points;
      const dvec3 at = star + radius * (std::cos(turn) * right + std::sin(turn) * up);
      cells.push_back(star_cell(at));
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// Appends an array of other structs to the buffer of the sky. Returns the place of its first cell.
template <class T>
std::uint32_t append(const std::vector<T>& values, std::vector<AeroSkyCell>& sky_table) {
  const std::size_t first = sky_table.size(), bytes = values.size() * sizeof(T);
  sky_table.resize(first + (bytes + sizeof(AeroSkyCell) - 1) / sizeof(AeroSkyCell));
  if (bytes > 0) std::memcpy(sky_table.data() + first, values.data(), bytes);
  return static_cast<std::uint32_t>(first);
}

}  // namespace

std::uint32_t star_cell(const dvec3& direction) {
  const dvec3 size = glm::abs(direction);
  const bool on_x = size.x >= size.y && size.x >= size.z;
  const bool on_y = !on_x && size.y >= size.z;
  const double major = on_x ? direction.x : on_y ? direction.y : direction.z;
  const double u = on_x ? direction.y : direction.x;
  const double v = on_x || on_y ? direction.z : direction.y;
  const int face = (on_x ? 0 : on_y ? 2 : 4) + (major < 0.0 ? 1 : 0);
  const auto place = [major](double w) {
    const double at = std::floor(w / std::abs(major) * (0.5 * kSide) + 0.5 * kSide);
    return static_cast<int>(std::clamp(at, 0.0, kSide - 1.0));
  };
  return static_cast<std::uint32_t>((face * kSide + place(v)) * kSide + place(u));
}

void append_stars(const std::vector<AeroStar>& stars, double reach, AeroStars& numbers,
                  std::vector<AeroSkyCell>& sky_table) {
  std::vector<std::vector<std::uint32_t>> lists(AERO_STAR_CELLS);
  for (std::size_t i = 0; i < stars.size(); ++i) {
    const float* d = stars[i].direction;
    for (const std::uint32_t cell : cells_of({d[0], d[1], d[2]}, reach)) {
      lists[cell].push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::vector<AeroStar> sorted;
  std::vector<AeroStarStart> starts;
  for (const auto& list : lists) {
    starts.push_back({static_cast<std::uint32_t>(sorted.size())});
    for (const std::uint32_t i : list) sorted.push_back(stars[i]);
  }
  starts.push_back({static_cast<std::uint32_t>(sorted.size())});
  numbers.first = append(sorted, sky_table);
  numbers.starts = append(starts, sky_table);
}

}  // namespace aerostat::pack

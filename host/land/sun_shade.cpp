#include "land/sun_shade.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <tbb/parallel_for.h>

#include "core/smooth_step.hpp"

namespace aerostat::land {
namespace {

/// Shadows are full where land rises above the ray to the sun by as much as the ray climbs over so
/// many steps of the grid, because heights between nodes and the disc of the sun are not known
/// exactly. It was chosen by eye.
constexpr double kFadeSteps = 0.75;

}  // namespace

ReliefGrid::ReliefGrid(const LocalLand& land, const dvec2& middle_m, double side_m, int nodes,
                       double cell_m)
    : side(nodes), step_m(side_m / (nodes - 1)), middle(middle_m) {
  const auto count = static_cast<std::size_t>(side);
  height_m.resize(count * count);
  slope_east.resize(count * count);
  slope_south.resize(count * count);
  const std::vector<float> spacing(count, static_cast<float>(std::max(step_m, cell_m)));
  std::vector<float> east(count);
  for (int i = 0; i < side; ++i) {
    east[static_cast<std::size_t>(i)] =
        static_cast<float>(middle.x + (i - 0.5 * (side - 1)) * step_m);
  }
  tbb::parallel_for(0, side, [&](int j) {
    const std::vector<float> south(count,
                                   static_cast<float>(middle.y + (j - 0.5 * (side - 1)) * step_m));
    const std::size_t row = static_cast<std::size_t>(j) * count;
    land.sample({east,
                 south,
                 spacing,
                 {height_m.data() + row, count},
                 {slope_east.data() + row, count},
                 {slope_south.data() + row, count},
                 {}});
  });
  highest_m = *std::max_element(height_m.begin(), height_m.end());
}

SunShade::SunShade(const ReliefGrid& relief, double azimuth_deg, double elevation_deg)
    : side_(relief.side), step_m_(relief.step_m), middle_(relief.middle) {
  const double azimuth = glm::radians(azimuth_deg), elevation = glm::radians(elevation_deg);
  const dvec2 towards(std::sin(azimuth), -std::cos(azimuth));  // to the east and to the south
  const double rise = std::tan(elevation);
  light_.resize(relief.height_m.size());
  tbb::parallel_for(0, side_, [&](int j) {
    for (int i = 0; i < side_; ++i) {
      const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(side_) +
                             static_cast<std::size_t>(i);
      const dvec2 slope(relief.slope_east[at], relief.slope_south[at]);
      // The cosine of the sun's angle on the slope, over that on level ground.
      const double facing =
          (1.0 - glm::dot(slope, towards) / rise) / std::sqrt(1.0 + glm::dot(slope, slope));
      light_[at] =
          facing > 0.0 ? static_cast<float>(facing) * shadow(relief, i, j, towards, rise) : 0.0f;
    }
  });
}

/// Returns 1 at a node that sees the sun, and 0 in the shadow of other land.
float SunShade::shadow(const ReliefGrid& relief, int column, int row, const dvec2& towards,
                       double rise) const {
  const auto side = static_cast<std::size_t>(side_);
  const double start =
      relief.height_m[static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column)];
  // Along the longer axis, the ray goes from node to node.
  const double longer = std::max(std::abs(towards.x), std::abs(towards.y));
  const dvec2 step = towards / longer;
  const double climb = rise * step_m_ / longer;
  const double fade = std::max(kFadeSteps * climb, 1e-6);
  const bool along_rows = std::abs(towards.x) >= std::abs(towards.y);
  double clear = 0.0;
  for (int k = 1;; ++k) {
    const double u = column + k * step.x, v = row + k * step.y, ray = start + k * climb;
    if (ray > relief.highest_m || !(u >= 0.0 && v >= 0.0 && u <= side_ - 1.0 && v <= side_ - 1.0))
      break;
    const double across = along_rows ? v : u;
    const auto first = static_cast<std::size_t>(std::min(std::floor(across), side_ - 2.0));
    const auto share = static_cast<float>(across - static_cast<double>(first));
    const auto on = static_cast<std::size_t>(std::lround(along_rows ? u : v));
    const float* nodes = relief.height_m.data();
    const float a = along_rows ? nodes[first * side + on] : nodes[on * side + first];
    const float b = along_rows ? nodes[(first + 1) * side + on] : nodes[on * side + first + 1];
    clear = std::min(clear, ray - (a + share * (b - a)));
    if (clear <= -fade) return 0.0f;
  }
  return smooth_step(static_cast<float>(-fade), 0.0f, static_cast<float>(clear));
}

float SunShade::at(const dvec2& point) const {
  const dvec2 place =
      glm::clamp((point - middle_) / step_m_ + 0.5 * (side_ - 1.0), 0.0, side_ - 1.001);
  const dvec2 cell = glm::floor(place);
  const vec2 share(place - cell);
  const auto side = static_cast<std::size_t>(side_);
  const float* node =
      light_.data() + static_cast<std::size_t>(cell.y) * side + static_cast<std::size_t>(cell.x);
  return glm::mix(glm::mix(node[0], node[1], share.x),
                  glm::mix(node[side], node[side + 1], share.x), share.y);
}

}  // namespace aerostat::land

#include "scree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aerostat::terrain {
namespace {

constexpr float kNowhere = -std::numeric_limits<float>::infinity();
constexpr int kReach = 6;             // cells around a wall in which its foot is looked for
constexpr float kWallTangent = 1.0f;  // ground steeper than this loses stones

/// The least value within kReach cells along a row or a column (`step` 1 or the stride).
std::vector<float> least_along(const std::vector<float>& values, int stride, bool rows) {
  std::vector<float> least = values;
  for (int j = 0; j < stride; ++j)
    for (int d = -kReach; d <= kReach; ++d) {
      if (!rows && (j + d < 0 || j + d >= stride)) continue;
      const float* from = &values[static_cast<std::size_t>(rows ? j : j + d) * stride];
      float* to = &least[static_cast<std::size_t>(j) * stride];
      const int begin = rows ? std::max(0, -d) : 0, end = rows ? stride - std::max(0, d) : stride;
      const int shift = rows ? d : 0;
      for (int i = begin; i < end; ++i) to[i] = std::min(to[i], from[i + shift]);
    }
  return least;
}

/// Where stones come to rest against the walls: a share of the way up from the foot; nowhere else.
std::vector<float> rest_heights(const GradedHeights& ground, float share) {
  const int stride = ground.stride();
  const std::vector<float> foot =
      least_along(least_along(ground.values, stride, true), stride, false);
  std::vector<float> rest(ground.values.size(), kNowhere);
  for (int j = 1; j + 1 < stride; ++j)
    for (int i = 1; i + 1 < stride; ++i) {
      const std::size_t n = static_cast<std::size_t>(j) * stride + i;
      const float dx = (ground.values[n + 1] - ground.values[n - 1]) /
                       (ground.lines[i + 1] - ground.lines[i - 1]);
      const float dz = (ground.values[n + stride] - ground.values[n - stride]) /
                       (ground.lines[j + 1] - ground.lines[j - 1]);
      if (dx * dx + dz * dz < kWallTangent * kWallTangent) continue;
      rest[n] = foot[n] + share * (ground.values[n] - foot[n]);
    }
  return rest;
}

/// Lets the loose surface run out from the rows it has reached, one row after another: `step` is +1
/// from the first, -1 from the last.
void run_out(const std::vector<float>& lines, std::vector<float>& loose, int step) {
  const int stride = static_cast<int>(lines.size());
  for (int n = 0; n < stride; ++n) {
    const int j = step > 0 ? n : stride - 1 - n;
    float* row = &loose[static_cast<std::size_t>(j) * stride];
    if (n > 0) {
      const float* last = row - step * stride;
      const float across = std::fabs(lines[j] - lines[j - step]);
      const float drop = kScreeTangent * across;
      for (int i = 0; i < stride; ++i) row[i] = std::max(row[i], last[i] - drop);
      for (int i = 1; i < stride; ++i) {
        const float along = lines[i] - lines[i - 1];
        const float slant = kScreeTangent * std::sqrt(across * across + along * along);
        row[i] = std::max(row[i], last[i - 1] - slant);
        row[i - 1] = std::max(row[i - 1], last[i] - slant);
      }
    }
    for (int i = 1; i < stride; ++i)
      row[i] = std::max(row[i], row[i - 1] - kScreeTangent * (lines[i] - lines[i - 1]));
    for (int i = stride - 1; i > 0; --i)
      row[i - 1] = std::max(row[i - 1], row[i] - kScreeTangent * (lines[i] - lines[i - 1]));
  }
}

}  // namespace

void lay_scree(GradedHeights& ground, float share) {
  if (!(share > 0.0f) || ground.stride() < 3) return;
  std::vector<float> loose = rest_heights(ground, std::min(share, 1.0f));
  run_out(ground.lines, loose, 1);
  run_out(ground.lines, loose, -1);
  for (std::size_t i = 0; i < loose.size(); ++i)
    ground.values[i] = std::max(ground.values[i], loose[i]);
}

}  // namespace aerostat::terrain

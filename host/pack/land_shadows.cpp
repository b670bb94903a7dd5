#include "pack/land_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace aerostat::pack {
namespace {

/// Heights over the plane beyond the ground, in metres.
constexpr float kNoGround = -1e5f;
/// Shadows beyond the ground are not followed below this height.
constexpr float kSunken = -2e4f;

/// The lines of one axis of a grid, and where between them a coordinate lies.
class Lines {
 public:
  Lines(std::uint32_t count, auto line) : at_(count) {
    for (std::uint32_t i = 0; i < count; ++i) at_[i] = line(i);
  }

  float first() const { return at_.front(); }
  float last() const { return at_.back(); }
  bool has(float at) const { return at >= first() && at <= last(); }

  /// Returns the number of the cell that holds a coordinate, and where in that cell the coordinate
  /// lies, from 0 to 1.
  std::pair<std::uint32_t, float> cell_of(float at) const {
    const auto next = std::upper_bound(at_.begin() + 1, at_.end() - 1, at);
    const float from = *(next - 1);
    return {static_cast<std::uint32_t>(next - at_.begin()) - 1, (at - from) / (*next - from)};
  }

 private:
  std::vector<float> at_;
};

/// The heights of a ground between its nodes.
class Heights {
 public:
  explicit Heights(const mesh::GridMesh& ground)
      : ground_(ground),
        x_(ground.columns() + 1, [&](std::uint32_t i) { return ground.x(i); }),
        z_(ground.rows() + 1, [&](std::uint32_t j) { return ground.z(j); }) {}

  const Lines& x() const { return x_; }
  const Lines& z() const { return z_; }

  float operator()(float x, float z) const {
    if (!x_.has(x) || !z_.has(z)) return kNoGround;
    const auto [i, s] = x_.cell_of(x);
    const auto [j, t] = z_.cell_of(z);
    const float near = std::lerp(ground_.height(i, j), ground_.height(i + 1, j), s);
    const float far = std::lerp(ground_.height(i, j + 1), ground_.height(i + 1, j + 1), s);
    return std::lerp(near, far, t);
  }

 private:
  const mesh::GridMesh& ground_;
  Lines x_, z_;
};

/// Returns the place of the map that covers the ground.
AeroShadowMap place_over(const Heights& heights, const vec3& place, const SunAxes& axes) {
  vec2 least(std::numeric_limits<float>::max()), most(std::numeric_limits<float>::lowest());
  for (const float x : {heights.x().first(), heights.x().last()}) {
    for (const float z : {heights.z().first(), heights.z().last()}) {
      const vec2 at(axes.u(x + place.x, z + place.z), axes.v(x + place.x, z + place.z));
      least = glm::min(least, at);
      most = glm::max(most, at);
    }
  }
  const float side = std::max(most.x - least.x, most.y - least.y);
  return {least.x, least.y, side / static_cast<float>(kShadowSide - 1), 0.0f, 0.0f, 0};
}

/// Returns the words of heights and sets how they are scaled.
std::vector<std::uint32_t> words_of_heights(const ShadowNodes& nodes, AeroShadowMap& place) {
  float low = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
  for (const float value : nodes.values) {
    if (value > kSunken) low = std::min(low, value);
    most = std::max(most, value);
  }
  place.low = std::min(low, most);
  place.unit = std::max(most - place.low, 1.0f) / 65535.0f;
  const auto bits = [&](std::size_t column, std::size_t row) {
    const float steps = (nodes.at(column, row) - place.low) / place.unit;
    return static_cast<std::uint32_t>(std::clamp(steps + 0.5f, 0.0f, 65535.0f));
  };
  return make_words([&](std::size_t column, std::size_t row) {
    return bits(column, row) | bits(column, row + 1) << 16;
  });
}

}  // namespace

ShadowMap land_shadows(const mesh::GridMesh& ground, const vec3& place, const vec3& sun) {
  const SunAxes axes(sun);
  const Heights heights(ground);
  ShadowMap map;
  map.place = place_over(heights, place, axes);
  const float fall = map.place.cell * axes.rise;
  const ShadowNodes nodes = make_nodes([&](std::size_t row, std::span<float> values) {
    const float v = map.place.v + static_cast<float>(row) * map.place.cell;
    float hidden = kNoGround;
    for (std::size_t i = values.size(); i-- > 0;) {
      const float u = map.place.u + static_cast<float>(i) * map.place.cell;
      const float height = heights(axes.x(u, v) - place.x, axes.z(u, v) - place.z) + place.y;
      hidden = std::max(hidden - fall, height);
      values[i] = hidden;
    }
  });
  map.words = words_of_heights(nodes, map.place);
  return map;
}

}  // namespace aerostat::pack

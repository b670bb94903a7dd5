#include "asset/polygon.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/math.hpp"

namespace aerostat::asset {
namespace {

/// Twice the area of a triangle in the plane: positive if it winds counter-clockwise.
double area(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns the corners in the plane across the polygon's normal (Newell's), so that it winds
/// counter-clockwise: the axis along which the normal is longest is left out.
std::vector<dvec2> flattened(std::span<const dvec3> corners) {
  dvec3 normal(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3 here = corners[i] - corners[0];
    const dvec3 next = corners[(i + 1) % corners.size()] - corners[0];
    normal += glm::cross(here, next);
  }
  const dvec3 size = glm::abs(normal);
  const int out = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const int u = (out + 1) % 3, v = (out + 2) % 3;
  const double side = normal[out] < 0.0 ? -1.0 : 1.0;
  std::vector<dvec2> flat;
  for (const dvec3& corner : corners) {
    const dvec3 near = corner - corners[0];
    flat.emplace_back(side * near[u], near[v]);
  }
  return flat;
}

/// The most tests of corners against ears in one polygon: a tenth of a second. Outlines of
/// buildings need some thousands.
constexpr std::size_t kMostTests = 50'000'000;

/// Cuts ears off a polygon in the plane that winds counter-clockwise.
class EarClipper {
 public:
  explicit EarClipper(std::vector<dvec2> points)
      : points_(std::move(points)), left_(points_.size()) {
    std::iota(left_.begin(), left_.end(), std::uint32_t{0});
  }

  void clip(std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::size_t at = 0, misses = 0;
    while (left_.size() > 3) {
      at %= left_.size();
      // A polygon that crosses itself may have no ear. Then what is left becomes a fan.
      const bool is_searched = misses < left_.size() && tests_ < kMostTests;
      if (is_searched && !is_ear(at)) {
        ++misses;
        ++at;
        continue;
      }
      if (!is_searched) at = 1;
      triangles.push_back({before(at), left_[at], after(at)});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      if (is_searched) misses = 0;
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
  }

  bool is_convex() const {
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (!(corner_area(i) > 0.0)) return false;
    }
    return true;
  }

 private:
  std::uint32_t before(std::size_t i) const { return left_[i == 0 ? left_.size() - 1 : i - 1]; }
  std::uint32_t after(std::size_t i) const { return left_[i + 1 == left_.size() ? 0 : i + 1]; }
  double corner_area(std::size_t i) const {
    return area(points_[before(i)], points_[left_[i]], points_[after(i)]);
  }

  /// Returns whether a corner and its neighbours are a triangle that holds no other corner.
  bool is_ear(std::size_t i) {
    if (!(corner_area(i) > 0.0)) return false;
    tests_ += left_.size();
    const dvec2 &a = points_[before(i)], &b = points_[left_[i]], &c = points_[after(i)];
    return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t other) {
      const dvec2& p = points_[other];
      if (p == a || p == b || p == c) return false;
      return area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
    });
  }

  std::vector<dvec2> points_;
  std::vector<std::uint32_t> left_;  // the corners that are not cut off yet
  std::size_t tests_ = 0;            // of corners against ears
};

}  // namespace

void triangulate(std::span<const dvec3> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    triangles.push_back({0, 1, 2});
    return;
  }
  EarClipper clipper(flattened(corners));
  if (!clipper.is_convex()) return clipper.clip(triangles);
  for (std::uint32_t i = 2; i < corners.size(); ++i) triangles.push_back({0, i - 1, i});
}

}  // namespace aerostat::asset

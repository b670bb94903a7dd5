#pragma once

#include <vector>

#include "core/math.hpp"
#include "land/land.hpp"

namespace aerostat::staging {

/// Heights of real land on an even square grid around the middle of its files, for choosing a view.
/// x is metres to the east and z is metres to the south of that middle.
class ViewMap {
 public:
  /// Samples the square of side `extent_m` around `middle`.
  ViewMap(const land::Land& land, const land::LandPoint& middle, double extent_m, bool has_sea);

  int nodes() const { return nodes_; }
  double spacing_m() const { return spacing_m_; }
  double half_m() const { return 0.5 * spacing_m_ * (nodes_ - 1); }
  double at_node(int k) const { return k * spacing_m_ - half_m(); }

  /// The height above the sea, or that of the sea. Beyond the map, its rim counts.
  float height(double x, double z) const;

  /// Whether the files have a height there.
  bool is_known(double x, double z) const;

  /// The greatest known height, and where it is.
  const dvec3& summit() const { return summit_; }

 private:
  std::size_t index(double x, double z) const;

  int nodes_;
  double spacing_m_;
  std::vector<float> heights_;
  std::vector<std::uint8_t> known_;
  dvec3 summit_{0.0};
};

}  // namespace aerostat::staging

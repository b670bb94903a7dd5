#pragma once

#include <array>
#include <vector>

#include "air/cloud_deck.hpp"
#include "air/scattering.hpp"

namespace aerostat::air {

/// The sky as an eye sees it. The table holds light from every direction, in rows of equal height
/// over the horizon and columns of equal azimuth from the sun. Light that haze scatters once is
/// kept apart, without its phase function, so that the table is smooth at the sun.
class SkyTable {
 public:
  static constexpr int kColumns = 24;    // u = sin(azimuth from the sun / 2), 0 to 1
  static constexpr int kRowsAbove = 40;  // s = v^2 (1 + horizon_sine), s = y + horizon_sine
  static constexpr int kRowsBelow = 16;  // s = -v^2 (1 - horizon_sine)

  struct Cell {
    dvec3 add{0.0};
    dvec3 haze{0.0};
  };

  /// Computes the sky for an eye at `height`. Directions below the horizon see the ground of the
  /// planet, lit by sun and sky.
  SkyTable(const Scattering& air, double height);

  /// Returns the sine of the angle by which the horizon lies below level.
  double horizon_sine() const { return horizon_sine_; }
  /// Returns the cells: the rows from the horizon up, then the rows from the horizon down.
  const std::vector<Cell>& cells() const { return cells_; }
  /// Returns the radiance of a unit direction, without the sun's disc.
  dvec3 radiance(const dvec3& direction) const;
  /// Returns the irradiance of level ground by the sky.
  const dvec3& irradiance_from_above() const { return from_above_; }

 private:
  dvec3 direction_of(double sine, int column) const;
  double sine_of(int row) const;
  void fill(const Scattering& air, int first_row, int end_row, const dvec3& ground);
  dvec3 irradiance() const;

  double height_ = 0.0, horizon_sine_ = 0.0, asymmetry_ = 0.0;
  dvec3 sun_, level_sun_;
  std::vector<Cell> cells_;
  dvec3 from_above_{0.0};
};

/// Returns the coefficients of the irradiance / pi, by sky and ground, of a plane with the normal
/// (x, y, z):
///   c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3 zz - 1) + c7 xz + c8 (xx - yy)
/// Source: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for Irradiance
/// Environment Maps" (SIGGRAPH 2001).
std::array<dvec3, 9> ambient_light(const SkyTable& sky);

/// Returns the same for land or an eye at a height among clouds. Below the clouds, their bases hide
/// parts of the sky and are lit through the clouds, and the ground has only the light that the
/// clouds leave. From above, their tops hide parts of the ground. `level_light` is the irradiance
/// of level ground without clouds.
std::array<dvec3, 9> ambient_light(const SkyTable& sky, const CloudDeck& deck, double height,
                                   const dvec3& level_light, const dvec3& ground_albedo);

}  // namespace aerostat::air

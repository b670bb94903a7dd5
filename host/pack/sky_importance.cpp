#include "pack/sky_importance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math.hpp"

namespace aerostat::pack {
namespace {

constexpr int kStrips = AERO_SKY_STRIPS, kAbove = AERO_SKY_STRIPS_ABOVE;
constexpr int kColumns = AERO_SKY_COLUMNS - 1;
static_assert(kAbove == AERO_SKY_ROWS_ABOVE - 1);
static_assert(kStrips == kAbove + AERO_SKY_ROWS_BELOW - 1);
static_assert(kStrips < AERO_SKY_STRIP_SLOTS && kColumns < AERO_SKY_COLUMN_SLOTS);

/// The light of a cell is the mean of this many points along each of its sides.
constexpr int kPoints = 4;
/// The share of choices that are even all over the sky, the factor for directions below the
/// horizon, and the share that is even if there are heaped clouds. Chosen by eye.
constexpr double kEven = 0.1, kBelow = 0.1, kEvenWithClouds = 0.4;

/// The unevenness (unevenness_of) from which rays to the sky save more noise than time. It lies
/// between the scenes where they do and do not (docs/decisions/0032-paths.md).
constexpr double kUneven = 2.0;

/// A place in the table: a strip and the shares of the way to the next row and column.
struct TablePoint {
  int strip, column;
  double down, across;
};

int first_row(int strip) {
  return strip < kAbove ? strip : strip + 1;
}

/// Returns the upward component of directions in a strip.
double height_in(double horizon, int strip, double share) {
  if (strip < kAbove) {
    const double v = (strip + share) / kAbove;
    return v * v * (1.0 + horizon) - horizon;
  }
  const double v = (strip - kAbove + share) / (kStrips - kAbove);
  return -v * v * (1.0 - horizon) - horizon;
}

double turns_of(double column) {
  return 2.0 * std::asin(std::min(column / kColumns, 1.0)) / (2.0 * std::numbers::pi);
}

/// The sky as its table holds it.
class Sky {
 public:
  Sky(const AeroScene& numbers, std::span<const AeroSkyCell> table)
      : numbers_(numbers), table_(table) {}

  double horizon() const { return static_cast<double>(numbers_.air.horizon_sine); }

  /// Returns the luminance of the sky at a point of the table.
  double luminance(const TablePoint& point) const {
    const std::size_t first =
        static_cast<std::size_t>(first_row(point.strip) * AERO_SKY_COLUMNS + point.column);
    const double phase = haze_phase(cosine_with_sun(point));
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) {
      const auto at = [&](std::size_t cell) {
        const AeroSkyCell& value = table_[cell];
        return static_cast<double>(value.add[c]) + phase * static_cast<double>(value.haze[c]);
      };
      const double near = std::lerp(at(first), at(first + 1), point.across);
      const double far =
          std::lerp(at(first + AERO_SKY_COLUMNS), at(first + AERO_SKY_COLUMNS + 1), point.across);
      sum += kRec709[c] * static_cast<double>(numbers_.sky.sun_irradiance[c]) *
             std::lerp(near, far, point.down);
    }
    return std::max(sum, 0.0);
  }

 private:
  static constexpr std::array<double, 3> kRec709{0.2126, 0.7152, 0.0722};

  double cosine_with_sun(const TablePoint& point) const {
    const auto* sun = numbers_.sky.sun_direction;
    const double level_sun = std::hypot(static_cast<double>(sun[0]), static_cast<double>(sun[2]));
    const double y = std::clamp(height_in(horizon(), point.strip, point.down), -1.0, 1.0);
    const double half = (point.column + point.across) / kColumns;
    return std::sqrt(1.0 - y * y) * level_sun * (1.0 - 2.0 * half * half) +
           y * static_cast<double>(sun[1]);
  }

  /// Returns the phase function of haze in the kernels (atmosphere/air.clh).
  double haze_phase(double cosine) const {
    const double g = static_cast<double>(numbers_.air.haze_asymmetry);
    const double scale = 0.119366207 * (1.0 - g * g) / (2.0 + g * g);
    return scale * (1.0 + cosine * cosine) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
  }

  const AeroScene& numbers_;
  std::span<const AeroSkyCell> table_;
};

/// Returns the mean luminance of a cell.
double light_of(const Sky& sky, int strip, int column) {
  double sum = 0.0;
  for (int i = 0; i < kPoints * kPoints; ++i) {
    sum += sky.luminance(
        {strip, column, (i / kPoints + 0.5) / kPoints, (i % kPoints + 0.5) / kPoints});
  }
  return sum / (kPoints * kPoints);
}

using Grid = std::array<std::array<double, kColumns>, kStrips>;

/// Returns the steradians of each cell. It counts the cells on both sides of the sun.
Grid sizes_of(double horizon) {
  Grid sizes{};
  for (int strip = 0; strip < kStrips; ++strip) {
    const double height = std::abs(height_in(horizon, strip, 1.0) - height_in(horizon, strip, 0.0));
    for (int column = 0; column < kColumns; ++column) {
      const double turns = turns_of(column + 1) - turns_of(column);
      sizes[static_cast<std::size_t>(strip)][static_cast<std::size_t>(column)] =
          2.0 * height * turns * 2.0 * std::numbers::pi;
    }
  }
  return sizes;
}

/// Makes the sum over a row of probabilities 1, and returns what it was.
template <typename Row>
double make_whole(Row& row) {
  double sum = 0.0;
  for (const double probability : row) sum += probability;
  for (double& probability : row) probability /= sum;
  return sum;
}

/// Writes the sums of all probabilities before each one. All slots behind them become 1.
template <typename Row, std::size_t kSlots>
void write_sums(const Row& probabilities, float (&slots)[kSlots]) {
  std::fill(std::begin(slots), std::end(slots), 1.0f);
  double sum = 0.0;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    slots[i] = static_cast<float>(std::min(sum, 1.0));
    sum += probabilities[i];
  }
}

/// Returns the probabilities of all cells. Their sum is 1.
Grid probabilities_of(const Sky& sky, const Grid& sizes, double even) {
  Grid probabilities{};
  double light = 0.0;
  for (std::size_t i = 0; i < kStrips; ++i) {
    for (std::size_t j = 0; j < kColumns; ++j) {
      const double shown = static_cast<int>(i) < kAbove ? 1.0 : kBelow;
      probabilities[i][j] =
          shown * light_of(sky, static_cast<int>(i), static_cast<int>(j)) * sizes[i][j];
      light += probabilities[i][j];
    }
  }
  const double part = light > 0.0 ? even : 1.0;
  const double scale = light > 0.0 ? (1.0 - part) / light : 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < kStrips; ++i) {
    for (std::size_t j = 0; j < kColumns; ++j) {
      const double shown = static_cast<int>(i) < kAbove ? 1.0 : kBelow;
      probabilities[i][j] =
          scale * probabilities[i][j] + part * shown * sizes[i][j] / (4.0 * std::numbers::pi);
      whole += probabilities[i][j];
    }
  }
  for (auto& row : probabilities) {
    for (double& probability : row) probability /= whole;
  }
  return probabilities;
}

/// Returns the variance of the sky's light over directions that are chosen by the cosine with the
/// upright, divided by the square of its mean. It tells how noisy the light on level ground is
/// without rays to the sky.
double unevenness_of(const Sky& sky, const Grid& sizes) {
  double weights = 0.0, sum = 0.0, squares = 0.0;
  for (int strip = 0; strip < kAbove; ++strip) {
    const double cosine = std::max(height_in(sky.horizon(), strip, 0.5), 0.0);
    for (int column = 0; column < kColumns; ++column) {
      const double weight =
          cosine * sizes[static_cast<std::size_t>(strip)][static_cast<std::size_t>(column)];
      const double light = light_of(sky, strip, column);
      weights += weight;
      sum += weight * light;
      squares += weight * light * light;
    }
  }
  return sum > 0.0 ? squares * weights / (sum * sum) - 1.0 : 0.0;
}

}  // namespace

AeroSkyImportance sky_importance(const AeroScene& numbers, std::span<const AeroSkyCell> table) {
  const Sky sky(numbers, table);
  const Grid sizes = sizes_of(sky.horizon());
  const double even = numbers.sky.cumulus.extinction > 0.0f ? kEvenWithClouds : kEven;
  Grid probabilities = probabilities_of(sky, sizes, even);
  AeroSkyImportance packed{};
  std::array<double, kStrips> strips{};
  for (std::size_t i = 0; i < kStrips; ++i) {
    const auto row = static_cast<std::size_t>(first_row(static_cast<int>(i)));
    for (std::size_t j = 0; j < kColumns; ++j) {
      packed.densities[row * AERO_SKY_COLUMNS + j] =
          static_cast<float>(probabilities[i][j] / sizes[i][j]);
    }
    strips[i] = make_whole(probabilities[i]);
    write_sums(probabilities[i], packed.cells[i]);
    packed.ends[i][0] = static_cast<float>(height_in(sky.horizon(), static_cast<int>(i), 0.0));
    packed.ends[i][1] = static_cast<float>(height_in(sky.horizon(), static_cast<int>(i), 1.0));
  }
  write_sums(strips, packed.strips);
  for (int column = 0; column <= kColumns; ++column) {
    packed.turns[column] = static_cast<float>(turns_of(column));
  }
  packed.sought = unevenness_of(sky, sizes) > kUneven ? 1u : 0u;
  return packed;
}

}  // namespace aerostat::pack

#include "air/sky.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/smooth_step.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;
constexpr int kSteps = 40;
constexpr int kRows = SkyTable::kRowsAbove + SkyTable::kRowsBelow;
// The directions over which light is summed. They lie in rings of equal area.
constexpr int kRings = 64, kSectors = 64;

dvec3 ring_direction(int ring, int sector, double lowest, double highest) {
  const double y = std::lerp(lowest, highest, (ring + 0.5) / kRings);
  const double level = std::sqrt(1.0 - y * y);
  const double azimuth = 2.0 * kPi64 * (sector + 0.5) / kSectors;
  return {level * std::cos(azimuth), y, level * std::sin(azimuth)};
}

dvec3 level_part(const dvec3& direction) {
  const double length = std::hypot(direction.x, direction.z);
  return length < 1e-9 ? dvec3(1.0, 0.0, 0.0) : dvec3(direction.x, 0.0, direction.z) / length;
}

/// Returns the nine functions of ambient_light in a direction.
std::array<double, 9> basis(const dvec3& d) {
  return {1.0,
          d.y,
          d.z,
          d.x,
          d.x * d.y,
          d.y * d.z,
          3.0 * d.z * d.z - 1.0,
          d.x * d.z,
          d.x * d.x - d.y * d.y};
}

/// Returns the light of the night itself: airglow and stars. It is 22 magnitudes per square
/// arcsecond or 1.7e-4 cd/m^2 (A. Crumey, "Human contrast threshold and astronomical visibility",
/// MNRAS 442, 2014), divided by the sun's 133.1 klx. It is grey, although starlight is a little
/// warm. It is left out by day, and thinner air glows less.
dvec3 night_light(const Atmosphere& air, double sun_sine) {
  constexpr double kNight = 1.7e-4 / 133100.0;
  const double dark = smooth_step(0.0, std::sin(6.0 * kPi64 / 180.0), -sun_sine);
  const double density = air.molecules.y * air.molecules_height / rayleigh_depth(kWavelengths_um.y);
  return dvec3(kNight * dark * std::min(density, 1.0));
}

/// Returns the coefficients of ambient_light for light with the given radiance in each direction.
template <class Radiance>
std::array<dvec3, 9> harmonics(const Radiance& radiance) {
  // Each weight is the square of a harmonic's factor times the share of its degree in the cosine
  // lobe (1, 2/3 or 1/4).
  constexpr double k0 = 1.0 / (4.0 * kPi64), k1 = 3.0 / (4.0 * kPi64) * (2.0 / 3.0);
  constexpr double k2 = 15.0 / (4.0 * kPi64) * 0.25, k20 = 5.0 / (16.0 * kPi64) * 0.25;
  constexpr double k22 = 15.0 / (16.0 * kPi64) * 0.25;
  constexpr std::array<double, 9> weight = {k0, k1, k1, k1, k2, k2, k20, k2, k22};
  std::array<dvec3, 9> sums{};
  for (int i = 0; i < kRings * kSectors; ++i) {
    const dvec3 d = ring_direction(i / kSectors, i % kSectors, -1.0, 1.0);
    const dvec3 light = radiance(d);
    const auto functions = basis(d);
    for (std::size_t k = 0; k < 9; ++k) sums[k] += light * (functions[k] * weight[k]);
  }
  for (dvec3& sum : sums) sum *= 4.0 * kPi64 / (kRings * kSectors);
  return sums;
}

}  // namespace

SkyTable::SkyTable(const Scattering& air, double height)
    : height_(std::clamp(height, 1.0, 0.5 * kTopHeight)),
      horizon_sine_(std::sqrt(height_ * (2.0 * kGroundRadius + height_)) /
                    (kGroundRadius + height_)),
      asymmetry_(air.atmosphere().haze_asymmetry),
      sun_(air.sun()),
      level_sun_(level_part(air.sun())),
      cells_(static_cast<std::size_t>(kRows * kColumns)) {
  fill(air, 0, kRowsAbove, dvec3(0.0));
  from_above_ = irradiance();
  const dvec3 sunlight = air.sunlight(0.0, sun_.y) * std::max(sun_.y, 0.0);
  fill(air, kRowsAbove, kRows, air.atmosphere().ground_albedo / kPi64 * (sunlight + from_above_));
}

double SkyTable::sine_of(int row) const {
  if (row < kRowsAbove) {
    // The lowest row grazes the ground. The lower bound keeps rounding from making it meet the
    // ground.
    const double v = std::max(static_cast<double>(row), 1e-3) / (kRowsAbove - 1);
    return v * v * (1.0 + horizon_sine_) - horizon_sine_;
  }
  const double v = std::max(row - kRowsAbove, 0) + (row == kRowsAbove ? 1e-3 : 0.0);
  const double share = v / (kRowsBelow - 1);
  return -share * share * (1.0 - horizon_sine_) - horizon_sine_;
}

dvec3 SkyTable::direction_of(double sine, int column) const {
  const double y = std::clamp(sine, -1.0, 1.0);
  const double level = std::sqrt(1.0 - y * y);
  const double half = static_cast<double>(column) / (kColumns - 1);
  const double cosine = 1.0 - 2.0 * half * half;
  const double across = 2.0 * half * std::sqrt(std::max(0.0, 1.0 - half * half));
  return {level * (cosine * level_sun_.x - across * level_sun_.z), y,
          level * (cosine * level_sun_.z + across * level_sun_.x)};
}

void SkyTable::fill(const Scattering& air, int first_row, int end_row, const dvec3& ground) {
  const dvec3 night = first_row == 0 ? night_light(air.atmosphere(), sun_.y) : dvec3(0.0);
  tbb::parallel_for(first_row * kColumns, end_row * kColumns, [&](int i) {
    Way way{height_, direction_of(sine_of(i / kColumns), i % kColumns), 0.0};
    const double end = i / kColumns < kRowsAbove ? kTopHeight : 0.0;
    way.length = distance_to_height(height_, way.direction.y, end);
    const PathLight light = air.follow(way, kSteps);
    cells_[static_cast<std::size_t>(i)] = {light.add + light.transmittance * ground + night,
                                           light.haze};
  });
}

dvec3 SkyTable::radiance(const dvec3& direction) const {
  const double above = direction.y + horizon_sine_;
  const bool up = above >= 0.0;
  const int rows = up ? kRowsAbove : kRowsBelow;
  const double v =
      up ? std::sqrt(above / (1.0 + horizon_sine_)) : std::sqrt(-above / (1.0 - horizon_sine_));
  const double row = std::min(v, 1.0) * (rows - 1);
  const double across = glm::dot(level_part(direction), level_sun_);
  const double column = std::sqrt(std::clamp(0.5 - 0.5 * across, 0.0, 1.0)) * (kColumns - 1);
  const int i = std::min(static_cast<int>(row), rows - 2);
  const int j = std::min(static_cast<int>(column), kColumns - 2);
  const Cell* low = cells_.data() + ((up ? 0 : kRowsAbove) + i) * kColumns + j;
  const Cell* high = low + kColumns;
  const double phase = haze_phase(glm::dot(direction, sun_), asymmetry_);
  const auto value = [phase](const Cell& cell) { return cell.add + phase * cell.haze; };
  return glm::mix(glm::mix(value(low[0]), value(low[1]), column - j),
                  glm::mix(value(high[0]), value(high[1]), column - j), row - i);
}

dvec3 SkyTable::irradiance() const {
  dvec3 sum(0.0);
  for (int i = 0; i < kRings * kSectors; ++i) {
    const dvec3 d = ring_direction(i / kSectors, i % kSectors, 0.0, 1.0);
    sum += radiance(d) * d.y;
  }
  return sum * (2.0 * kPi64 / (kRings * kSectors));
}

std::array<dvec3, 9> ambient_light(const SkyTable& sky) {
  return harmonics([&sky](const dvec3& d) { return sky.radiance(d); });
}

std::array<dvec3, 9> ambient_light(const SkyTable& sky, const CloudDeck& deck, double height,
                                   const dvec3& level_light, const dvec3& ground_albedo) {
  if (deck.cover <= 0.0) return ambient_light(sky);
  const double through = deck.transmittance();
  const dvec3 below = deck.light_below(ground_albedo);
  const dvec3 risen = ground_albedo * below * level_light;  // from the ground up to the clouds
  const dvec3 bases = (through * level_light + (1.0 - through) * risen) / kPi64;
  const dvec3 tops = ((1.0 - through) * level_light + through * risen) / kPi64;
  const double above = smooth_step(deck.base, deck.top, height);
  return harmonics([&](const dvec3& d) {
    const dvec3 clear = sky.radiance(d);
    const double hidden = deck.hidden(std::abs(d.y));
    if (d.y >= 0.0) return glm::mix(clear, bases, (1.0 - above) * hidden);
    return glm::mix(below * clear, tops, above * hidden);
  });
}

}  // namespace aerostat::air

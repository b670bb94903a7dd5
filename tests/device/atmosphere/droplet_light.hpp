#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/math.hpp"

/// Follows light through homogeneous clouds by brute force (Monte Carlo), as a reference for the
/// closed form of the kernels. Lengths are in mean free paths, and droplets absorb nothing.
namespace aerostat::test {

/// The mix of a peak and a wide lobe by which droplets scatter (J. Jendersie and E. d'Eon, "An
/// Approximate Mie Scattering Function for Fog and Cloud Rendering", SIGGRAPH 2023 Talks). The
/// parameters are worked out from the diameter in micrometres, 5 to 50.
class Droplets {
 public:
  explicit Droplets(double diameter)
      : peak_(std::exp(-0.0990567 / (diameter - 1.67154))),
        wide_(std::exp(-2.20679 / (diameter + 3.91029) - 0.428934)),
        alpha_(std::exp(3.62489 - 8.29288 / (diameter + 5.52825))),
        wide_share_(std::exp(-0.599085 / (diameter - 0.641583) - 0.665888)) {
    double sum = 0.0;
    for (int i = 0; i < kBins; ++i) {
      below_[static_cast<std::size_t>(i)] = sum;
      sum += wide_phase(cosine_of(i + 0.5));
    }
    for (double& below : below_) below /= sum;
  }

  /// Returns the share of scattered light per steradian.
  double phase(double cosine) const {
    return (1.0 - wide_share_) * henyey(cosine, peak_) + wide_share_ * wide_phase(cosine);
  }

  /// Returns the cosine of the angle of a scattering for three random numbers, 0 to 1.
  double sampled_cosine(double choice, double u) const {
    if (choice < wide_share_) {
      const auto next = std::upper_bound(below_.begin(), below_.end(), u);
      const auto bin = static_cast<int>(next - below_.begin()) - 1;
      const double low = below_[static_cast<std::size_t>(bin)];
      const double high = bin + 1 < kBins ? below_[static_cast<std::size_t>(bin + 1)] : 1.0;
      return cosine_of(bin + (u - low) / (high - low));
    }
    const double g = peak_, s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
    return std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
  }

 private:
  static constexpr int kBins = 4096;

  static double cosine_of(double bin) { return 2.0 * bin / kBins - 1.0; }
  static double henyey(double cosine, double g) {
    const double spread = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * std::numbers::pi * spread * std::sqrt(spread));
  }
  /// Draine's phase function (2003), which is one of Henyey and Greenstein for alpha = 0.
  double wide_phase(double cosine) const {
    return henyey(cosine, wide_) * (1.0 + alpha_ * cosine * cosine) /
           (1.0 + alpha_ * (1.0 + 2.0 * wide_ * wide_) / 3.0);
  }

  double peak_, wide_, alpha_, wide_share_;
  std::array<double, kBins> below_{};
};

/// A homogeneous cloud: a sphere about the origin, or a slab between y = 0 and y = -size that has
/// no sides.
struct HomogeneousCloud {
  bool sphere = false;
  double size = 1.0;  // radius of the sphere, or thickness of the slab

  /// Returns the way inside the cloud from a point of it along a direction.
  double way_out(const dvec3& p, const dvec3& d) const {
    if (sphere) {
      const double b = glm::dot(p, d);
      return std::max(-b + std::sqrt(std::max(b * b - glm::dot(p, p) + size * size, 0.0)), 0.0);
    }
    if (std::abs(d.y) < 1e-9) return 1e9;
    return std::max(d.y > 0.0 ? -p.y / d.y : (-size - p.y) / d.y, 0.0);
  }
};

inline std::array<dvec3, 2> axes_across(const dvec3& d) {
  const dvec3 other = std::abs(d.y) < 0.9 ? dvec3(0.0, 1.0, 0.0) : dvec3(1.0, 0.0, 0.0);
  const dvec3 first = glm::normalize(glm::cross(d, other));
  return {first, glm::cross(d, first)};
}

/// The light that leaves a cloud after one scattering or more, by direction. Directions are parted
/// by a cosine into equal rings: for a sphere the cosine with the light's own direction, and for a
/// slab the one with the upright.
constexpr int kRings = 12;
using RingLight = std::array<double, kRings>;

/// Returns the radiance of a cloud that is seen from within each ring, per irradiance of the sun on
/// a plane that faces it. For a sphere, it is the mean over the disc that the eye sees.
inline RingLight scattered_light(const HomogeneousCloud& cloud, const Droplets& droplets,
                                 const dvec3& to_sun, int photons, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  RingLight light{};
  const auto across = axes_across(to_sun);
  for (int i = 0; i < photons; ++i) {
    dvec3 p(0.0), d = -to_sun;
    if (cloud.sphere) {
      const double r = std::sqrt(unit(random)), turn = 2.0 * std::numbers::pi * unit(random);
      p = cloud.size * (r * std::cos(turn) * across[0] + r * std::sin(turn) * across[1] +
                        std::sqrt(1.0 - r * r) * to_sun);
    }
    for (int k = 0;; ++k) {
      const double way = -std::log(1.0 - unit(random));
      if (way > cloud.way_out(p, d)) {
        const double cosine = cloud.sphere ? -glm::dot(d, to_sun) : d.y;
        const int ring = std::clamp(static_cast<int>(0.5 * (1.0 + cosine) * kRings), 0, kRings - 1);
        if (k > 0) light[static_cast<std::size_t>(ring)] += 1.0 / photons;
        break;
      }
      p += way * d;
      const double cosine = droplets.sampled_cosine(unit(random), unit(random));
      const double turn = 2.0 * std::numbers::pi * unit(random);
      const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
      const auto sides = axes_across(d);
      d = glm::normalize(cosine * d +
                         sine * (std::cos(turn) * sides[0] + std::sin(turn) * sides[1]));
    }
  }
  for (int ring = 0; ring < kRings; ++ring) {
    const double cosine = 2.0 * (ring + 0.5) / kRings - 1.0,
                 angle = 4.0 * std::numbers::pi / kRings;
    // The slab gets the cosine of the sun, and an eye sees it over the area that the cosine says.
    light[static_cast<std::size_t>(ring)] *=
        cloud.sphere ? 1.0 / angle : to_sun.y / (angle * std::abs(cosine));
  }
  return light;
}

}  // namespace aerostat::test

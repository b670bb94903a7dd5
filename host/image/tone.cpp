#include "image/tone.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace aerostat::image {

namespace {

constexpr double kContrast = 1.55;
constexpr double kShoulder = 0.98;
constexpr double kMidIn = 0.18;
constexpr double kMidOut = 0.19;

struct Curve {
  double b;
  double c;
};

// Solves two linear equations for the curve through (kMidIn, kMidOut) and (kWhitePoint, 1).
Curve solve() {
  const double mid = std::pow(kMidIn, kContrast);
  const double mid_shoulder = std::pow(kMidIn, kContrast * kShoulder);
  const double white = std::pow(kWhitePoint, kContrast);
  const double white_shoulder = std::pow(kWhitePoint, kContrast * kShoulder);
  const double b = (white - mid / kMidOut) / (white_shoulder - mid_shoulder);
  return {b, white - b * white_shoulder};
}

// Returns the value, 0 to 63, at column x and row y of the 8x8 Bayer matrix. The bits of x ^ y
// and y are interleaved.
constexpr unsigned bayer(unsigned x, unsigned y) {
  const unsigned mixed = x ^ y;
  unsigned rank = 0;
  for (unsigned bit = 0; bit < 3; ++bit) {
    rank = (rank << 2) | (((mixed >> bit) & 1u) << 1) | ((y >> bit) & 1u);
  }
  return rank;
}

constexpr std::array<double, 64> bayer_thresholds() {
  std::array<double, 64> thresholds{};
  for (unsigned i = 0; i < 64; ++i) thresholds[i] = (bayer(i % 8, i / 8) + 0.5) / 64.0;
  return thresholds;
}

}  // namespace

double tone_curve(double x) {
  static const Curve curve = solve();
  if (!(x > 0.0)) return 0.0;
  if (x >= kWhitePoint) return 1.0;
  const double rise = std::pow(x, kContrast);
  return rise / (curve.b * std::pow(rise, kShoulder) + curve.c);
}

dvec3 tone_map(const dvec3& exposed) {
  const auto positive = [](double v) { return v > 0.0 ? v : 0.0; };
  const dvec3 color{positive(exposed.x), positive(exposed.y), positive(exposed.z)};
  const double peak = std::max({color.x, color.y, color.z});
  if (peak == 0.0) return dvec3{0.0};
  // Colours with an infinite component become white, because the ratios of their components would
  // be NaN.
  if (!std::isfinite(peak)) return dvec3{1.0};
  const double display = tone_curve(peak);
  // The share of white is the display value to the eighth power, so that only bright highlights
  // lose their colour. Chosen by eye.
  const double fourth = display * display * display * display, white = fourth * fourth;
  return display * (color / peak * (1.0 - white) + white);
}

double srgb_from_linear(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

double linear_from_srgb(double encoded) {
  const double y = std::clamp(encoded, 0.0, 1.0);
  return y <= 0.04045 ? y / 12.92 : std::pow((y + 0.055) / 1.055, 2.4);
}

double dither_threshold(int x, int y) {
  static constexpr auto kThresholds = bayer_thresholds();
  return kThresholds[(static_cast<unsigned>(y) & 7u) * 8u + (static_cast<unsigned>(x) & 7u)];
}

std::uint8_t quantise(double encoded, int x, int y) {
  return static_cast<std::uint8_t>(std::clamp(encoded, 0.0, 1.0) * 255.0 + dither_threshold(x, y));
}

}  // namespace aerostat::image

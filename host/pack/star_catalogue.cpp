#include "pack/star_catalogue.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>

#include "air/atmosphere.hpp"

namespace aerostat::pack {
namespace {

constexpr std::string_view kCatalogue =
#include "pack/stars.inc"
    ;
constexpr std::size_t kStarLength = 8;
static_assert(kCatalogue.size() % kStarLength == 0);

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Reads a star: 48 bits in base 64, the highest first. 16 are the right ascension in 65536ths of a
/// turn, 16 the declination in 65535ths of 180 degrees from the south pole, 8 the magnitude in
/// 255ths of 8 from -2, and 8 the B-V in 255ths of 4 from -0.4.
Star star_of(std::string_view text) {
  std::uint64_t bits = 0;
  for (const char digit : text) bits = bits << 6 | kDigits.find(digit);
  const auto part = [bits](int shift, std::uint64_t mask) {
    return static_cast<double>(bits >> shift & mask);
  };
  const double ascension = part(32, 0xffff) / 65536.0 * 2.0 * std::numbers::pi;
  const double declination = (part(16, 0xffff) / 65535.0 - 0.5) * std::numbers::pi;
  const double level = std::cos(declination);
  return {{level * std::cos(ascension), level * std::sin(ascension), std::sin(declination)},
          part(8, 0xff) / 255.0 * 8.0 - 2.0,
          part(0, 0xff) / 255.0 * 4.0 - 0.4};
}

/// Returns the light of a black body by Planck's law, in any unit.
double planck(double wavelength_um, double kelvin) {
  constexpr double kSecond = 14387.77;  // second radiation constant, um K
  return 1.0 / (std::pow(wavelength_um, 5.0) * std::expm1(kSecond / (wavelength_um * kelvin)));
}

}  // namespace

const std::vector<Star>& star_catalogue() {
  static const std::vector<Star> stars = [] {
    std::vector<Star> read;
    for (std::size_t i = 0; i < kCatalogue.size(); i += kStarLength) {
      read.push_back(star_of(kCatalogue.substr(i, kStarLength)));
    }
    return read;
  }();
  return stars;
}

dvec3 star_hue(double color_index) {
  constexpr double kSunKelvin = 5800.0;
  const double index = 0.92 * color_index;
  const double kelvin = 4600.0 * (1.0 / (index + 1.7) + 1.0 / (index + 0.62));
  dvec3 hue(0.0);
  for (int i = 0; i < 3; ++i) {
    hue[i] = planck(air::kWavelengths_um[i], kelvin) / planck(air::kWavelengths_um[i], kSunKelvin);
  }
  return hue / glm::dot(hue, dvec3(0.2126, 0.7152, 0.0722));
}

}  // namespace aerostat::pack

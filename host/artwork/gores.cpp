#include "artwork/gores.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace aerostat::artwork {
namespace {

/// Writes the colour between two neighbouring pixels of a row. `x` counts pixels from the left
/// edge. Colours count in proportion to their opacity.
void mix_pixels(const std::uint8_t* row, std::uint32_t width, double x, std::uint8_t* out) {
  const double at = std::clamp(x - 0.5, 0.0, static_cast<double>(width - 1));
  const auto first = static_cast<std::uint32_t>(at);
  const std::uint32_t second = std::min(first + 1, width - 1);
  const double share = at - first;
  const std::uint8_t *a = row + std::size_t{4} * first, *b = row + std::size_t{4} * second;
  const double opacity_a = (1.0 - share) * a[3], opacity_b = share * b[3];
  const double opacity = opacity_a + opacity_b;
  for (int c = 0; c < 3; ++c) {
    const double color = opacity > 0.0 ? (opacity_a * a[c] + opacity_b * b[c]) / opacity : a[c];
    out[c] = static_cast<std::uint8_t>(std::lround(color));
  }
  out[3] = static_cast<std::uint8_t>(std::lround(opacity));
}

}  // namespace

asset::Texture straightened(const asset::Texture& drawn, const Unrolled& cloth) {
  asset::Texture result{drawn.name, drawn.width, drawn.height, {}};
  result.rgba.resize(drawn.rgba.size());
  const double strip = static_cast<double>(drawn.width) / cloth.gores();
  for (std::uint32_t y = 0; y < drawn.height; ++y) {
    const double height = (1.0 - (y + 0.5) / drawn.height) * cloth.height();
    const double width = strip * cloth.gore_width(height) / cloth.widest_gore();
    // Half a pixel at the edges of a gore is mixed with what lies between the gores.
    const double half = std::max(0.5 * width - 0.5, 0.0);
    const std::uint8_t* const row = &drawn.rgba[std::size_t{4} * y * drawn.width];
    std::uint8_t* out = &result.rgba[std::size_t{4} * y * drawn.width];
    for (std::uint32_t x = 0; x < drawn.width; ++x, out += 4) {
      const double middle = (std::floor((x + 0.5) / strip) + 0.5) * strip;
      const double from_middle = (x + 0.5 - middle) / strip * width;
      mix_pixels(row, drawn.width, middle + std::clamp(from_middle, -half, half), out);
    }
  }
  return result;
}

}  // namespace aerostat::artwork

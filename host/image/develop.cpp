#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "image/tone.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

void develop_row(const Film& film, double gain, int y, Pixels& pixels) {
  const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width);
  for (int x = 0; x < film.width; ++x) {
    const std::size_t index = first + static_cast<std::size_t>(x);
    const dvec3 display = tone_map(dvec3(film.radiance[index]) * gain);
    for (int channel = 0; channel < 3; ++channel) {
      pixels.rgb[3 * index + static_cast<std::size_t>(channel)] =
          quantise(srgb_from_linear(display[channel]), x, y);
    }
  }
}

}  // namespace

Pixels develop(const Film& film, double exposure_ev) {
  const std::size_t count =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  if (film.width < 0 || film.height < 0 || film.radiance.size() != count) {
    throw Error(ErrorKind::internal, "developing a film whose size and pixels do not agree");
  }
  Pixels pixels{film.width, film.height, std::vector<std::uint8_t>(3 * count)};
  const double gain = std::exp2(exposure_ev);
  tbb::parallel_for(tbb::blocked_range<int>(0, film.height, 16), [&](const auto& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) develop_row(film, gain, y, pixels);
  });
  return pixels;
}

}  // namespace aerostat::image

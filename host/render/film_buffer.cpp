#include "render/film_buffer.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

namespace aerostat::render {
namespace {

constexpr int kBandRows = 128;

/// False if the pixel is no number and became black.
bool store(image::Film& film, std::size_t i, const AeroFilmPixel& pixel) {
  const float per_sample = 1.0f / static_cast<float>(std::max(pixel.samples, 1u));
  vec3 radiance = vec3(pixel.radiance[0], pixel.radiance[1], pixel.radiance[2]) * per_sample;
  const bool finite = is_finite(radiance);
  if (!finite) radiance = vec3(0.0f);
  film.radiance[i] = radiance;
  film.alpha[i] = pixel.coverage * per_sample;
  film.distance_m[i] = pixel.distance;
  film.normal_ws[i] = vec3(pixel.normal[0], pixel.normal[1], pixel.normal[2]);
  film.object_id[i] = pixel.object;
  film.samples[i] = pixel.samples;
  return finite;
}

image::Film empty_film(const Crop& crop) {
  image::Film film;
  film.width = crop.x1 - crop.x0;
  film.height = crop.y1 - crop.y0;
  const auto pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  // Who first touches a page waits for the system to clear it: on two cores at least.
  tbb::parallel_invoke([&] { film.radiance.resize(pixels); },
                       [&] { film.normal_ws.resize(pixels); },
                       [&] {
                         film.alpha.resize(pixels);
                         film.distance_m.resize(pixels);
                         film.object_id.resize(pixels);
                         film.samples.resize(pixels);
                       });
  return film;
}

}  // namespace

image::Film read_film(std::span<const FilmRows> parts, int image_width, const Crop& crop) {
  image::Film film = empty_film(crop);
  const auto width = static_cast<std::size_t>(film.width);
  std::atomic<std::uint64_t> nan_pixels{0};
  const auto store_row = [&](const AeroFilmPixel* pixels, int y) {
    const std::size_t to = static_cast<std::size_t>(y - crop.y0) * width;
    std::uint64_t bad = 0;
    for (std::size_t x = 0; x < width; ++x) {
      bad += store(film, to + x, pixels[x]) ? 0 : 1;
    }
    nan_pixels += bad;
  };
  const auto columns = static_cast<std::size_t>(image_width);
  for (const FilmRows& part : parts) {
    for (int y0 = part.y0; y0 < part.y1; y0 += kBandRows) {
      const int y1 = std::min(y0 + kBandRows, part.y1);
      const std::size_t first = static_cast<std::size_t>(y0) * columns;
      const std::size_t count = static_cast<std::size_t>(y1 - y0) * columns;
      part.film->look_at(first, count, [&](std::span<const AeroFilmPixel> band) {
        tbb::parallel_for(y0, y1, [&](int y) {
          const std::size_t row = static_cast<std::size_t>(y - y0) * columns;
          store_row(band.data() + row + static_cast<std::size_t>(crop.x0), y);
        });
      });
    }
  }
  film.nan_pixels = nan_pixels;
  return film;
}

}  // namespace aerostat::render

#include "render/film_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <oneapi/tbb/parallel_for.h>

namespace aerostat::render {
namespace {

constexpr int kBandRows = 128;

/// The counts of samples, hits and faulty pixels that reading a film yields.
struct Counts {
  std::uint64_t samples = 0, hits = 0, nan_pixels = 0;

  void add(const Counts& more) {
    samples += more.samples;
    hits += more.hits;
    nan_pixels += more.nan_pixels;
  }
};

/// Stores the mean radiance of a pixel. Returns false if it was NaN or infinite and became black.
bool store_light(image::Film& film, std::size_t i, const AeroFilmPixel& pixel) {
  const float per_sample = 1.0f / static_cast<float>(std::max(pixel.samples, 1u));
  vec3 radiance = vec3(pixel.radiance[0], pixel.radiance[1], pixel.radiance[2]) * per_sample;
  const bool finite = is_finite(radiance);
  if (!finite) radiance = vec3(0.0f);
  film.radiance[i] = radiance;
  return finite;
}

void store_layers(image::Film& film, std::size_t i, const AeroFilmPixel& pixel) {
  const float per_sample = 1.0f / static_cast<float>(std::max(pixel.samples, 1u));
  film.alpha[i] = pixel.coverage * per_sample;
  film.distance_m[i] = pixel.distance;
  film.normal_ws[i] = vec3(pixel.normal[0], pixel.normal[1], pixel.normal[2]);
  film.object_id[i] = pixel.object;
  film.samples[i] = pixel.samples;
}

Counts store_row(image::Film& film, std::size_t first, std::span<const AeroFilmPixel> pixels) {
  Counts counts;
  for (std::size_t x = 0; x < pixels.size(); ++x) {
    const AeroFilmPixel& pixel = pixels[x];
    counts.nan_pixels += store_light(film, first + x, pixel) ? 0 : 1;
    counts.samples += pixel.samples;
    // The coverage is a sum of whole numbers.
    counts.hits += static_cast<std::uint64_t>(pixel.coverage);
  }
  if (film.samples.empty()) return counts;
  for (std::size_t x = 0; x < pixels.size(); ++x) store_layers(film, first + x, pixels[x]);
  return counts;
}

image::Film empty_film(const FilmArea& area, Layers layers) {
  const Crop& crop = area.crop;
  image::Film film;
  film.first = {crop.x0, crop.y0};
  film.whole = {area.image_width, area.image_height};
  film.width = crop.x1 - crop.x0;
  film.height = crop.y1 - crop.y0;
  const std::size_t pixels = crop.pixels();
  film.radiance.resize(pixels);
  if (layers == Layers::light_alone) return film;
  film.alpha.resize(pixels);
  film.distance_m.resize(pixels);
  film.normal_ws.resize(pixels);
  film.object_id.resize(pixels);
  film.samples.resize(pixels);
  return film;
}

}  // namespace

ReadFilm read_film(std::span<const FilmRows> parts, const FilmArea& area, Layers layers) {
  image::Film film = empty_film(area, layers);
  const Crop &window = area.window, &crop = area.crop;
  const auto width = static_cast<std::size_t>(film.width);
  const auto columns = static_cast<std::size_t>(window.x1 - window.x0);
  const auto left = static_cast<std::size_t>(crop.x0 - window.x0);
  Counts all;
  std::mutex counting;
  for (const FilmRows& part : parts) {
    const int end = std::min(part.y1, crop.y1);
    for (int y0 = std::max(part.y0, crop.y0); y0 < end; y0 += kBandRows) {
      const int y1 = std::min(y0 + kBandRows, end);
      const std::size_t first = static_cast<std::size_t>(y0 - window.y0) * columns;
      const std::size_t count = static_cast<std::size_t>(y1 - y0) * columns;
      part.film->look_at(first, count, [&](std::span<const AeroFilmPixel> band) {
        tbb::parallel_for(y0, y1, [&](int y) {
          const std::size_t row = static_cast<std::size_t>(y - y0) * columns;
          const Counts counts = store_row(film, static_cast<std::size_t>(y - crop.y0) * width,
                                          band.subspan(row + left, width));
          const std::lock_guard lock(counting);
          all.add(counts);
        });
      });
    }
  }
  film.nan_pixels = all.nan_pixels;
  return {std::move(film), all.samples, all.hits};
}

}  // namespace aerostat::render

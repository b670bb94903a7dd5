#include "render/film_buffer.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <oneapi/tbb/parallel_for.h>

namespace aerostat::render {
namespace {

constexpr int kBandRows = 64;

/// False if the pixel is no number and became black.
bool store(image::Film& film, std::size_t i, const AeroFilmPixel& pixel, float per_sample) {
  vec3 radiance = vec3(pixel.radiance[0], pixel.radiance[1], pixel.radiance[2]) * per_sample;
  const bool finite = is_finite(radiance);
  if (!finite) radiance = vec3(0.0f);
  film.radiance[i] = radiance;
  film.alpha[i] = pixel.coverage * per_sample;
  film.distance_m[i] = pixel.distance;
  film.normal_ws[i] = vec3(pixel.normal[0], pixel.normal[1], pixel.normal[2]);
  film.object_id[i] = pixel.object;
  return finite;
}

/// Columns of the crop in `rows` rows from `y0` on, one call where they lie side by side.
void read_rows(const FilmBuffer& buffer, int image_width, const Crop& crop, int y0, int rows,
               std::vector<AeroFilmPixel>& to) {
  const auto width = static_cast<std::size_t>(crop.x1 - crop.x0);
  const bool whole = crop.x1 - crop.x0 == image_width;
  const std::size_t count = whole ? width * static_cast<std::size_t>(rows) : width;
  for (int row = 0; row < rows; row += whole ? rows : 1) {
    const auto from = static_cast<std::size_t>(y0 + row) * static_cast<std::size_t>(image_width);
    buffer.read(std::span(to).subspan(static_cast<std::size_t>(row) * width, count),
                from + static_cast<std::size_t>(crop.x0));
  }
}

image::Film empty_film(const Crop& crop) {
  image::Film film;
  film.width = crop.x1 - crop.x0;
  film.height = crop.y1 - crop.y0;
  const auto pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  film.radiance.resize(pixels);
  film.alpha.resize(pixels);
  film.distance_m.resize(pixels);
  film.normal_ws.resize(pixels);
  film.object_id.resize(pixels);
  return film;
}

}  // namespace

image::Film read_film(std::span<const FilmRows> parts, int image_width, const Crop& crop,
                      int samples) {
  image::Film film = empty_film(crop);
  const auto width = static_cast<std::size_t>(film.width);
  const float per_sample = 1.0f / static_cast<float>(samples);
  std::vector<AeroFilmPixel> band(width * kBandRows);
  std::atomic<std::uint64_t> nan_pixels{0};
  const auto store_band = [&](int y0, int rows) {
    tbb::parallel_for(0, rows, [&](int row) {
      const auto from = static_cast<std::size_t>(row) * width;
      const auto to = static_cast<std::size_t>(y0 - crop.y0 + row) * width;
      std::uint64_t bad = 0;
      for (std::size_t x = 0; x < width; ++x) {
        bad += store(film, to + x, band[from + x], per_sample) ? 0 : 1;
      }
      nan_pixels += bad;
    });
  };
  for (const FilmRows& part : parts) {
    for (int y0 = part.y0; y0 < part.y1; y0 += kBandRows) {
      const int rows = std::min(kBandRows, part.y1 - y0);
      read_rows(*part.film, image_width, crop, y0, rows, band);
      store_band(y0, rows);
    }
  }
  film.nan_pixels = nan_pixels;
  return film;
}

}  // namespace aerostat::render

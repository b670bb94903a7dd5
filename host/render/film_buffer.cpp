#include "render/film_buffer.hpp"

#include <cmath>

namespace aerostat::render {
namespace {

void store(image::Film& film, std::size_t i, const AeroFilmPixel& pixel, float per_sample) {
  vec3 radiance = vec3(pixel.radiance[0], pixel.radiance[1], pixel.radiance[2]) * per_sample;
  if (!is_finite(radiance)) {
    radiance = vec3(0.0f);
    ++film.nan_pixels;
  }
  film.radiance[i] = radiance;
  film.alpha[i] = pixel.coverage * per_sample;
  film.distance_m[i] = pixel.distance;
  film.normal_ws[i] = vec3(pixel.normal[0], pixel.normal[1], pixel.normal[2]);
  film.object_id[i] = pixel.object;
}

}  // namespace

image::Film read_film(const opencl::Buffer<AeroFilmPixel>& buffer, int image_width,
                      const Crop& crop, int samples) {
  image::Film film;
  film.width = crop.x1 - crop.x0;
  film.height = crop.y1 - crop.y0;
  const auto pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  film.radiance.resize(pixels);
  film.alpha.resize(pixels);
  film.distance_m.resize(pixels);
  film.normal_ws.resize(pixels);
  film.object_id.resize(pixels);
  std::vector<AeroFilmPixel> row(static_cast<std::size_t>(film.width));
  for (int y = 0; y < film.height; ++y) {
    const auto first =
        static_cast<std::size_t>(crop.y0 + y) * static_cast<std::size_t>(image_width);
    buffer.read(std::span(row), first + static_cast<std::size_t>(crop.x0));
    const auto to = static_cast<std::size_t>(y) * row.size();
    for (std::size_t x = 0; x < row.size(); ++x) {
      store(film, to + x, row[x], 1.0f / static_cast<float>(samples));
    }
  }
  return film;
}

}  // namespace aerostat::render

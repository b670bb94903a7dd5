#include "render/film_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <oneapi/tbb/parallel_for.h>

#include "image/pixel_filter.hpp"

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
  film.object_id[i] = pixel.object;
  film.samples[i] = pixel.samples;
}

/// Stores a row of pixels whose first one is pixel `x0` of the image, and counts those inside
/// `counted`, which may be none.
Counts store_row(image::Film& film, std::size_t first, std::span<const AeroFilmPixel> pixels,
                 int x0, const Crop& counted) {
  Counts counts;
  for (std::size_t x = 0; x < pixels.size(); ++x) {
    const AeroFilmPixel& pixel = pixels[x];
    const bool finite = store_light(film, first + x, pixel);
    const int column = x0 + static_cast<int>(x);
    if (column < counted.x0 || column >= counted.x1) continue;
    counts.nan_pixels += finite ? 0 : 1;
    counts.samples += pixel.samples;
    // The coverage is a sum of whole numbers.
    counts.hits += static_cast<std::uint64_t>(pixel.coverage);
  }
  if (film.samples.empty()) return counts;
  for (std::size_t x = 0; x < pixels.size(); ++x) store_layers(film, first + x, pixels[x]);
  return counts;
}

void store_guide(image::Film& film, std::size_t i, const AeroFilmGuide& guide) {
  const float per_sample = 1.0f / static_cast<float>(std::max(film.samples[i], 1u));
  film.albedo[i] = vec3(guide.albedo[0], guide.albedo[1], guide.albedo[2]) * per_sample;
  film.normal_ws[i] = vec3(guide.normal[0], guide.normal[1], guide.normal[2]) * per_sample;
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
  film.object_id.resize(pixels);
  film.samples.resize(pixels);
  if (layers == Layers::hits) return film;
  film.albedo.resize(pixels);
  film.normal_ws.resize(pixels);
  return film;
}

/// Rows of a part of the film that are read at once.
struct Band {
  int y0 = 0, y1 = 0;
  /// The elements of a buffer that hold the rows of the window.
  std::size_t first = 0, count = 0;
};

/// Calls `read` for the rows of a part that lie in the crop, some at a time.
template <typename Read>
void for_bands(const FilmRows& part, const FilmArea& area, Read&& read) {
  const auto columns = static_cast<std::size_t>(area.window.x1 - area.window.x0);
  const int end = std::min(part.y1, area.crop.y1);
  for (int y0 = std::max(part.y0, area.crop.y0); y0 < end; y0 += kBandRows) {
    const int y1 = std::min(y0 + kBandRows, end);
    read(Band{y0, y1, static_cast<std::size_t>(y0 - area.window.y0) * columns,
              static_cast<std::size_t>(y1 - y0) * columns});
  }
}

/// Calls `store(y, first, row)` for each row of a band on all cores: with the place of its first
/// pixel in the film, and its elements in the crop.
template <typename T, typename Store>
void for_rows(const Band& band, const FilmArea& area, std::span<const T> elements, Store&& store) {
  const auto width = static_cast<std::size_t>(area.crop.x1 - area.crop.x0);
  const auto columns = static_cast<std::size_t>(area.window.x1 - area.window.x0);
  const auto left = static_cast<std::size_t>(area.crop.x0 - area.window.x0);
  tbb::parallel_for(band.y0, band.y1, [&](int y) {
    const std::size_t row = static_cast<std::size_t>(y - band.y0) * columns;
    store(y, static_cast<std::size_t>(y - area.crop.y0) * width,
          elements.subspan(row + left, width));
  });
}

void read_guides(const FilmRows& part, const FilmArea& area, image::Film& film) {
  for_bands(part, area, [&](const Band& band) {
    part.film->guides.look_at(band.first, band.count, [&](std::span<const AeroFilmGuide> guides) {
      for_rows(band, area, guides, [&](int, std::size_t first, std::span<const AeroFilmGuide> row) {
        for (std::size_t x = 0; x < row.size(); ++x) store_guide(film, first + x, row[x]);
      });
    });
  });
}

/// Returns the area of the crop and those neighbours of its pixels that the filter reads.
FilmArea with_neighbours(FilmArea area) {
  if (area.side_weight <= 0.0f) return area;
  area.crop = {std::max(area.crop.x0 - 1, 0), std::max(area.crop.y0 - 1, 0),
               std::min(area.crop.x1 + 1, area.image_width),
               std::min(area.crop.y1 + 1, area.image_height)};
  return area;
}

}  // namespace

ReadFilm read_film(std::span<const FilmRows> parts, const FilmArea& area, Layers layers) {
  const FilmArea wide = with_neighbours(area);
  image::Film film = empty_film(wide, layers);
  Counts all;
  std::mutex counting;
  for (const FilmRows& part : parts) {
    for_bands(part, wide, [&](const Band& band) {
      part.film->pixels.look_at(band.first, band.count, [&](std::span<const AeroFilmPixel> pixels) {
        for_rows(band, wide, pixels,
                 [&](int y, std::size_t first, std::span<const AeroFilmPixel> row) {
                   const bool is_counted = y >= area.crop.y0 && y < area.crop.y1;
                   const Counts counts =
                       store_row(film, first, row, wide.crop.x0, is_counted ? area.crop : Crop{});
                   const std::lock_guard lock(counting);
                   all.add(counts);
                 });
      });
    });
    if (layers == Layers::all) read_guides(part, wide, film);
  }
  image::filter_pixels(film, area.side_weight);
  image::cut_to(film, {area.crop.x0, area.crop.y0}, {area.crop.x1, area.crop.y1});
  film.nan_pixels = all.nan_pixels;
  return {std::move(film), all.samples, all.hits};
}

}  // namespace aerostat::render

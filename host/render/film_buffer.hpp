#pragma once

#include <span>

#include "film_pixel.h"
#include "image/film.hpp"
#include "opencl/buffer.hpp"
#include "render/session.hpp"

namespace aerostat::render {

using FilmBuffer = opencl::Buffer<AeroFilmPixel>;

/// Rows of the image, y0 <= y < y1, and the film that holds them.
struct FilmRows {
  int y0 = 0, y1 = 0;
  const FilmBuffer* film = nullptr;
};

struct ReadFilm {
  image::Film film;
  std::uint64_t samples = 0;  // of all pixels
  std::uint64_t hits = 0;     // samples that met something
};

/// Reads the pixels of `crop`, whose rows are `parts` from the top, and averages their samples.
/// Pixels that are NaN or infinite become black and are counted.
ReadFilm read_film(std::span<const FilmRows> parts, int image_width, const Crop& crop,
                   Layers layers = Layers::all);

}  // namespace aerostat::render

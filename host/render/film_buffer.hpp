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

/// What films on devices hold, and what of it is wanted.
struct FilmArea {
  int image_width = 0, image_height = 0;
  Crop window;  // of the image, that the films hold
  Crop crop;    // inside the window
};

/// Reads the pixels of the crop, whose rows are among `parts`, and averages their samples. Pixels
/// that are NaN or infinite become black and are counted.
ReadFilm read_film(std::span<const FilmRows> parts, const FilmArea& area,
                   Layers layers = Layers::all);

}  // namespace aerostat::render

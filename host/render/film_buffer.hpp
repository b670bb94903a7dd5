#pragma once

#include <span>

#include "image/film.hpp"
#include "render/buffers.hpp"
#include "render/session.hpp"

namespace aerostat::render {

/// Rows of the image, y0 <= y < y1, and the film that holds them.
struct FilmRows {
  int y0 = 0, y1 = 0;
  const DeviceFilm* film = nullptr;
};

struct ReadFilm {
  image::Film film;
  /// The number of samples of all pixels.
  std::uint64_t samples = 0;
  /// The number of samples that hit something.
  std::uint64_t hits = 0;
};

/// The pixels of an image that films on devices hold, and those of them that are read.
struct FilmArea {
  int image_width = 0, image_height = 0;
  /// The pixels of the image that the films hold.
  Crop window;
  /// The pixels that are read. They lie inside the window.
  Crop crop;
  /// The weight of either neighbour in the filter of the pixels (image::filter_pixels). If it is
  /// not 0, the window holds all neighbours of the crop that the image has.
  float side_weight = 0.0f;
};

/// The layers of a film: the light alone, the light and what the samples hit, or also the guides of
/// a denoiser.
enum class Layers { light_alone, hits, all };

/// Returns the layers of the films of a session.
inline Layers layers_of(const Options& options) {
  if (options.guides) return Layers::all;
  return options.contents == Contents::picture ? Layers::light_alone : Layers::hits;
}

/// Reads the pixels of the crop and their neighbours, whose rows are among `parts`, averages their
/// samples, and filters them. Pixels that are NaN or infinite become black and are counted. What is
/// counted is that of the crop.
ReadFilm read_film(std::span<const FilmRows> parts, const FilmArea& area,
                   Layers layers = Layers::all);

}  // namespace aerostat::render

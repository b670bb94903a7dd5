#pragma once

#include <cstdint>

#include "film_pixel.h"
#include "image/film.hpp"
#include "opencl/buffer.hpp"
#include "render/session.hpp"

namespace aerostat::render {

/// Reads the pixels of `crop` after `samples` samples each and averages them. Pixels that are NaN
/// or infinite become black and are counted.
image::Film read_film(const opencl::Buffer<AeroFilmPixel>& film, int image_width, const Crop& crop,
                      int samples);

}  // namespace aerostat::render

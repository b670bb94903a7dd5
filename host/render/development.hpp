#pragma once

#include "image/write.hpp"
#include "scene/picture.hpp"

namespace aerostat::render {

/// Returns how a scene wants its film developed. Settings that the scene leaves open follow from
/// the metering of the film.
image::Development development_of(const scene::Image& image, const image::Film& film);

}  // namespace aerostat::render

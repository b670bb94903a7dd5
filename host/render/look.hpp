#pragma once

#include "image/write.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {

/// How a scene wants its film developed; what it leaves open follows from what the film
/// was metered to.
image::Look look_of(const scene::Image& image, const image::Film& film);

}  // namespace aerostat::render

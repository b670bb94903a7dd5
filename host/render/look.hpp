#pragma once

#include <optional>

#include "image/write.hpp"
#include "render/session.hpp"

namespace aerostat::render {

/// How a scene wants its film developed; what it leaves open follows from the film. `crop` is the
/// part of the picture that the film shows.
image::Look look_of(const scene::Image& image, const image::Film& film,
                    const std::optional<Crop>& crop = {});

}  // namespace aerostat::render

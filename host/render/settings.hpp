#pragma once

#include <cstdint>
#include <optional>

#include "film_pixel.h"
#include "render/device_worker.hpp"
#include "render/passes.hpp"
#include "render/session.hpp"
#include "scene/scene.hpp"

/// What a session works out from the settings of a scene and of its own.
namespace aerostat::render {

/// The time that a launch aims at, in seconds.
double launch_seconds_of(Use use);

/// Returns the number of shadow rays: each hit sends one to each light that casts shadows.
std::uint64_t shadow_rays_of(std::uint64_t hits, const scene::Scene& scene);

/// Returns the noise at which pixels count as converged. A display shows about the square root of
/// the light, so noise is measured there. A white card in the sun is white, and shades below a
/// fiftieth of it count as dark. `daylight` is the radiance of that card.
AeroConvergence convergence_of(const scene::Image& image, const dvec3& daylight,
                               const AeroWindow& film);

/// Returns whether a render of `crop` takes exactly the rays of `metering`, in one pass. Then a
/// film of its own would only repeat them.
bool takes_all_rays_of(const AeroFrame& metering, const AeroFrame& whole, const Crop& crop,
                       const PassPlan& plan);

/// Returns the weight of either neighbour with which image::filter_pixels() makes a filter. The
/// samples of a pixel fill a square, whose variance along an axis is 1/12 of a squared pixel. The
/// filter adds twice the weight to it. The sum is 1/6 for a tent two pixels wide, and 1/4 for a
/// normal distribution with a sigma of half a pixel.
float side_weight_of(scene::Filter filter);

/// Returns the crop, or the whole image. Throws Error{usage} if the crop is not inside the image.
Crop checked_crop(const scene::Image& image, const std::optional<Crop>& crop);

/// Returns the picture's settings for a film whose sides have `shrink` times fewer pixels, rounded
/// up.
scene::Image shrunk(scene::Image image, int shrink);

}  // namespace aerostat::render

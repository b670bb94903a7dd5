#include "render/settings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "image/tone.hpp"

namespace aerostat::render {

double launch_seconds_of(Use use) {
  // Chosen by eye.
  return use == Use::interactive ? 0.02 : 0.03;
}

std::uint64_t shadow_rays_of(std::uint64_t hits, const scene::Scene& scene) {
  const auto lamps = std::count_if(scene.lights.begin(), scene.lights.end(),
                                   [](const scene::PointLight& light) { return light.shadows; });
  return hits * (static_cast<std::uint64_t>(lamps) + (scene.sun.shadows ? 1 : 0));
}

AeroConvergence convergence_of(const scene::Image& image, const dvec3& daylight,
                               const AeroWindow& film) {
  const double white = image::luminance(daylight);
  const double noise = image.adaptive_threshold;
  return {static_cast<float>(4.0 * noise * noise * white), static_cast<float>(0.02 * white),
          film.width, film.height};
}

bool takes_all_rays_of(const AeroFrame& metering, const AeroFrame& whole, const Crop& crop,
                       const PassPlan& plan) {
  return metering.width == whole.width && metering.height == whole.height &&
         metering.samples == whole.samples && metering.sample_stride == whole.sample_stride &&
         crop.pixels() == std::size_t{whole.width} * whole.height &&
         static_cast<std::uint32_t>(plan.samples_from(0)) == whole.samples;
}

float side_weight_of(scene::Filter filter) {
  switch (filter) {
    case scene::Filter::box:
      return 0.0f;
    case scene::Filter::tent:
      return 1.0f / 24.0f;
    case scene::Filter::gaussian:
      return 1.0f / 12.0f;
  }
  return 0.0f;
}

Crop checked_crop(const scene::Image& image, const std::optional<Crop>& crop) {
  const Crop all{0, 0, image.width, image.height};
  if (!crop) return all;
  if (crop->x0 < 0 || crop->y0 < 0 || crop->x1 > all.x1 || crop->y1 > all.y1 ||
      crop->x0 >= crop->x1 || crop->y0 >= crop->y1) {
    throw Error(ErrorKind::usage,
                fmt::format("crop {},{},{},{} is not inside the image of {} x {} pixels", crop->x0,
                            crop->y0, crop->x1, crop->y1, all.x1, all.y1));
  }
  return *crop;
}

scene::Image shrunk(scene::Image image, int shrink) {
  image.width = (image.width + shrink - 1) / shrink;
  image.height = (image.height + shrink - 1) / shrink;
  return image;
}

}  // namespace aerostat::render

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/copy.hpp"
#include "pack/pack_scene.hpp"
#include "rules/sample_square.h"
#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"
#include "scene/view_axes.hpp"

namespace aerostat::pack {
namespace {

// Of a full-frame camera.
constexpr double kSensorHeightM = 0.024;
// The nearest that a scene may ask for; a target may be nearer.
constexpr double kNearestFocusM = 0.01;

// Parallel rays begin before the world if it is this far away.
constexpr double kFarM = 8192.0;
constexpr double kBeforeWorldM = 100.0;

/// A stride that visits all of `samples` strata and leaps by about 0.38 of them, so that any first
/// few of them are spread evenly.
std::uint32_t spreading_stride(std::uint32_t samples) {
  auto stride = std::max(1u, static_cast<std::uint32_t>(0.381966 * samples + 0.5));
  while (std::gcd(stride, samples) != 1) ++stride;
  return stride;
}

/// Returns the mean offset of all samples of a pixel from its centre, in pixels. A few samples lie
/// to one side of the pixel with most seeds, by 0.19 pixels for 4 samples.
vec2 mean_offset(const AeroFrame& frame) {
  if (frame.samples <= 1) return vec2(0.0f);
  dvec2 sum(0.0);
  for (std::uint32_t sample = 0; sample < frame.samples; ++sample) {
    float dx = 0.0f, dy = 0.0f;
    rules::sample_offset(&frame, sample, &dx, &dy);
    sum += dvec2(dx, dy);
  }
  return vec2(sum / static_cast<double>(frame.samples));
}

std::uint32_t lens_of(scene::Lens lens) {
  switch (lens) {
    case scene::Lens::pinhole:
      return AERO_LENS_PINHOLE;
    case scene::Lens::thin_lens:
      return AERO_LENS_THIN;
    case scene::Lens::panorama:
      return AERO_LENS_PANORAMA;
    case scene::Lens::orthographic:
      return AERO_LENS_ORTHOGRAPHIC;
  }
  return AERO_LENS_PINHOLE;
}

/// Metres ahead of the eye at which the first of a box is met, negative if part of it lies behind;
/// infinite if the box is empty. The eye counts from where the box does.
double depth_of(const bvh::Bounds& box, const dvec3& eye, const dvec3& forward) {
  if (!(box.lo.x <= box.hi.x)) return std::numeric_limits<double>::infinity();
  const dvec3 lo(box.lo), hi(box.hi);
  const dvec3 middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
  return glm::dot(middle - eye, forward) - glm::dot(glm::abs(forward), half);
}

/// Radius of a thin lens's aperture in metres.
double aperture_radius(const scene::Camera& camera) {
  if (camera.aperture_m) return 0.5 * *camera.aperture_m;
  const double tangent = std::tan(camera.fov_y_deg * (std::numbers::pi / 360.0));
  return 0.25 * kSensorHeightM / tangent / camera.f_number;
}

AeroCamera pack_camera(const scene::ResolvedScene& scene, const bvh::Bounds& world) {
  const scene::Camera& from = scene->camera;
  const int width = scene->image.width, height = scene->image.height;
  const auto [right, up, forward] = scene::view_axes(from);
  const bool parallel = from.lens == scene::Lens::orthographic;
  const double half_height =
      parallel ? 0.5 * from.view_height_m : std::tan(from.fov_y_deg * (std::numbers::pi / 360.0));
  const double pixel = 2.0 * half_height / height;
  AeroCamera camera{};
  const dvec3 eye = scene.eye() - scene.origin();
  const double depth = parallel ? depth_of(world, eye, forward) : 0.0;
  const bool far = depth >= kFarM && std::isfinite(depth);
  camera.lead = far ? static_cast<float>(depth - kBeforeWorldM) : 0.0f;
  copy(camera.origin, eye + forward * static_cast<double>(camera.lead));
  copy(camera.step_x, right * pixel);
  copy(camera.step_y, up * -pixel);
  const dvec3 ahead = parallel ? dvec3(0.0) : forward;
  copy(camera.corner, ahead - right * (0.5 * pixel * width) + up * half_height);
  copy(camera.right, right);
  copy(camera.up, up);
  copy(camera.forward, forward);
  camera.lens = lens_of(from.lens);
  camera.aperture = static_cast<float>(aperture_radius(from));
  const double focus = from.focus_m.value_or(glm::length(scene.target() - scene.eye()));
  camera.focus = static_cast<float>(std::max(focus, kNearestFocusM));
  return camera;
}

}  // namespace

AeroFrame pack_frame(const scene::ResolvedScene& scene, const bvh::Bounds& world) {
  AeroFrame frame{};
  frame.camera = pack_camera(scene, world);
  frame.width = static_cast<std::uint32_t>(scene->image.width);
  frame.height = static_cast<std::uint32_t>(scene->image.height);
  frame.samples = static_cast<std::uint32_t>(scene->image.spp);
  frame.sample_stride = spreading_stride(frame.samples);
  frame.progressive = scene->image.adaptive_threshold > 0.0 ? 1u : 0u;
  const scene::PixelSize pixel = scene::pixel_size(*scene);
  frame.pixel_angle = static_cast<float>(pixel.angle_rad);
  frame.pixel_width = static_cast<float>(pixel.width_m);
  frame.sample_spread = 1.0f;
  frame.sample_shift = scene->image.seed * 0x9e3779b9u;
  const vec2 mean = mean_offset(frame);
  frame.sample_mean[0] = mean.x;
  frame.sample_mean[1] = mean.y;
  return frame;
}

}  // namespace aerostat::pack

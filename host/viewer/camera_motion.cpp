#include "viewer/camera_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/view_axes.hpp"

namespace aerostat::viewer {
namespace {

constexpr double kLeastDistance_m = 0.5;
/// The steepest direction of view in radians. It keeps the eye off the poles.
constexpr double kSteepest_rad = 89.0 * std::numbers::pi / 180.0;

/// A vector given by its length and two angles in radians.
struct Polar {
  double length, azimuth, elevation;
};

Polar polar_of(const dvec3& v) {
  const double level = std::hypot(v.x, v.z);
  // A vector straight up or down gets the azimuth of north, as in scene::view_axes.
  const double azimuth = level > 1e-6 * std::abs(v.y) ? std::atan2(v.x, -v.z) : 0.0;
  return {glm::length(v), azimuth, std::atan2(v.y, level)};
}

dvec3 vector_of(const Polar& p) {
  const double level = p.length * std::cos(p.elevation);
  return {level * std::sin(p.azimuth), p.length * std::sin(p.elevation),
          -level * std::cos(p.azimuth)};
}

/// Returns the direction of view after a turn that moves the content of the picture to the right
/// and down.
dvec3 turned(const dvec3& sight, double right_rad, double down_rad) {
  Polar polar = polar_of(sight);
  polar.azimuth -= right_rad;
  polar.elevation = std::clamp(polar.elevation + down_rad, -kSteepest_rad, kSteepest_rad);
  return vector_of(polar);
}

dvec3 level_right(const dvec3& sight) {
  const double azimuth = polar_of(sight).azimuth;
  return {std::cos(azimuth), 0.0, std::sin(azimuth)};
}

}  // namespace

Pose orbit(const Pose& pose, double right_rad, double down_rad) {
  const dvec3 sight = pose.target - pose.position;
  return {pose.target - turned(sight, -right_rad, -down_rad), pose.target};
}

Pose look(const Pose& pose, double right_rad, double down_rad) {
  return {pose.position, pose.position + turned(pose.target - pose.position, right_rad, down_rad)};
}

Pose dolly(const Pose& pose, double factor) {
  const dvec3 sight = pose.target - pose.position;
  const double length = glm::length(sight);
  const double wanted = std::max(kLeastDistance_m, length * factor);
  return {pose.target - sight * (wanted / length), pose.target};
}

Pose fly(const Pose& pose, const Flight& flight, double distance_m) {
  const dvec3 sight = pose.target - pose.position;
  const dvec3 step = glm::normalize(sight) * flight.forward + level_right(sight) * flight.right +
                     dvec3(0.0, flight.up, 0.0);
  return {pose.position + step * distance_m, pose.target + step * distance_m};
}

Pose above_ground(const Pose& pose, const HeightAt& height) {
  const double least = height(pose.position.x, pose.position.z) + kEyeClearance_m;
  const dvec3 lift(0.0, std::max(0.0, least - pose.position.y), 0.0);
  return {pose.position + lift, pose.target + lift};
}

double flight_speed(double height_m) {
  return std::clamp(0.6 * height_m, 8.0, 1500.0);
}

Sight sight_at(const scene::Camera& camera, double aspect, double x, double y) {
  const auto [right, up, forward] = scene::view_axes(camera);
  const double across = 2.0 * x - 1.0, above = 1.0 - 2.0 * y;
  if (camera.lens == scene::Lens::panorama) {
    const double turn = across * std::numbers::pi, rise = above * 0.5 * std::numbers::pi;
    const dvec3 level = forward * std::cos(turn) + right * std::sin(turn);
    return {*camera.position, level * std::cos(rise) + up * std::sin(rise)};
  }
  if (camera.lens == scene::Lens::orthographic) {
    const double half = 0.5 * camera.view_height_m;
    return {*camera.position + right * (across * half * aspect) + up * (above * half), forward};
  }
  const double half = std::tan(camera.fov_y_deg * (std::numbers::pi / 360.0));
  return {*camera.position,
          glm::normalize(forward + right * (across * half * aspect) + up * (above * half))};
}

std::optional<dvec2> place_in_picture(const scene::Camera& camera, double aspect,
                                      const dvec3& point) {
  const auto [right, up, forward] = scene::view_axes(camera);
  const dvec3 away = point - *camera.position;
  const double ahead = glm::dot(away, forward);
  double across = glm::dot(away, right), above = glm::dot(away, up);
  if (camera.lens == scene::Lens::panorama) {
    const double rise = std::atan2(above, std::hypot(ahead, across));
    across = std::atan2(across, ahead) / std::numbers::pi;
    above = rise / (0.5 * std::numbers::pi);
  } else if (camera.lens == scene::Lens::orthographic) {
    const double half = 0.5 * camera.view_height_m;
    across /= half * aspect;
    above /= half;
  } else {
    if (!(ahead > 0.0)) return std::nullopt;
    const double half = ahead * std::tan(camera.fov_y_deg * (std::numbers::pi / 360.0));
    across /= half * aspect;
    above /= half;
  }
  if (!(std::abs(across) <= 1.0 && std::abs(above) <= 1.0)) return std::nullopt;
  return dvec2(0.5 + 0.5 * across, 0.5 - 0.5 * above);
}

}  // namespace aerostat::viewer

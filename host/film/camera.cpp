#include "film/camera.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "model/balloon.hpp"

namespace aerostat::film {
namespace {

using scene::CameraLook;
using scene::CameraMode;

/// The height of an observer's eyes above the ground, and the least height of a camera that flies.
constexpr double kEyeHeight_m = 1.7;
/// The share of a balloon's height at which the camera looks. Chosen by eye: the envelope fills
/// most of the height.
constexpr double kMiddle = 0.55;
/// The time by which a camera that looks ahead looks ahead. It also bridges rests shorter than it.
constexpr double kAhead_s = 0.5;

dvec3 middle_of(const scene::Balloon& balloon) {
  return balloon.position + dvec3(0.0, kMiddle * model::balloon_height(balloon), 0.0);
}

std::vector<double> times_of(const std::vector<scene::PathPoint>& path, double duration_s) {
  std::vector<double> times;
  for (const scene::PathPoint& point : path) times.push_back(point.time_s);
  const bool is_timed = std::any_of(times.begin(), times.end(), [](double t) { return t > 0.0; });
  for (std::size_t i = 0; !is_timed && i < times.size(); ++i) {
    times[i] = duration_s * static_cast<double>(i) / static_cast<double>(times.size() - 1);
  }
  return times;
}

}  // namespace

CameraRig::CameraRig(const scene::Scene& start, BalloonAt balloon, HeightAt ground)
    : how_(start.film.camera),
      balloon_(std::move(balloon)),
      ground_(std::move(ground)),
      balloon_start_(balloon_(0.0)),
      rides_(start.camera.view == scene::View::basket) {
  if (how_.mode == CameraMode::path) {
    std::vector<dvec3> points;
    for (const scene::PathPoint& point : how_.path) {
      points.push_back(lifted(start.camera, point.position));
    }
    path_.emplace(std::move(points), times_of(how_.path, start.film.duration_s),
                  how_.constant_speed);
  }
  if (how_.mode == CameraMode::chase) {
    const dvec3 eye = start.camera.position ? lifted(start.camera, *start.camera.position)
                                            : model::basket_eye(start.balloon);
    const dvec3 offset = eye - balloon_start_;
    chase_.emplace([this, offset](double time) { return balloon_(time) + offset; }, how_.lag_s);
  }
}

/// Returns a point of the camera with its height above the sea. Heights above the balloon count
/// from where its basket was at the beginning, so that the camera does not bob with it.
dvec3 CameraRig::lifted(const scene::Camera& camera, dvec3 point) const {
  if (camera.height_above == scene::HeightReference::ground) point.y += ground_(point.x, point.z);
  if (camera.height_above == scene::HeightReference::balloon) point.y += balloon_start_.y;
  return point;
}

dvec3 CameraRig::above_ground(dvec3 eye) const {
  eye.y = std::max(eye.y, ground_(eye.x, eye.z) + kEyeHeight_m);
  return eye;
}

/// Returns the eye, or nothing for a passenger in the basket.
std::optional<dvec3> CameraRig::eye_at(const scene::Scene& scene, double time_s) {
  const scene::Camera& camera = scene.camera;
  switch (how_.mode) {
    case CameraMode::path:
      return above_ground(path_->at(time_s));
    case CameraMode::orbit: {
      const double azimuth = glm::radians(how_.from_deg + how_.turn_deg_s * time_s);
      const dvec3 around(std::sin(azimuth), 0.0, -std::cos(azimuth));
      return above_ground(scene.balloon.position + how_.radius_m * around +
                          dvec3(0.0, how_.height_m, 0.0));
    }
    case CameraMode::chase:
      return above_ground(chase_->at(time_s));
    case CameraMode::basket:
      return std::nullopt;
    case CameraMode::ground: {
      const dvec3 at = camera.position.value_or(balloon_start_);
      return dvec3(at.x, ground_(at.x, at.z) + kEyeHeight_m, at.z);
    }
    case CameraMode::scene:
      break;
  }
  if (!camera.position) return std::nullopt;
  const dvec3 ride = rides_ ? balloon_(time_s) - balloon_start_ : dvec3(0.0);
  return lifted(camera, *camera.position) + ride;
}

CameraLook CameraRig::look_of(const scene::Camera& camera) const {
  if (how_.look != CameraLook::usual) return how_.look;
  switch (how_.mode) {
    case CameraMode::orbit:
    case CameraMode::chase:
    case CameraMode::ground:
      return CameraLook::balloon;
    case CameraMode::basket:
      return CameraLook::ahead;
    case CameraMode::scene:
    case CameraMode::path:
      break;
  }
  return camera.target ? CameraLook::target : CameraLook::ahead;
}

/// Returns a point ahead of an eye on its way. An eye that rests looks to the balloon.
dvec3 CameraRig::ahead_of(const scene::Scene& scene, const dvec3& eye, double time_s) {
  constexpr double kFar_m = 100.0;
  const double from = std::max(time_s - 0.5 * kAhead_s, 0.0), to = time_s + 0.5 * kAhead_s;
  const auto before = eye_at(scene, from), after = eye_at(scene, to);
  const dvec3 way = before && after ? *after - *before : dvec3(0.0);
  if (!(glm::length(way) > 1e-6)) return middle_of(scene.balloon);
  return eye + kFar_m * glm::normalize(way);
}

void CameraRig::move(scene::Scene& scene, double time_s) {
  scene::Camera& camera = scene.camera;
  const CameraLook look = look_of(camera);
  const std::optional<dvec3> eye = eye_at(scene, time_s);
  const std::optional<dvec3> target = camera.target;
  camera.target.reset();
  camera.position = eye;
  if (look == CameraLook::balloon) {
    camera.target = middle_of(scene.balloon);
  } else if (look == CameraLook::target && target) {
    const bool rides = rides_ && how_.mode == CameraMode::scene;
    camera.target =
        lifted(camera, *target) + (rides ? balloon_(time_s) - balloon_start_ : dvec3(0.0));
  } else if (eye) {
    camera.target = ahead_of(scene, *eye, time_s);
  }
  camera.height_above = scene::HeightReference::sea;
}

}  // namespace aerostat::film

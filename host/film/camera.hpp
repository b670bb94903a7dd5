#pragma once

#include <functional>
#include <optional>

#include "film/curve.hpp"
#include "film/movers.hpp"
#include "film/wind.hpp"
#include "scene/film.hpp"
#include "scene/scene.hpp"

namespace aerostat::film {

/// Moves the camera as /film/camera says.
class CameraRig {
 public:
  /// Returns where the first balloon is at a time, with its height above the sea.
  using BalloonAt = std::function<dvec3(double time_s)>;

  /// Takes the scene at the beginning.
  CameraRig(const scene::Scene& start, BalloonAt balloon, HeightAt ground);

  /// Sets eye and target of a scene at a time, with heights above the sea. The balloons of the
  /// scene must be at their places. A camera in the basket that looks ahead stays without both.
  void move(scene::Scene& scene, double time_s);

 private:
  dvec3 lifted(const scene::Camera& camera, dvec3 point) const;
  std::optional<dvec3> eye_at(const scene::Scene& scene, double time_s);
  dvec3 above_ground(dvec3 eye) const;
  dvec3 ahead_of(const scene::Scene& scene, const dvec3& eye, double time_s);
  scene::CameraLook look_of(const scene::Camera& camera) const;

  scene::CameraMove how_;
  BalloonAt balloon_;
  HeightAt ground_;
  dvec3 balloon_start_;
  bool rides_ = false;  // the scene's camera belongs to the basket
  std::optional<Curve> path_;
  std::optional<Chase> chase_;
};

}  // namespace aerostat::film

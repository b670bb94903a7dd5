#pragma once

#include <vector>

#include "scene/balloon.hpp"

/// A scene file has a first balloon, which cameras may refer to, and a list of further ones. All
/// else goes by these lists of both, the first one first.
namespace aerostat::scene {

struct Scene;

/// Turns the festival of a scene, whose heights count from the ground, into further balloons, after
/// which its count is 0. Equal festivals give equal balloons.
void hold_festival(Scene& scene);

/// The balloons that are there: those that are enabled.
std::vector<const Balloon*> balloons_of(const Scene& scene);

/// All balloons, enabled or not.
std::vector<Balloon*> all_balloons(Scene& scene);

}  // namespace aerostat::scene

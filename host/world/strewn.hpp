#pragma once

#include <cstddef>
#include <vector>

#include "scatter/surface.hpp"
#include "scene/placed_model.hpp"
#include "world/group.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::world {

struct FileModel;

/// Returns whether an entry of the scene's models asks for instances over an area.
bool is_strewn(const scene::PlacedModel& placed);

/// The instances of a model that are strewn over an area.
struct Strewn {
  std::size_t object = 0;  // in Scene::objects
  std::vector<scatter::Instance> instances;
};

/// Strews the models of the scene that ask for it, in the order of Scene::objects. Their places
/// follow from the seeds, the rules and the ground alone: a greater count adds instances to those
/// that are there. Where the rules leave no room, there are fewer. The surface is that of the
/// input's ground. Throws Error{interrupted} if core/stop_scope.hpp asks to stop.
std::vector<Strewn> strew(const GroupInput& input, const scatter::Surface& surface);

/// Returns whether the strewn models of two scenes on the same ground stand alike.
bool same_strewn(const scene::Scene& a, const scene::Scene& b);

/// Returns the lowest ground under the corners and the middle of an instance's base, so that no
/// side of it hovers over a slope.
float lowest_ground(const scatter::Surface& surface, const FileModel& model,
                    const scatter::Instance& instance);

}  // namespace aerostat::world

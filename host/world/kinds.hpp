#pragma once

#include <vector>

#include "world/group.hpp"

namespace aerostat::world {

/// The kinds of groups of a world, in the order of its groups.
using GroupKinds = std::vector<const GroupKind*>;

/// The land, which is the ground.
extern const GroupKind kLand;
/// The sea.
extern const GroupKind kSea;
/// Lakes and rivers of real land.
extern const GroupKind kInlandWater;
/// All balloons of a scene, each as fine as its size in the picture asks for.
extern const GroupKind kBalloons;
/// Models from files.
extern const GroupKind kModels;
/// Plants and stones, each in the level of detail that its size in the picture asks for.
extern const GroupKind kPlants;

/// The lines of flights that the scene shows.
extern const GroupKind kTrackLines;

/// Returns the kinds of groups that every world has.
GroupKinds all_kinds();

}  // namespace aerostat::world

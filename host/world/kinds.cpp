#include "world/kinds.hpp"

namespace aerostat::world {

GroupKinds all_kinds() {
  return {&kLand, &kSea, &kInlandWater, &kBalloons, &kModels, &kPlants, &kTrackLines};
}

}  // namespace aerostat::world

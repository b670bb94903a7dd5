#include "world/kinds.hpp"

namespace aerostat::world {

GroupKinds all_kinds() {
  return {&kLand, &kSea, &kInlandWater, &kBalloons, &kPlants};
}

}  // namespace aerostat::world

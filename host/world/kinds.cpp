#include "world/kinds.hpp"

namespace aerostat::world {

GroupKinds all_kinds() {
  return {&kLand, &kSea, &kBalloons, &kPlants};
}

}  // namespace aerostat::world

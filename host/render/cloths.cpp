#include "render/cloths.hpp"

#include "pack/dyed_cloth.hpp"

namespace aerostat::render {

std::vector<asset::Texture> cloths_of(const scene::Scene& scene) {
  return pack::dyed_cloths(scene);
}

}  // namespace aerostat::render

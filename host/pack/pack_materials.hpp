#pragma once

#include "material.h"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::pack {

/// Fills the device's table of materials, which has the order of scene::MaterialId.
void pack_materials(const scene::Scene& scene, AeroMaterial (&table)[AERO_MAX_MATERIALS]);

}  // namespace aerostat::pack

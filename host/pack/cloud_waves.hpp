#pragma once

#include <vector>

#include "scene_params.h"
#include "terrain/noise.hpp"

namespace aerostat::pack {

/// An octave of the clouds' noise over the plane (rules/cumulus.h).
struct CloudWave {
  terrain::NoiseLayer layer;
  float amplitude = 0.0f;
};

/// Returns the waves of fields and heaps of clouds, longest first.
std::vector<CloudWave> broad_waves(const AeroCumulus& clouds);

/// Returns the waves of the clouds' rags, longest first.
std::vector<CloudWave> rag_waves(const AeroCumulus& clouds);

/// Returns all waves of the clouds' coverage noise.
std::vector<CloudWave> all_waves(const AeroCumulus& clouds);

}  // namespace aerostat::pack

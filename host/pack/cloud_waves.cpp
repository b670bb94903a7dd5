#include "pack/cloud_waves.hpp"

#include <cmath>
#include <cstdint>

#include "rules/cumulus.h"

namespace aerostat::pack {
namespace {

/// Adds the octaves of an fBm, longest first.
void add_waves(const rules::Fbm& fbm, float amplitude, std::vector<CloudWave>& waves) {
  rules::Octave octave = rules::first_octave(fbm.wavelength);
  for (int i = 0; i < fbm.octaves; ++i) {
    const float length = 1.0f / std::hypot(octave.along, octave.across);
    const std::uint32_t seed = fbm.seed + static_cast<std::uint32_t>(i);
    waves.push_back({{octave.along, octave.across, 0.0f, 0.0f, length, seed}, amplitude});
    octave = rules::next_octave(octave);
    amplitude *= fbm.gain;
  }
}

}  // namespace

std::vector<CloudWave> broad_waves(const AeroCumulus& clouds) {
  std::vector<CloudWave> waves;
  add_waves(rules::cumulus_fields(clouds.size, clouds.seed), CUMULUS_FIELD_SHARE, waves);
  add_waves(rules::cumulus_heaps(clouds.size, clouds.seed), 1.0f, waves);
  return waves;
}

std::vector<CloudWave> rag_waves(const AeroCumulus& clouds) {
  std::vector<CloudWave> waves;
  add_waves(rules::cumulus_rags(clouds.size, clouds.seed), CUMULUS_RAG_SHARE, waves);
  return waves;
}

std::vector<CloudWave> all_waves(const AeroCumulus& clouds) {
  std::vector<CloudWave> waves = broad_waves(clouds);
  const std::vector<CloudWave> rags = rag_waves(clouds);
  waves.insert(waves.end(), rags.begin(), rags.end());
  return waves;
}

}  // namespace aerostat::pack

#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.hpp"

namespace aerostat::test {

/// Returns a scene file made at random from the whole schema. It has a few fields or many. Each
/// value is one of its bounds, right beside a bound, zero, or anywhere between, evenly or by
/// magnitude. The same seed gives the same text. Values are in their ranges, and fields that belong
/// together appear together. A few scenes are refused all the same, such as one whose camera stands
/// at its target.
std::string random_scene(std::uint32_t seed);

/// Returns the scene at a size that renders in a fraction of a second: few pixels, one sample, a
/// coarse land, and plants close by. The look of the scene and all places are kept.
scene::Scene made_quick(scene::Scene scene);

/// Returns the number of random scenes in a test: AEROSTAT_RANDOM_SCENES, or `usual` if it is not
/// set.
int random_scene_count(int usual);

/// Returns the seed of the first scene: AEROSTAT_RANDOM_SEED, or 1 if it is not set. Each further
/// scene has the next number, so a scene that fails can be made again alone.
std::uint32_t first_random_seed();

/// Prints the text of a scene and how to try it alone if this process crashes while the object
/// lives.
class CrashNote {
 public:
  CrashNote(std::uint32_t seed, const std::string& text);
  CrashNote(const CrashNote&) = delete;
  CrashNote& operator=(const CrashNote&) = delete;
  ~CrashNote();
};

}  // namespace aerostat::test

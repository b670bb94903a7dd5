#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.hpp"

namespace aerostat::test {

/// A scene file made at random from the whole schema: a few fields or many, each at one of its
/// bounds, right beside one, zero, or anywhere between, evenly or by magnitude. The same seed gives
/// the same text. Values are in their ranges and fields that belong together come together; a few
/// scenes are refused all the same, such as one whose camera stands at its target.
std::string random_scene(std::uint32_t seed);

/// The scene at a size that renders in a fraction of a second: few pixels, one sample, a coarse
/// land, plants close by. What it looks like and where everything stands is kept.
scene::Scene made_quick(scene::Scene scene);

/// How many random scenes a test looks at: AEROSTAT_RANDOM_SCENES, else `usual`.
int random_scene_count(int usual);

/// The seed of the first: AEROSTAT_RANDOM_SEED, else 1. Each further scene counts one up, so that
/// a scene that fails can be made again alone.
std::uint32_t first_random_seed();

/// While it lives, a crash of this process prints the scene's text and how to try it alone.
class CrashNote {
 public:
  CrashNote(std::uint32_t seed, const std::string& text);
  CrashNote(const CrashNote&) = delete;
  CrashNote& operator=(const CrashNote&) = delete;
  ~CrashNote();
};

}  // namespace aerostat::test

#pragma once

#include <map>

#include "pictures.hpp"

namespace aerostat::test {

inline constexpr Size kGoldenSize = {96, 64, 4, 256};

/// Returns the film of a scene at golden size. Each film is rendered once in a process.
inline const image::Film& small_film(const std::string& name) {
  static std::map<std::string, image::Film> films;
  const auto [at, missing] = films.try_emplace(name);
  if (missing) at->second = shared_session().render(resolved(planted_scene(name, kGoldenSize)));
  return at->second;
}

/// Returns a scene's name in the form that GoogleTest needs.
inline std::string scene_test_name(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

}  // namespace aerostat::test

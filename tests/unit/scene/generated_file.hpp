#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace aerostat::test {

inline std::string file_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Expects that a file of the sources, named from the root, has this text. With
/// AEROSTAT_UPDATE_DOCS in the environment, the file is written first.
inline void expect_generated(const std::string& name, const std::string& text) {
  const std::string path = std::string(AEROSTAT_SOURCE_DIR "/") + name;
  if (std::getenv("AEROSTAT_UPDATE_DOCS") != nullptr) std::ofstream(path) << text;
  EXPECT_EQ(file_text(path), text) << name << " is made from host/scene/*_fields.hpp. Renew it: "
                                   << "AEROSTAT_UPDATE_DOCS=1 ctest --preset dev -R Generated";
}

}  // namespace aerostat::test

#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace aerostat::test {

/// Returns the files of a folder of tests/fuzz/seeds, in the order of their names.
inline std::vector<std::string> seeds_of(const std::string& reader) {
  std::vector<std::filesystem::path> paths;
  const std::string folder = AEROSTAT_SOURCE_DIR "/tests/fuzz/seeds/" + reader;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

}  // namespace aerostat::test

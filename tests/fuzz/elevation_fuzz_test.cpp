// Tests that the readers of heights take any bytes: each seed of tests/fuzz/seeds is read, and
// damaged copies of it are read or refused. AEROSTAT_FUZZ_COUNT and AEROSTAT_FUZZ_SEED make the
// test longer. scripts/fuzz-elevation searches for faults with libFuzzer.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "elevation_readers.hpp"

namespace aerostat::test {
namespace {

using Content = std::vector<std::uint8_t>;

std::uint64_t variable(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

std::vector<Content> seeds_of(const std::string& reader) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(AEROSTAT_SOURCE_DIR "/tests/fuzz/seeds") / reader)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Content> seeds;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

/// Damages a file in one to six places.
class Damage {
 public:
  explicit Damage(std::uint32_t seed) : random_(seed) {}

  Content of(Content bytes) {
    for (std::size_t i = below(6) + 1; i > 0; --i) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

  /// Most of what can be damaged lies in the header.
  std::size_t place(const Content& bytes) {
    const std::size_t range =
        below(2) == 0 ? std::min<std::size_t>(bytes.size(), 200) : bytes.size();
    return below(range);
  }

  void change(Content& bytes) {
    constexpr std::array<std::uint8_t, 12> kBytes{0,   1,   255, 128, 127, ' ',
                                                  '-', '9', '.', 'e', '0', '\n'};
    if (bytes.empty()) return;
    const std::size_t at = place(bytes);
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const std::size_t length = std::min(below(9) + 1, bytes.size() - at);
    switch (below(6)) {
      case 0:
        *first = static_cast<std::uint8_t>(*first ^ 1u << below(8));
        break;
      case 1:
        std::fill_n(first, length, kBytes[below(kBytes.size())]);
        break;
      case 2:
        bytes.insert(first, length, kBytes[below(kBytes.size())]);
        break;
      case 3:
        bytes.erase(first, first + static_cast<std::ptrdiff_t>(length));
        break;
      case 4:
        bytes.resize(below(4) == 0 ? at : bytes.size() - length);
        break;
      default: {
        const Content piece(first, first + static_cast<std::ptrdiff_t>(length));
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(place(bytes)), piece.begin(),
                     piece.end());
      }
    }
  }

  std::mt19937 random_;
};

void keep(const Content& bytes) {
  std::ofstream("elevation-fuzz-last", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

TEST(ElevationFuzz, EachReaderHasSeedsThatItReads) {
  for (const ElevationReader& reader : elevation_readers()) {
    const std::vector<Content> seeds = seeds_of(reader.name);
    EXPECT_FALSE(seeds.empty()) << reader.name;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      EXPECT_NO_THROW(reader.read(seeds[i])) << reader.name << ", seed number " << i;
    }
  }
}

TEST(ElevationFuzz, DamagedFilesAreReadOrRefusedInWords) {
  const bool is_long = std::getenv("AEROSTAT_FUZZ_COUNT") != nullptr;
  const std::uint64_t count = variable("AEROSTAT_FUZZ_COUNT", 6000);
  const auto seed = static_cast<std::uint32_t>(variable("AEROSTAT_FUZZ_SEED", 1));
  for (const ElevationReader& reader : elevation_readers()) {
    Damage damage(seed);
    const std::vector<Content> seeds = seeds_of(reader.name);
    const std::uint64_t rounds = count / static_cast<std::uint64_t>(reader.cost);
    for (std::uint64_t i = 0; i < rounds && !seeds.empty(); ++i) {
      const Content bytes = damage.of(seeds[i % seeds.size()]);
      // In a long run, the bytes are kept in case the reader ends the process.
      if (is_long) keep(bytes);
      const std::string fault = fault_of(reader, bytes);
      if (!fault.empty()) keep(bytes);
      ASSERT_EQ(fault, "") << reader.name << ", seed " << seed << ", number " << i
                           << ", kept in elevation-fuzz-last";
    }
  }
}

}  // namespace
}  // namespace aerostat::test

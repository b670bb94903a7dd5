// Tests that the reader of scenes takes any bytes. It returns a scene that can be written and read
// again, or an error that says where the fault is. AEROSTAT_FUZZ_COUNT, _SECONDS and _SEED make the
// test longer.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mutate.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "take_scene.hpp"

namespace aerostat::test {
namespace {

std::optional<std::uint64_t> variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::nullopt : std::optional(std::strtoull(value, nullptr, 10));
}

/// Returns the scenes of the product, as they are and with every default filled in, and a scene
/// with the keys that none of them has.
std::vector<std::string> corpus() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(AEROSTAT_SOURCE_DIR "/scenes")) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().filename().string();
    if (name.find(".schema.") == std::string::npos) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts{
      R"({"version": 1, "sun": {"date": "2024-06-21", "time": "06:30+02:00", "latitude_deg": 46.5,
          "longitude_deg": 7.7}, "lights": [{"position": [1, 2, 3]}], "balloons": [{"gores": 8}],
          "materials": {"rim": {"albedo": [1, 0, 0]}}, "quality": "final"})"};
  for (const auto& path : paths) {
    std::ifstream file(path);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    texts.push_back(text);
    texts.push_back(scene::write_text(scene::read_text(text, path.string())));
  }
  return texts;
}

bool is_scene(const std::string& text) {
  try {
    scene::read_text(text, "fuzz.json");
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(SceneFuzz, AnyBytesAreReadOrRefusedInWords) {
  const auto seed = static_cast<std::uint32_t>(variable("AEROSTAT_FUZZ_SEED").value_or(1));
  const auto seconds = variable("AEROSTAT_FUZZ_SECONDS");
  const std::uint64_t count = variable("AEROSTAT_FUZZ_COUNT").value_or(seconds ? ~0ull : 4000);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds.value_or(0));
  Mutator mutator(corpus(), seed);
  std::uint64_t done = 0, good = 0;
  for (; done < count && (!seconds || std::chrono::steady_clock::now() < end); ++done) {
    const std::string text = mutator.next();
    std::vector<std::string> changes;
    if (done % 4 == 3) changes.push_back(mutator.next_override());
    // The text is kept in case the reader ends the process.
    if (seconds) std::ofstream("scene-fuzz-last.json", std::ios::binary) << text;
    const std::string fault = fault_of_scene(text, changes);
    if (fault.empty()) {
      good += is_scene(text) ? 1 : 0;
      continue;
    }
    std::ofstream("scene-fuzz-fault.json", std::ios::binary) << text;
    FAIL() << fault << "\nseed " << seed << ", number " << done << ", kept in scene-fuzz-fault.json"
           << (changes.empty() ? "" : ", --set " + changes[0]) << "\n"
           << text.substr(0, 2000);
  }
  std::printf("%llu texts, %llu of them scenes (seed %u)\n", static_cast<unsigned long long>(done),
              static_cast<unsigned long long>(good), seed);
  EXPECT_GT(good, done / 100) << "the changes leave too little to read";
  EXPECT_LT(good, done) << "no text was damaged";
}

}  // namespace
}  // namespace aerostat::test

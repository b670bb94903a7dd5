// The entry of libFuzzer for scenes and options --set. scripts/fuzz-inputs builds and runs it. The
// environment variable AEROSTAT_FUZZ_READER names what the bytes are taken for: scene or set.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "take_scene.hpp"

namespace {

/// The scene that the options --set are tried on.
constexpr const char* kScene =
    R"({"version": 1, "biome": "snow", "lights": [{"position": [1, 2, 3]}],
    "balloons": [{"gores": 8}], "objects": [{"file": "a.obj", "position": [1, 2, 3]}]})";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) c == '\n' ? void(lines.emplace_back()) : lines.back().push_back(c);
  return lines;
}

/// Each line is an option, because one option may undo or settle what another one set.
std::string fault_of(const std::string& reader, const std::string& text) {
  if (reader == "set") return aerostat::test::fault_of_scene(kScene, lines_of(text));
  if (reader == "scene") return aerostat::test::fault_of_scene(text, {});
  return "there is no reader " + reader;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const char* const reader = std::getenv("AEROSTAT_FUZZ_READER");
  const std::string fault =
      fault_of(reader == nullptr ? "" : reader, {reinterpret_cast<const char*>(data), size});
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

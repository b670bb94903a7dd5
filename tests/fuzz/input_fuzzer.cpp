// The entry of libFuzzer for scenes, options --set, checkpoints and pictures. scripts/fuzz-inputs
// builds and runs it. The environment variable AEROSTAT_FUZZ_READER names what the bytes are taken
// for: scene, set, checkpoint, or a reader of take_image.hpp.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "take_checkpoint.hpp"
#include "take_image.hpp"
#include "take_scene.hpp"

namespace {

/// The scene that the options --set are tried on.
constexpr const char* kScene =
    R"({"version": 1, "biome": "snow", "lights": [{"position": [1, 2, 3]}],
    "balloons": [{"gores": 8}], "objects": [{"file": "a.obj", "position": [1, 2, 3]}]})";

std::string fault_of(const std::string& reader, const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (reader == "set") return aerostat::test::fault_of_scene(kScene, {text});
  if (reader == "scene") return aerostat::test::fault_of_scene(text, {});
  bool is_read = false;
  for (const std::string& each : aerostat::test::image_readers()) {
    if (reader == each) return aerostat::test::fault_of_image(reader, {data, size}, is_read);
  }
  if (reader != "checkpoint") return "there is no reader " + reader;
  return aerostat::test::fault_of_checkpoint({data, size}, is_read);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const char* const reader = std::getenv("AEROSTAT_FUZZ_READER");
  const std::string fault = fault_of(reader == nullptr ? "" : reader, data, size);
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

// The entry of libFuzzer for checkpoints and pictures. scripts/fuzz-inputs builds and runs it. The
// environment variable AEROSTAT_FUZZ_READER names what the bytes are taken for: checkpoint, or a
// reader of take_image.hpp.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "take_checkpoint.hpp"
#include "take_image.hpp"

namespace {

std::string fault_of(const std::string& reader, const std::uint8_t* data, std::size_t size) {
  bool is_read = false;
  for (const std::string& each : aerostat::test::image_readers()) {
    if (reader == each) return aerostat::test::fault_of_image(reader, {data, size}, is_read);
  }
  if (reader != "checkpoint") return "there is no reader " + reader;
  return aerostat::test::fault_of_checkpoint({data, size}, is_read);
}

}  // namespace

/// Writes the seed of checkpoints into the first folder of the command line. It is no file of the
/// repository, because it has the layout of the structs of this build.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  const char* const reader = std::getenv("AEROSTAT_FUZZ_READER");
  if (reader == nullptr || std::string(reader) != "checkpoint") return 0;
  for (int i = 1; i < *count; ++i) {
    const std::filesystem::path folder = (*arguments)[i];
    if (!std::filesystem::is_directory(folder)) continue;
    std::ofstream(folder / "whole", std::ios::binary) << aerostat::test::whole_checkpoint();
    break;
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const char* const reader = std::getenv("AEROSTAT_FUZZ_READER");
  const std::string fault = fault_of(reader == nullptr ? "" : reader, data, size);
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

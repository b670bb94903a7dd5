// The entry of libFuzzer for the readers of models. scripts/fuzz-models builds and runs it. The
// environment variable AEROSTAT_FUZZ_READER names the reader.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "take_model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const char* const reader = std::getenv("AEROSTAT_FUZZ_READER");
  bool is_read = false;
  const std::string fault = aerostat::test::fault_of_model(
      reader == nullptr ? "" : reader, std::string_view(reinterpret_cast<const char*>(data), size),
      is_read);
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

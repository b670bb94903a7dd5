// The entry of libFuzzer for the readers of tracks. scripts/fuzz-tracks builds and runs it.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "take_track.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bool is_read = false;
  const std::string fault = aerostat::test::fault_of_track(
      std::string_view(reinterpret_cast<const char*>(data), size), is_read);
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

// The program of libFuzzer for the readers of files of heights. AEROSTAT_FUZZ_READER names the
// reader; scripts/fuzz-elevation builds and runs it.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "elevation_readers.hpp"

namespace {

const aerostat::test::ElevationReader& chosen_reader() {
  const char* name = std::getenv("AEROSTAT_FUZZ_READER");
  for (const auto& reader : aerostat::test::elevation_readers()) {
    if (name != nullptr && std::string(name) == reader.name) return reader;
  }
  std::fputs("AEROSTAT_FUZZ_READER must name one of:", stderr);
  for (const auto& reader : aerostat::test::elevation_readers()) {
    std::fprintf(stderr, " %s", reader.name);
  }
  std::fputs("\n", stderr);
  std::exit(64);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto& reader = chosen_reader();
  const std::string fault = aerostat::test::fault_of(reader, {data, size});
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

#include "film/program_mark.hpp"

#include <fmt/format.h>

#include "core/checksum.hpp"
#include "film/sources_hash.hpp"

namespace aerostat::film {

std::string program_mark(const opencl::SourceTree& kernels) {
  std::string all(sources_hash());
  for (const auto& [path, text] : kernels) all += fmt::format(" {} {:016x}", path, checksum(text));
  return fmt::format("{} {:016x}", AEROSTAT_VERSION, checksum(all));
}

}  // namespace aerostat::film

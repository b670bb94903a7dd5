#include "core/huge_pages.hpp"

#include <cstdint>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace aerostat {

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  // Less than a few pages is not worth the call.
  constexpr std::size_t kPage = std::size_t{2} << 20, kLeast = 2 * kPage;
  if (bytes < kLeast) return;
  auto* const begin = static_cast<std::byte*>(memory);
  const std::size_t skip = (kPage - reinterpret_cast<std::uintptr_t>(begin) % kPage) % kPage;
  // What the system answers does not matter: without large pages all works as before.
  static_cast<void>(madvise(begin + skip, (bytes - skip) / kPage * kPage, MADV_HUGEPAGE));
#endif
}

}  // namespace aerostat

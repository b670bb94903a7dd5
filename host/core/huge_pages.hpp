#pragma once

#include <cstddef>

namespace aerostat {

/// Asks the system to hold fresh memory, not yet touched, in large pages where it can: rays and
/// builders that jump about in many megabytes then seldom wait for a page's address. A hint; it
/// does nothing where the system has none.
void prefer_huge_pages(void* memory, std::size_t bytes);

}  // namespace aerostat

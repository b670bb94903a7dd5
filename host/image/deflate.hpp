#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace aerostat::image {

/// Returns `data` as a zlib stream (RFC 1950), compressed for speed. zlib compresses parts of 128
/// KiB on all cores. The result does not depend on the number of threads. Throws Error{internal}
/// if zlib fails.
std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> data);

}  // namespace aerostat::image

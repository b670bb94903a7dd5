#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace aerostat::image {

/// `data` as a zlib stream (RFC 1950 around RFC 1951). Made for speed: parts of 128 KiB are
/// compressed on all cores, with one look for each match and the fixed code. Never grows by more
/// than an eighth and some bytes; the result does not depend on the number of threads.
std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> data);

}  // namespace aerostat::image

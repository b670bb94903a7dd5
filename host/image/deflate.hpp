#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace aerostat::image {

/// Writes bytes `first` and on of what is to be compressed into `part`; called from all cores.
using FillPart = std::function<void(std::size_t first, std::span<std::uint8_t> part)>;

/// Appends `length` bytes that `fill` makes to `to` as a zlib stream (RFC 1950), compressed for
/// speed: parts of 128 KiB by zlib on all cores. The result does not depend on the number of
/// threads. Throws Error{internal} if zlib fails.
void append_deflated(std::vector<std::uint8_t>& to, std::size_t length, const FillPart& fill);

/// `data` as such a stream.
std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> data);

}  // namespace aerostat::image

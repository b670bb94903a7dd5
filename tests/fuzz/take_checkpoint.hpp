#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace aerostat::test {

/// Takes any bytes for a checkpoint of a small picture. Of bytes whose first one is odd, the others
/// are taken for the head of a checkpoint whose checksum is right, with pixels behind it. Returns a
/// description of a fault, or an empty string if everything was as promised. `is_read` becomes
/// whether the bytes were a checkpoint.
std::string fault_of_checkpoint(std::span<const std::uint8_t> bytes, bool& is_read);

/// Returns bytes for fault_of_checkpoint that are a checkpoint.
std::string whole_checkpoint();

}  // namespace aerostat::test

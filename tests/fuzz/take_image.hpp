#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace aerostat::test {

/// Returns the names of the readers: "png" and "jpeg" decode pictures, "artwork" takes pictures for
/// envelopes and looks through SVG drawings, "band" reads the files of `render --shard`, and "mark"
/// reads the marks of frames.
const std::vector<std::string>& image_readers();

/// Gives bytes to a reader. Returns a description of a fault, or an empty string if everything was
/// as promised. `is_read` tells whether the bytes were taken.
std::string fault_of_image(const std::string& reader, std::span<const std::uint8_t> bytes,
                           bool& is_read);

}  // namespace aerostat::test

#pragma once

#include <string>
#include <vector>

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::artwork {

/// Reads the pictures on the envelopes of the balloons that are there, each file once, and forgets
/// them. Returns a sentence about each: its name and its size, and what the reader has to say.
/// Throws the errors of read_picture() with the JSON pointer of the picture in front.
std::vector<std::string> check_pictures(const scene::Scene& scene);

}  // namespace aerostat::artwork

#pragma once

#include <cstdint>
#include <string>

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::film {

/// Returns a checksum of all that a scene says. The files that it names count by the last part of
/// their names and by their sizes, so that copies in other folders and on other machines count as
/// the same. A folder counts by the files in it.
std::uint64_t scene_checksum(scene::Scene scene);

/// Returns the mark of a still picture: what tells the program (see program_mark.hpp), and the
/// checksum of its scene. Throws Error{io} if the kernels cannot be read.
std::string still_mark(const scene::Scene& scene);

}  // namespace aerostat::film

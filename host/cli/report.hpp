#pragma once

#include <cstdint>
#include <string>

#include "image/film.hpp"
#include "render/session.hpp"

/// These functions describe the work of a render in words.
namespace aerostat::cli {

/// Returns the largest memory that the process has used so far, in bytes, as the system counts
/// it.
std::uint64_t peak_memory_bytes();

/// Returns the lines of --stats, each with a line end.
std::string stats_text(const render::Stats& stats, std::uint64_t peak_bytes);

/// The seconds that a render command spends outside of the session.
struct CommandSeconds {
  double reading = 0.0;  // reading the scene file
  double device = 0.0;   // finding the device
  double placing = 0.0;  // making the terrain's relief and placing objects above it
  double denoising = 0.0;
  double encoding = 0.0;  // turning the film into the file's format
  double writing = 0.0;
};

/// Returns one line of --stats.
std::string seconds_text(const CommandSeconds& seconds);

}  // namespace aerostat::cli

#pragma once

#include <cstdint>
#include <string>

#include "image/film.hpp"
#include "render/session.hpp"

/// What a render did, in words.
namespace aerostat::cli {

/// "1,234,567"
std::string grouped(std::uint64_t number);

/// The largest memory the process had in use so far, as the system counts it, in bytes.
std::uint64_t peak_memory_bytes();

/// The lines of --stats, each ended.
std::string stats_text(const render::Stats& stats, std::uint64_t peak_bytes);

/// Seconds of a render command outside of the session.
struct CommandSeconds {
  double reading = 0.0;   // the scene file
  double device = 0.0;    // finding it
  double placing = 0.0;   // the terrain's relief, and what stands above it
  double encoding = 0.0;  // from film to file format
  double writing = 0.0;
};

/// One line for --stats.
std::string seconds_text(const CommandSeconds& seconds);

}  // namespace aerostat::cli

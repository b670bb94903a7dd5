#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "track/track.hpp"

namespace aerostat::track {

/// What a user may say about a file of tracks.
struct ReadOptions {
  /// Which track of the file, counted from 0. By default it is the longest one.
  std::optional<std::size_t> index;
  /// The time of the first fix of a track that has no times of its own, in seconds since
  /// 1970-01-01 00:00 UTC. A track with times of day but no date takes the date from it.
  std::optional<double> start_s;
  /// The seconds from fix to fix of a track that has no times of its own. It needs `start_s`.
  std::optional<double> interval_s;
};

/// The number of bytes at the beginning of a file that are enough for format_of.
inline constexpr std::size_t kBytesForFormat = std::size_t{64} << 10;

/// Returns the format of a file of tracks by its content, or nothing if it is none. `beginning` is
/// the whole file or at least its first kBytesForFormat bytes.
std::optional<Format> format_of(std::string_view beginning);

/// Returns whether a file is one of tracks, by its content, or by its name if it is a zip file: KMZ
/// is KML in a zip file. Pipes are not opened.
bool is_track(const std::filesystem::path& path);

/// Reads a track, also from KMZ. `name` is the file's name for messages. Throws Error{bad_data}
/// that says what was found and what was expected if the bytes are no track, hold no fix, or pass a
/// limit, and Error{usage} if the options do not fit the file.
Track read_bytes(std::string_view bytes, const std::string& name, const ReadOptions& options = {});

/// Reads a track from a file. Throws what read_bytes throws, and Error{io} if the file cannot be
/// read.
Track read_file(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace aerostat::track

#include "track/read.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/reading.hpp"
#include "elevation/zip.hpp"
#include "track/distance.hpp"
#include "track/mend.hpp"
#include "track/raw.hpp"
#include "track/text.hpp"
#include "track/times.hpp"
#include "track/xml.hpp"

namespace aerostat::track {

namespace {

/// Steps that are longer than this do not count when tracks are compared, because a wrong fix would
/// decide.
constexpr double kLongestStep_m = 100e3;

double length_m(const RawTrack& track) {
  double length = 0.0;
  for (const Segment& segment : track.segments) {
    const Fix* last = nullptr;
    for (const Fix& fix : segment) {
      if (!is_usable(fix)) continue;
      const double step_m = last == nullptr ? 0.0 : distance_m(last->place, fix.place);
      if (step_m < kLongestStep_m) length += step_m;
      last = &fix;
    }
  }
  return length;
}

/// Returns the length by which tracks are compared. Of tracks of nearly the same length, such as a
/// flight and its shadow, the one with heights and times wins.
double rank_of(const RawTrack& track) {
  constexpr double kBonus = 0.02;
  bool has_heights = false, has_times = false;
  for (const Segment& segment : track.segments) {
    for (const Fix& fix : segment) {
      has_heights = has_heights || fix.gnss_m;
      has_times = has_times || fix.time_s;
    }
  }
  return length_m(track) * (1.0 + (has_heights ? kBonus : 0.0) + (has_times ? kBonus : 0.0));
}

bool has_fixes(const RawTrack& track) {
  return std::any_of(track.segments.begin(), track.segments.end(), [](const Segment& segment) {
    return std::any_of(segment.begin(), segment.end(), is_usable);
  });
}

/// Returns the track that the options name, or else the longest one, and says so if there are
/// several.
RawTrack chosen_track(RawFile& file, const ReadOptions& options) {
  auto& tracks = file.tracks;
  const auto is_empty = [](const RawTrack& track) { return !has_fixes(track); };
  tracks.erase(std::remove_if(tracks.begin(), tracks.end(), is_empty), tracks.end());
  if (tracks.empty()) {
    throw Error(ErrorKind::bad_data, "no fix with a usable place was found in the file");
  }
  if (options.index && *options.index >= tracks.size()) {
    throw Error(ErrorKind::usage,
                fmt::format("track {} does not exist; the file has {}", *options.index,
                            counted(tracks.size(), "track", "tracks")));
  }
  if (tracks.size() == 1) return std::move(tracks[0]);
  std::size_t best = options.index.value_or(0);
  double best_rank = rank_of(tracks[best]);
  for (std::size_t i = 0; !options.index && i < tracks.size(); ++i) {
    const double rank = rank_of(tracks[i]);
    if (rank > best_rank) best = i, best_rank = rank;
  }
  const std::string& name = tracks[best].name;
  file.notes.push_back(fmt::format(
      "The file has {}; number {} (counted from 0){} was taken, {:.1f} "
      "km long{}.",
      counted(tracks.size(), "track", "tracks"), best, name.empty() ? "" : ", '" + name + "',",
      length_m(tracks[best]) * 1e-3, options.index ? "" : ", the longest"));
  return std::move(tracks[best]);
}

void drop_empty_segments(std::vector<Segment>& segments) {
  const auto is_empty = [](const Segment& segment) { return segment.empty(); };
  segments.erase(std::remove_if(segments.begin(), segments.end(), is_empty), segments.end());
}

RawFile read_raw(Format format, std::string_view bytes) {
  switch (format) {
    case Format::gpx:
      return read_gpx(bytes);
    case Format::igc:
      return read_igc(bytes);
    case Format::kml:
      break;
  }
  return read_kml(bytes);
}

Track read_any(std::string_view bytes, const ReadOptions& options) {
  if (bytes.size() > kMostTrackBytes) {
    throw Error(ErrorKind::bad_data,
                fmt::format("the file has {} MiB; at most {} MiB of a track are read",
                            bytes.size() >> 20, kMostTrackBytes >> 20));
  }
  const auto format = format_of(bytes.substr(0, kBytesForFormat));
  if (!format) {
    throw Error(ErrorKind::bad_data,
                "this is no track; expected the content of a GPX, IGC, KML or "
                "KMZ file");
  }
  RawFile file = read_raw(*format, bytes);
  RawTrack raw = chosen_track(file, options);
  drop_empty_segments(raw.segments);
  Track track{*format,   raw.name,      std::move(raw.segments),
              raw.clock, raw.reference, std::move(file.notes)};
  track.notes.insert(track.notes.end(), raw.notes.begin(), raw.notes.end());
  settle_times(track, options);
  drop_absurd_heights(track);
  drop_zero_heights(track);
  return track;
}

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::string text_of(const std::filesystem::path& path) {
  const auto fail = [&](int code) {
    return Error(ErrorKind::io, fmt::format("{}: cannot read the track: {}", path.string(),
                                            std::generic_category().message(code)));
  };
  std::ifstream file(path, std::ios::binary);
  if (!file) throw fail(errno);
  std::string text;
  std::string chunk(std::size_t{1} << 20, '\0');
  // One byte more than the limit tells read_any that the file is too large.
  while (text.size() <= kMostTrackBytes) {
    file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk, 0, static_cast<std::size_t>(file.gcount()));
    if (file.bad() || (file.fail() && !file.eof())) throw fail(EIO);
    if (file.eof()) break;
  }
  return text;
}

}  // namespace

std::size_t Track::fix_count() const {
  std::size_t count = 0;
  for (const Segment& segment : segments) count += segment.size();
  return count;
}

const char* name_of(Format format) {
  return format == Format::gpx ? "GPX" : format == Format::igc ? "IGC" : "KML";
}

std::string_view without_mark(std::string_view bytes) {
  return bytes.substr(0, 3) == "\xef\xbb\xbf" ? bytes.substr(3) : bytes;
}

void require_few(std::size_t tracks) {
  if (tracks <= kMostTracks) return;
  throw Error(ErrorKind::bad_data, fmt::format("the file has more than {} tracks", kMostTracks));
}

void add_fix(RawTrack& track, const Fix& fix, std::size_t& count) {
  if (++count > kMostFixes) {
    throw Error(ErrorKind::bad_data, fmt::format("the file has more than {} fixes", kMostFixes));
  }
  track.segments.back().push_back(fix);
  Fix& added = track.segments.back().back();
  const bool is_place =
      std::abs(fix.place.latitude_deg) <= 90.0 && std::abs(fix.place.longitude_deg) <= 360.0;
  added.valid = added.valid && is_place;
  if (is_place) added.place.longitude_deg = wrapped(fix.place.longitude_deg);
}

std::optional<Format> format_of(std::string_view beginning) {
  const std::string_view text = trimmed(without_mark(beginning.substr(0, kBytesForFormat)));
  const bool may_be_xml = text.substr(0, 1) == "<" || text.substr(0, 2) == "\xff\xfe" ||
                          text.substr(0, 2) == "\xfe\xff" ||
                          text.substr(0, 1) == std::string_view("\0", 1);
  if (may_be_xml) {
    const std::string root = root_of(text);
    if (root == "gpx") return Format::gpx;
    return root == "kml" ? std::optional(Format::kml) : std::nullopt;
  }
  if (text.empty() || text[0] < 'A' || text[0] > 'Z') return std::nullopt;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    if (is_igc_fix(line) || line.substr(0, 5) == "HFDTE") return Format::igc;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return std::nullopt;
}

bool is_track(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string beginning(kBytesForFormat, '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(file.gcount()));
  if (is_zip(beginning)) return elevation::ending_of(path) == ".kmz";
  return format_of(beginning).has_value();
}

Track read_bytes(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  if (is_zip(bytes)) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    const auto kml = elevation::unpack_zip({first, bytes.size()}, name, ".kml", kMostTrackBytes);
    return read_bytes({reinterpret_cast<const char*>(kml.bytes.data()), kml.bytes.size()}, name,
                      options);
  }
  try {
    return read_any(bytes, options);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", name, error.what()));
  }
}

Track read_file(const std::filesystem::path& path, const ReadOptions& options) {
  return read_bytes(text_of(path), path.string(), options);
}

}  // namespace aerostat::track

#include "film/frames.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::film {
namespace {

/// Reads a whole number of at least 1. An empty text is `usual`.
std::optional<int> number_of(std::string_view text, int usual) {
  if (text.empty()) return usual;
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || number < 1) return std::nullopt;
  return number;
}

}  // namespace

FrameRange parse_frames(const std::string& text) {
  const auto refuse = [&text]() -> Error {
    return {ErrorKind::usage,
            fmt::format("--frames: found '{}', expected frames such as 17, 1-500, 1-500:2 or 100-",
                        text)};
  };
  std::string_view rest(text);
  FrameRange range;
  if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
    const auto step = number_of(rest.substr(colon + 1), 0);
    if (!step || *step < 1) throw refuse();
    range.step = *step;
    rest = rest.substr(0, colon);
  }
  const std::size_t dash = rest.find('-');
  if (dash == std::string_view::npos) {
    const auto one = number_of(rest, 0);
    if (!one || *one < 1) throw refuse();
    range.first = range.last = *one;
    return range;
  }
  const auto first = number_of(rest.substr(0, dash), 1), last = number_of(rest.substr(dash + 1), 0);
  if (!first || !last || rest.size() == 1) throw refuse();
  if (*last != 0 && *last < *first) throw refuse();
  range.first = *first;
  range.last = *last;
  return range;
}

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view whole(text);
  if (slash != std::string::npos && slash > 0 && slash + 1 < text.size()) {
    const auto index = number_of(whole.substr(0, slash), 0);
    const auto count = number_of(whole.substr(slash + 1), 0);
    if (index && count && *index <= *count) return {*index, *count};
  }
  throw Error(
      ErrorKind::usage,
      fmt::format("--shard: found '{}', expected a part such as 3/8, the third of eight", text));
}

std::vector<int> frames_of(const FrameRange& range, const Shard& shard, int film_frames) {
  const int last = range.last == 0 ? film_frames : std::min(range.last, film_frames);
  std::vector<int> frames;
  for (std::int64_t frame = range.first; frame <= last; frame += range.step) {
    frames.push_back(static_cast<int>(frame));
  }
  if (frames.empty()) {
    throw Error(ErrorKind::usage,
                fmt::format("--frames: the film has {} frames, and none from {} on", film_frames,
                            range.first));
  }
  const auto cut = [&](int part) {
    return static_cast<std::ptrdiff_t>(static_cast<std::int64_t>(frames.size()) * part /
                                       shard.count);
  };
  return {frames.begin() + cut(shard.index - 1), frames.begin() + cut(shard.index)};
}

FrameNames::FrameNames(const std::filesystem::path& pattern) : pattern_(pattern) {
  const std::string name = pattern.filename().string();
  const std::size_t first = name.find('#');
  const std::size_t end = std::min(name.find_first_not_of('#', first), name.size());
  if (first == std::string::npos || name.find('#', end) != std::string::npos) {
    throw Error(ErrorKind::usage,
                fmt::format("--output: found '{}', expected one run of # for the number of the "
                            "frame, such as frames/####.png",
                            pattern.string()));
  }
  before_ = name.substr(0, first);
  after_ = name.substr(end);
  digits_ = static_cast<int>(end - first);
}

std::filesystem::path FrameNames::name(int frame) const {
  return pattern_.parent_path() / fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

std::filesystem::path FrameNames::folder() const {
  const std::filesystem::path parent = pattern_.parent_path();
  return parent.empty() ? std::filesystem::path(".") : parent;
}

}  // namespace aerostat::film

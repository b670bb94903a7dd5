#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Which frames of a film are made, and the files that they stand in.
namespace aerostat::film {

/// A choice of frames, such as "1-500:2": from one frame to another by a step.
struct FrameRange {
  int first = 1, last = 0;  // last 0: the last frame of the film
  int step = 1;
};

/// Reads a range such as "17", "1-500", "1-500:2", "100-" or "-50". Throws Error{usage} if the text
/// is none.
FrameRange parse_frames(const std::string& text);

/// One of several equal parts of a film, counted from 1.
struct Shard {
  int index = 1, count = 1;
};

/// Reads a shard such as "3/8". Throws Error{usage} if the text is none.
Shard parse_shard(const std::string& text);

/// Returns the frames of a film that a range and a shard name, in rising order. Shards are runs of
/// neighbouring frames, whose lengths differ by one at most; together they are all frames of the
/// range, each once. Throws Error{usage} if the range has none of the film's frames.
std::vector<int> frames_of(const FrameRange& range, const Shard& shard, int film_frames);

/// The names of frames: a pattern whose one run of '#' stands for the number of the frame, with
/// zeros before it.
class FrameNames {
 public:
  /// Throws Error{usage} if the file name of the pattern has no '#', or more than one run of them.
  explicit FrameNames(const std::filesystem::path& pattern);

  std::filesystem::path name(int frame) const;
  std::filesystem::path folder() const;
  const std::filesystem::path& pattern() const { return pattern_; }

 private:
  std::filesystem::path pattern_;
  std::string before_, after_;
  int digits_ = 1;
};

}  // namespace aerostat::film

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "film/timeline.hpp"
#include "image/write.hpp"

/// The files of frames, and whether they are those of a film.
namespace aerostat::film {

enum class FrameFormat { png, exr };

/// Whether a frame's file can be kept.
enum class FrameState {
  kept,     // it is whole, and it was made from the same scene by the same program
  missing,  // there is no file
  broken,   // the file is damaged or no picture
  foreign   // it was made from another scene or size, in another quality or by another version
};

/// The marks of a film's frames. A mark tells the program (see program_mark.hpp) and what a frame
/// is made from: its scene with size and quality, those of its moments, the scenes by whose light
/// it is exposed, and the names and sizes of the files that they name.
class FrameMarks {
 public:
  /// Throws Error{io} if the kernels cannot be read.
  FrameMarks(Timeline& timeline, FrameFormat format);

  std::string mark_of(int frame);

 private:
  std::uint64_t checksum_of(int moment);

  Timeline& timeline_;
  FrameFormat format_;
  std::string program_;
  std::map<int, std::uint64_t> moments_;
};

/// Reads a frame's file and tells whether it has this mark. Throws Error{io} if a file that is
/// there cannot be read.
FrameState state_of(const std::filesystem::path& file, const std::string& mark, FrameFormat format);

/// Returns the picture of a PNG frame. Throws Error{io} and Error{bad_data} with the file's name.
image::Pixels pixels_of(const std::filesystem::path& file);

/// Returns the bytes of a file. Throws Error{io} with its name.
std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file);

}  // namespace aerostat::film

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Films are encoded by the program ffmpeg, which runs as a child of this one.
namespace aerostat::film {

/// What a film is encoded as.
struct EncoderOptions {
  std::filesystem::path output;  // .mp4, .mov, .mkv or .webm
  std::string codec;             // a name of codec_names(), or empty: what suits the output
  int width = 0, height = 0;
  double fps = 25.0;
};

/// Returns "h264", "av1", "prores" and "lossless".
const std::vector<std::string>& codec_names();

/// Returns whether a name ends as one of a film does.
bool is_film_file(const std::filesystem::path& file);

/// Throws Error{usage} if the codec does not go into the kind of file, or if it cannot have frames
/// of this size.
void require_encodable(const EncoderOptions& options);

/// Returns the arguments of ffmpeg that make `file` from raw frames on its standard input.
std::vector<std::string> ffmpeg_arguments(const EncoderOptions& options,
                                          const std::filesystem::path& file);

/// A running ffmpeg that takes frames. The film is written beside its place and moved there when it
/// is finished, so that it stands there whole or not at all.
class Encoder {
 public:
  /// Throws Error{no_device} with what to install if there is no ffmpeg.
  explicit Encoder(const EncoderOptions& options);
  /// Ends ffmpeg and removes what it wrote, unless the film is finished.
  ~Encoder();
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  /// Gives ffmpeg a frame: 8-bit RGB, row by row. Throws Error{io} with ffmpeg's own words if it
  /// has ended.
  void add(std::span<const std::uint8_t> rgb);

  /// Waits for ffmpeg and puts the film into its place. Throws Error{io} with ffmpeg's own words.
  void finish();

 private:
  [[noreturn]] void fail(int code);
  int wait();

  EncoderOptions options_;
  std::filesystem::path temporary_;
  int child_ = -1, input_ = -1, words_ = -1;
};

}  // namespace aerostat::film

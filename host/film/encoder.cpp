#include "film/encoder.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"

extern char** environ;

namespace aerostat::film {
namespace {

namespace fs = std::filesystem;

/// How a codec is asked for, and the kinds of files that it goes into.
struct Codec {
  const char* name;
  std::vector<std::string> arguments;
  std::vector<std::string> endings;
  bool has_half_colors;  // colours have half the resolution, so sides must be even
  bool is_rgb;
  int least_side = 2;  // the smallest width and height that the encoder takes
};

/// Qualities are chosen by eye: gradients of the sky show no steps.
const std::vector<Codec>& codecs() {
  static const std::vector<Codec> all{
      {"h264",
       {"-c:v", "libx264", "-preset", "medium", "-crf", "17", "-pix_fmt", "yuv420p"},
       {".mp4", ".mov", ".mkv"},
       true,
       false},
      {"av1",
       {"-c:v", "libsvtav1", "-preset", "6", "-crf", "24", "-pix_fmt", "yuv420p10le"},
       {".mp4", ".mkv", ".webm"},
       true,
       false,
       64},
      {"prores",
       {"-c:v", "prores_ks", "-profile:v", "3", "-vendor", "apl0", "-pix_fmt", "yuv422p10le"},
       {".mov", ".mkv"},
       true,
       false},
      {"lossless", {"-c:v", "ffv1", "-level", "3", "-pix_fmt", "bgr0"}, {".mkv"}, false, true, 1},
  };
  return all;
}

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

bool goes_into(const Codec& codec, const std::string& ending) {
  return std::find(codec.endings.begin(), codec.endings.end(), ending) != codec.endings.end();
}

/// Returns the codec of a name, or the first one that goes into the file.
const Codec& codec_of(const EncoderOptions& options) {
  const std::string ending = ending_of(options.output);
  for (const Codec& codec : codecs()) {
    if (options.codec.empty() ? goes_into(codec, ending) : options.codec == codec.name) {
      return codec;
    }
  }
  throw Error(ErrorKind::usage, fmt::format("--output: a film is a .mp4, .mov, .mkv or .webm, not "
                                            "'{}'",
                                            options.output.string()));
}

/// Returns ffmpeg's name of a kind of file.
const char* format_of(const std::string& ending) {
  if (ending == ".mov") return "mov";
  if (ending == ".mkv") return "matroska";
  return ending == ".webm" ? "webm" : "mp4";
}

/// Names the file as those of core/file.hpp that are not finished, so that what a killed process
/// leaves behind is removed by the next one.
fs::path temporary_of(const fs::path& output) {
  const fs::path folder = output.parent_path().empty() ? fs::path(".") : output.parent_path();
  return folder / fmt::format(".aerostat-{}-film.tmp", ::getpid());
}

/// Starts ffmpeg. It does not belong to the terminal's group of this process, so that Ctrl-C
/// reaches this process alone.
int start(std::vector<std::string> command, int input, int words) {
  std::vector<char*> pointers;
  for (std::string& text : command) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, words, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t usual, none;
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  sigemptyset(&none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  pid_t child = -1;
  const int code = posix_spawnp(&child, "ffmpeg", &actions, &attributes, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (code == 0) return child;
  throw Error(ErrorKind::no_device,
              fmt::format("no film can be encoded, because the program ffmpeg cannot be run ({}); "
                          "install it (Debian and Ubuntu: apt install ffmpeg) and run the same "
                          "command again, which keeps the frames",
                          std::strerror(code)));
}

/// Returns the last lines of what ffmpeg wrote, in one line.
std::string last_words(int file) {
  constexpr off_t kMost = 600;
  const off_t size = ::lseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, kMost)), '\0');
  const ssize_t got = ::pread(file, text.data(), text.size(), std::max<off_t>(size - kMost, 0));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::string line;
  for (const char c : text) c == '\n' ? void(line += "; ") : line.push_back(c);
  return line;
}

}  // namespace

const std::vector<std::string>& codec_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Codec& codec : codecs()) all.emplace_back(codec.name);
    return all;
  }();
  return names;
}

bool is_film_file(const fs::path& file) {
  const std::string ending = ending_of(file);
  return std::any_of(codecs().begin(), codecs().end(),
                     [&](const Codec& codec) { return goes_into(codec, ending); });
}

void require_encodable(const EncoderOptions& options) {
  const Codec& codec = codec_of(options);
  const std::string ending = ending_of(options.output);
  if (!goes_into(codec, ending)) {
    std::string endings;
    for (const std::string& one : codec.endings) endings += (endings.empty() ? "" : ", ") + one;
    throw Error(ErrorKind::usage, fmt::format("--codec: {} goes into {}, not into '{}'", codec.name,
                                              endings, options.output.string()));
  }
  if (std::min(options.width, options.height) < codec.least_side) {
    throw Error(ErrorKind::usage,
                fmt::format("--codec: {} needs sides of {} pixels or more, found "
                            "{} x {}",
                            codec.name, codec.least_side, options.width, options.height));
  }
  const bool is_odd = options.width % 2 != 0 || options.height % 2 != 0;
  if (!codec.has_half_colors || !is_odd) return;
  throw Error(ErrorKind::usage,
              fmt::format("--codec: {} needs even sides, found {} x {}; choose them by --width and "
                          "--height, or take --codec lossless and a .mkv",
                          codec.name, options.width, options.height));
}

std::vector<std::string> ffmpeg_arguments(const EncoderOptions& options, const fs::path& file) {
  const Codec& codec = codec_of(options);
  const std::string ending = ending_of(options.output);
  std::vector<std::string> command{"ffmpeg", "-hide_banner", "-loglevel",
                                   "error",  "-nostdin",     "-y"};
  const auto add = [&command](const std::vector<std::string>& more) {
    command.insert(command.end(), more.begin(), more.end());
  };
  add({"-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
       fmt::format("{}x{}", options.width, options.height), "-framerate",
       fmt::format("{}", options.fps), "-i", "-", "-an"});
  // Frames have the full range of RGB. Films have the limited range of Y'CbCr, by the matrix of
  // BT.709, and say so.
  if (!codec.is_rgb) {
    // Some encoders take their tags from the frames and others from the options further below.
    add({"-vf",
         "scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=accurate_rnd,"
         "setparams=range=tv:color_primaries=bt709:color_trc=bt709:colorspace=bt709"});
  }
  add(codec.arguments);
  add({"-color_primaries", "bt709", "-color_trc", "bt709"});
  if (codec.is_rgb) {
    add({"-colorspace", "rgb", "-color_range", "pc"});
  } else {
    add({"-colorspace", "bt709", "-color_range", "tv"});
  }
  if (ending == ".mp4" || ending == ".mov") add({"-movflags", "+faststart"});
  add({"-f", format_of(ending), file.string()});
  return command;
}

Encoder::Encoder(const EncoderOptions& options)
    : options_(options), temporary_(temporary_of(options.output)) {
  std::array<int, 2> pipe{};
  words_ = ::memfd_create("ffmpeg", MFD_CLOEXEC);
  if (words_ < 0 || ::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    throw Error(ErrorKind::exhausted, fmt::format("cannot prepare to run ffmpeg: {}",
                                                  std::generic_category().message(errno)));
  }
  input_ = pipe[1];
  try {
    child_ = start(ffmpeg_arguments(options_, temporary_), pipe[0], words_);
  } catch (...) {
    for (const int file : {pipe[0], pipe[1], words_}) ::close(file);
    throw;
  }
  ::close(pipe[0]);
}

Encoder::~Encoder() {
  if (input_ >= 0) ::close(input_);
  if (child_ > 0) {
    ::kill(child_, SIGKILL);
    wait();
  }
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
  ::close(words_);
}

/// Waits for ffmpeg to end. Returns its exit code, or 128 and the number of a signal.
int Encoder::wait() {
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void Encoder::fail(int code) {
  throw Error(ErrorKind::io, fmt::format("ffmpeg could not make '{}' (exit code {}): {}",
                                         options_.output.string(), code, last_words(words_)));
}

void Encoder::add(std::span<const std::uint8_t> rgb) {
  while (!rgb.empty()) {
    const ssize_t written = ::write(input_, rgb.data(), rgb.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      ::close(std::exchange(input_, -1));
      fail(wait());
    }
    rgb = rgb.subspan(static_cast<std::size_t>(written));
  }
}

void Encoder::finish() {
  ::close(std::exchange(input_, -1));
  const int code = wait();
  if (code != 0) fail(code);
  std::error_code error;
  fs::rename(temporary_, options_.output, error);
  if (error) {
    throw Error(ErrorKind::io,
                fmt::format("cannot write '{}': {}", options_.output.string(), error.message()));
  }
  temporary_.clear();
}

}  // namespace aerostat::film

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/parse.hpp"
#include "cli/picture.hpp"
#include "cli/progress_bar.hpp"
#include "cli/progress_text.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "film/contact.hpp"
#include "film/encoding.hpp"
#include "film/frame_files.hpp"
#include "film/frame_maker.hpp"
#include "film/frames.hpp"
#include "film/timeline.hpp"
#include "image/write.hpp"
#include "render/scene_cache.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {

namespace {

namespace fs = std::filesystem;
using film::FrameFormat;
using film::FrameState;

constexpr int kPreviewWidth = 480;

/// What a film is written to.
struct Outputs {
  fs::path video;  // empty: only frames
  film::FrameNames names;
  fs::path sheet;  // of the contact sheet; empty: none
  FrameFormat format = FrameFormat::png;
};

Outputs outputs_of(const FilmOptions& options) {
  const fs::path given =
      options.output.empty() ? default_picture(options.input.scene, ".mp4") : options.output;
  if (is_standard(given)) {
    throw Error(ErrorKind::usage, "--output: a film does not go to standard output; give a name");
  }
  if (film::is_film_file(given)) {
    fs::path stem = given;
    stem.replace_extension();
    const std::string folder = stem.string() + (options.preview ? ".preview-frames" : ".frames");
    return {given, film::FrameNames(fs::path(folder) / "#####.png"), stem.string() + "-sheet.png",
            FrameFormat::png};
  }
  const std::string ending = given.extension().string();
  if (ending != ".png" && ending != ".exr") {
    throw Error(ErrorKind::usage,
                fmt::format("--output: a film is a .mp4, .mov, .mkv or .webm, or frames such as "
                            "frames/####.png or frames/####.exr, not '{}'",
                            given.string()));
  }
  const bool is_png = ending == ".png";
  film::FrameNames names(given);
  const fs::path sheet = is_png ? names.folder() / "contact-sheet.png" : fs::path();
  return {{}, std::move(names), sheet, is_png ? FrameFormat::png : FrameFormat::exr};
}

/// Returns the scene with all options applied.
scene::SceneSource source_of(const FilmOptions& options) {
  SceneOptions input = options.input;
  auto& changes = input.overrides;
  if (!options.quality.empty()) changes.push_back("/quality=" + options.quality);
  if (options.width) changes.push_back(fmt::format("/image/width={}", *options.width));
  if (options.height) changes.push_back(fmt::format("/image/height={}", *options.height));
  scene::SceneSource source = read_source(input);
  if (!options.preview) return source;
  const scene::Image& image = source.scene().image;
  const int width = std::min(kPreviewWidth, image.width);
  // Films want even sides.
  const int height = std::max(2, image.height * width / image.width / 2 * 2);
  return source.with({{"/quality", "draft"},
                      {"/image/width", std::to_string(width)},
                      {"/image/height", std::to_string(height)},
                      {"/image/spp", "1"},
                      {"/image/adaptive_threshold", "0"},
                      {"/sun/soft_shadows", "false"},
                      {"/sky/ambient_occlusion", "false"}});
}

const char* word_of(FrameState state) {
  switch (state) {
    case FrameState::missing:
      return "missing";
    case FrameState::broken:
      return "broken";
    case FrameState::foreign:
      return "foreign";
    case FrameState::kept:
      break;
  }
  return "kept";
}

/// A frame of the film, its mark, and what its file holds.
struct Frame {
  int number = 1;
  std::string mark;
  FrameState state = FrameState::missing;
};

std::vector<Frame> survey(film::Timeline& timeline, const Outputs& outputs,
                          const std::vector<int>& numbers, const std::stop_token& stop) {
  film::FrameMarks marks(timeline, outputs.format);
  std::vector<Frame> frames;
  for (const int number : numbers) {
    stop_if_asked(stop);
    Frame frame{number, marks.mark_of(number), FrameState::missing};
    frame.state = film::state_of(outputs.names.name(number), frame.mark, outputs.format);
    frames.push_back(std::move(frame));
  }
  return frames;
}

int count_of(const std::vector<Frame>& frames, FrameState state) {
  return static_cast<int>(std::count_if(
      frames.begin(), frames.end(), [state](const Frame& frame) { return frame.state == state; }));
}

/// Prints the frames that are not as they should be, and returns the exit code.
int verify(const std::vector<Frame>& frames, const Outputs& outputs, bool is_quiet) {
  std::string lines;
  for (const Frame& frame : frames) {
    if (frame.state == FrameState::kept) continue;
    lines += fmt::format("{} {} {}\n", word_of(frame.state), frame.number,
                         outputs.names.name(frame.number).string());
  }
  write_stdout(lines);
  const int good = count_of(frames, FrameState::kept);
  if (!is_quiet) {
    print_stderr(fmt::format("{} of {} frames are there: {} missing, {} broken, {} foreign\n", good,
                             frames.size(), count_of(frames, FrameState::missing),
                             count_of(frames, FrameState::broken),
                             count_of(frames, FrameState::foreign)));
  }
  return good == static_cast<int>(frames.size()) ? 0 : static_cast<int>(ErrorKind::bad_data);
}

/// Says which files are not kept, and why.
void tell_remade(const std::vector<Frame>& frames) {
  if (const int foreign = count_of(frames, FrameState::foreign); foreign > 0) {
    warn(
        fmt::format("{} frames were made from another scene, size or quality, or by another "
                    "version; they are made anew",
                    foreign));
  }
  if (const int broken = count_of(frames, FrameState::broken); broken > 0) {
    warn(fmt::format("{} files of frames are damaged; they are made anew", broken));
  }
}

/// Makes the frames that are missing, and shows the progress.
class FrameRun {
 public:
  FrameRun(film::FrameMaker& maker, const Outputs& outputs, ProgressBar& bar,
           const std::stop_token& stop)
      : maker_(maker), outputs_(outputs), bar_(bar), stop_(stop) {}

  /// Makes frames until they are done or the limit of time is reached, but at least one, so that
  /// repeated calls come to an end. The limit 0 is none. Tells
  /// `encoding`, which may be null, of each frame that is there. Returns the number of frames made.
  int run(const std::vector<Frame>& frames, film::Encoding* encoding, double limit_s) {
    to_make_ = static_cast<int>(frames.size()) - count_of(frames, FrameState::kept);
    for (const Frame& frame : frames) {
      if (frame.state != FrameState::kept) {
        if (limit_s > 0.0 && made_ > 0 && watch_.seconds() >= limit_s) break;
        make(frame);
      }
      if (encoding != nullptr) encoding->add(frame.number);
    }
    return made_;
  }

  int left() const { return to_make_ - made_; }

 private:
  void make(const Frame& frame) {
    const auto bytes =
        maker_.make(frame.number, frame.mark, stop_,
                    [&](const render::Progress& progress) { show(frame, progress); });
    stop_if_asked(stop_);
    write_file(outputs_.names.name(frame.number), bytes);
    ++made_;
    // The first frame compiles kernels and builds the land, so the rate is that of the others.
    if (made_ == 1) first_made_s_ = watch_.seconds();
  }

  void show(const Frame& frame, render::Progress progress) {
    const bool is_compiling = progress.stage == render::Stage::kernels;
    const double part = progress.stage >= render::Stage::rays ? progress.fraction : 0.0;
    const double seconds = watch_.seconds();
    bar_.set_label(is_compiling ? "" : label(frame, seconds));
    if (!is_compiling) {
      progress = {render::Stage::rays, (made_ + std::min(part, 0.999)) / to_make_, 0, seconds, 0};
    }
    progress.seconds = seconds;
    bar_.update(progress);
  }

  std::string label(const Frame& frame, double seconds) const {
    const double since = seconds - first_made_s_;
    const std::string rate =
        made_ > 1 ? fmt::format(", {:.2f} frames/s", (made_ - 1) / since) : std::string();
    return fmt::format("frame {}, {} of {}{}", frame.number, made_ + 1, to_make_, rate);
  }

  film::FrameMaker& maker_;
  const Outputs& outputs_;
  ProgressBar& bar_;
  std::stop_token stop_;
  Stopwatch watch_;
  double first_made_s_ = 0.0;
  int made_ = 0, to_make_ = 0;
};

void make_folder(const film::FrameNames& names) {
  std::error_code error;
  fs::create_directories(names.folder(), error);
  if (error) {
    throw Error(ErrorKind::io, fmt::format("cannot make the folder '{}': {}",
                                           names.folder().string(), error.message()));
  }
  require_writable(names.name(1));
}

/// Begins to encode, if a film is asked for. Without ffmpeg, the frames are made nevertheless, and
/// `failure` receives the error for the end.
std::unique_ptr<film::Encoding> begin_encoding(const film::EncoderOptions& options,
                                               const Outputs& outputs,
                                               const std::vector<int>& numbers,
                                               std::optional<Error>& failure) {
  if (options.output.empty()) return nullptr;
  try {
    return std::make_unique<film::Encoding>(options, outputs.names, numbers);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_device) throw;
    warn(error.what());
    failure = error;
    return nullptr;
  }
}

film::EncoderOptions encoder_options(const FilmOptions& options, const Outputs& outputs,
                                     const scene::Scene& scene) {
  film::EncoderOptions encoder{outputs.video, options.codec, scene.image.width, scene.image.height,
                               scene.film.fps / options.frames.step};
  if (outputs.video.empty()) return encoder;
  film::require_encodable(encoder);
  if (options.shard.count > 1) {
    // The film needs the frames of all shards.
    encoder.output.clear();
  } else {
    output_file(outputs.video, options.input, true);
  }
  return encoder;
}

std::string summary(const Outputs& outputs, std::size_t frames, int made, double seconds) {
  const fs::path what = outputs.video.empty() ? outputs.names.pattern() : outputs.video;
  return fmt::format("wrote {} ({} frames: {} rendered, {} kept) in {}", what.string(), frames,
                     made, static_cast<int>(frames) - made, duration_text(seconds));
}

}  // namespace

int make_film(const FilmOptions& options) {
  const Stopwatch watch;
  Outputs outputs = outputs_of(options);
  const Interrupt interrupt;
  ProgressBar bar(stderr_style(options.quiet), print_stderr);
  const WarningsAbove warnings(bar, options.quiet);

  const auto cache = std::make_shared<render::SceneCache>();
  const scene::SceneSource source = source_of(options);
  film::Timeline timeline(source, cache->reliefs);
  for (const std::string& note : timeline.notes()) warn(note);
  const std::vector<int> numbers =
      film::frames_of(options.frames, options.shard, timeline.frames());
  const film::EncoderOptions encoder = encoder_options(options, outputs, source.scene());
  if (options.shard.count > 1) outputs.video.clear();
  std::vector<Frame> frames = survey(timeline, outputs, numbers, interrupt.token());
  if (options.verify) return verify(frames, outputs, options.quiet);

  make_folder(outputs.names);
  tell_remade(frames);
  std::optional<Error> failure;
  const auto encoding = begin_encoding(encoder, outputs, numbers, failure);
  render::Options session = session_options_of(
      options.device, self_test_of(source.scene().light, interrupt.token(), bar));
  session.cache = cache;
  film::FrameMaker maker(timeline, session, outputs.format);
  FrameRun run(maker, outputs, bar, interrupt.token());
  const int made = run.run(frames, encoding.get(), options.time_limit_s);
  if (run.left() > 0) {
    bar.clear();
    throw Error(ErrorKind::exhausted,
                fmt::format("the time limit of {} is over with {} frames made and {} left; the "
                            "same command goes on",
                            duration_text(options.time_limit_s), made, run.left()));
  }
  if (encoding) {
    bar.set_label("encoding");
    encoding->finish();
  }
  bar.clear();
  if (!outputs.sheet.empty() && options.shard.count == 1) {
    write_file(outputs.sheet,
               image::encode_png(film::contact_sheet(outputs.names, film::sheet_frames(numbers))));
  }
  if (failure) throw *failure;
  if (!options.quiet) bar.message(summary(outputs, frames.size(), made, watch.seconds()));
  return 0;
}

}  // namespace aerostat::cli

#include "film/film_run.hpp"

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/file.hpp"
#include "core/log.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "film/contact.hpp"
#include "film/encoding.hpp"
#include "film/frame_maker.hpp"
#include "image/write.hpp"
#include "scene/scene.hpp"

namespace aerostat::film {
namespace {

namespace fs = std::filesystem;

constexpr int kPreviewWidth = 480;

void make_folder(const FrameNames& names) {
  std::error_code error;
  fs::create_directories(names.folder(), error);
  if (error) {
    throw Error(ErrorKind::io, fmt::format("cannot make the folder '{}': {}",
                                           names.folder().string(), error.message()));
  }
  require_writable(names.name(1));
}

/// Begins to encode, if a film is asked for. Without ffmpeg, `failure` receives the error.
std::unique_ptr<Encoding> begin_encoding(const FilmTask& task, const std::vector<Frame>& frames,
                                         std::optional<Error>& failure) {
  if (task.encoder.output.empty()) return nullptr;
  std::vector<int> numbers;
  for (const Frame& frame : frames) numbers.push_back(frame.number);
  try {
    return std::make_unique<Encoding>(task.encoder, task.files.names, std::move(numbers));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_device) throw;
    warn(error.what());
    failure = error;
    return nullptr;
  }
}

/// Makes the frames that are missing.
class FrameRun {
 public:
  FrameRun(FrameMaker& maker, const FilmTask& task, std::stop_token stop,
           std::function<void(const FilmProgress&)> show)
      : maker_(maker), task_(task), stop_(std::move(stop)), show_(std::move(show)) {}

  /// Makes frames until they are done or the limit of time is reached. Tells `encoding`, which may
  /// be null, of each frame that is there.
  void run(const std::vector<Frame>& frames, Encoding* encoding) {
    now_.to_make = static_cast<int>(frames.size()) - count_of(frames, FrameState::kept);
    for (const Frame& frame : frames) {
      if (frame.state != FrameState::kept) {
        const bool is_late = task_.time_limit_s > 0.0 && watch_.seconds() >= task_.time_limit_s;
        if (is_late && now_.made > 0) break;
        make(frame);
      }
      if (encoding != nullptr) encoding->add(frame.number);
    }
  }

  const FilmProgress& now() const { return now_; }

  void show(int number, const render::Progress& progress) {
    now_.number = number;
    now_.render = progress;
    now_.seconds = watch_.seconds();
    if (now_.made > 1) {
      now_.frames_per_s = (now_.made - 1) / std::max(now_.seconds - first_made_s_, 1e-9);
    }
    show_(now_);
  }

 private:
  void make(const Frame& frame) {
    const auto bytes =
        maker_.make(frame.number, frame.mark, stop_,
                    [&](const render::Progress& progress) { show(frame.number, progress); });
    stop_if_asked(stop_);
    write_file(task_.files.names.name(frame.number), bytes);
    ++now_.made;
    // The first frame compiles kernels and builds the land, so the rate is that of the others.
    if (now_.made == 1) first_made_s_ = watch_.seconds();
  }

  FrameMaker& maker_;
  const FilmTask& task_;
  std::stop_token stop_;
  std::function<void(const FilmProgress&)> show_;
  Stopwatch watch_;
  FilmProgress now_;
  double first_made_s_ = 0.0;
};

void write_sheet(const FilmTask& task, const std::vector<Frame>& frames) {
  if (task.files.sheet.empty() || !task.has_sheet) return;
  std::vector<int> numbers;
  for (const Frame& frame : frames) numbers.push_back(frame.number);
  write_file(task.files.sheet,
             image::encode_png(contact_sheet(task.files.names, sheet_frames(numbers))));
}

}  // namespace

FilmFiles film_files(const fs::path& output, bool is_preview) {
  if (is_film_file(output)) {
    fs::path stem = output;
    stem.replace_extension();
    const std::string folder = stem.string() + (is_preview ? ".preview-frames" : ".frames");
    return {output, FrameNames(fs::path(folder) / "#####.png"), stem.string() + "-sheet.png",
            FrameFormat::png};
  }
  const std::string ending = output.extension().string();
  if (ending != ".png" && ending != ".exr") {
    throw Error(ErrorKind::usage,
                fmt::format("a film is a .mp4, .mov, .mkv or .webm, or frames such as "
                            "frames/####.png or frames/####.exr, not '{}'",
                            output.string()));
  }
  const bool is_png = ending == ".png";
  FrameNames names(output);
  const fs::path sheet = is_png ? names.folder() / "contact-sheet.png" : fs::path();
  return {{}, std::move(names), sheet, is_png ? FrameFormat::png : FrameFormat::exr};
}

scene::SceneSource preview_of(const scene::SceneSource& source) {
  const scene::Image& image = source.scene().image;
  const int width = std::min(kPreviewWidth, image.width);
  // Films want even sides.
  const int height = std::max(2, image.height * width / image.width / 2 * 2);
  return source.with({{"/quality", "draft"},
                      {"/image/width", std::to_string(width)},
                      {"/image/height", std::to_string(height)},
                      {"/image/spp", "1"},
                      {"/image/adaptive_threshold", "0"},
                      {"/film/shutter_angle_deg", "0"},
                      {"/sun/soft_shadows", "false"},
                      {"/sky/ambient_occlusion", "false"}});
}

std::vector<Frame> survey(Timeline& timeline, const FilmFiles& files,
                          const std::vector<int>& numbers, const std::stop_token& stop) {
  FrameMarks marks(timeline, files.format);
  std::vector<Frame> frames;
  for (const int number : numbers) {
    stop_if_asked(stop);
    Frame frame{number, marks.mark_of(number), FrameState::missing};
    frame.state = state_of(files.names.name(number), frame.mark, files.format);
    frames.push_back(std::move(frame));
  }
  return frames;
}

int count_of(const std::vector<Frame>& frames, FrameState state) {
  return static_cast<int>(std::count_if(
      frames.begin(), frames.end(), [state](const Frame& frame) { return frame.state == state; }));
}

double FilmProgress::fraction() const {
  if (to_make == 0) return 1.0;
  const double part = render.stage >= render::Stage::rays ? render.fraction : 0.0;
  return std::min(1.0, (made + std::min(part, 0.999)) / to_make);
}

FilmOutcome make_film(Timeline& timeline, const render::Options& options, const FilmTask& task,
                      const std::vector<Frame>& frames, const std::stop_token& stop,
                      const std::function<void(const FilmProgress&)>& show) {
  make_folder(task.files.names);
  FilmOutcome outcome;
  const auto encoding = begin_encoding(task, frames, outcome.no_encoder);
  FrameMaker maker(timeline, options, task.files.format);
  FrameRun run(maker, task, stop, show);
  run.run(frames, encoding.get());
  outcome.made = run.now().made;
  outcome.left = run.now().to_make - outcome.made;
  if (outcome.left > 0) return outcome;
  if (encoding) {
    run.show(0, {});
    encoding->finish();
  }
  write_sheet(task, frames);
  return outcome;
}

}  // namespace aerostat::film

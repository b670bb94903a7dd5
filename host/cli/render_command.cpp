#include <cstdio>
#include <map>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/parse.hpp"
#include "cli/progress_bar.hpp"
#include "cli/report.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/stopwatch.hpp"
#include "image/write.hpp"
#include "opencl/device.hpp"
#include "render/session.hpp"
#include "world/world.hpp"

namespace aerostat::cli {

namespace {

namespace fs = std::filesystem;

void print_stderr(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

/// Lets the library's warnings pass above the bar while it lives; none if quiet.
class WarningsAbove {
 public:
  WarningsAbove(ProgressBar& bar, bool quiet)
      : former_(set_log_sink(quiet ? LogSink() : LogSink([&bar](const std::string& message) {
          bar.message("aerostat: " + message);
        }))) {}
  ~WarningsAbove() { set_log_sink(std::move(former_)); }
  WarningsAbove(const WarningsAbove&) = delete;
  WarningsAbove& operator=(const WarningsAbove&) = delete;

 private:
  LogSink former_;
};

/// Not resolved yet.
scene::Scene scene_to_render(const RenderOptions& options) {
  SceneOptions input = options.input;
  // Options win over --set.
  if (!options.quality.empty()) input.overrides.push_back("/quality=" + options.quality);
  scene::Scene scene = read_scene(input);
  if (options.width) scene.image.width = *options.width;
  if (options.height) scene.image.height = *options.height;
  if (options.spp) scene.image.spp = *options.spp;
  if (options.seed) scene.image.seed = *options.seed;
  if (options.crop) require_inside(*options.crop, scene.image.width, scene.image.height);
  return scene;
}

void require_encodable(const RenderOptions& options, const scene::Image& image,
                       PictureFormat format) {
  const int width = options.crop ? options.crop->x1 - options.crop->x0 : image.width;
  const int height = options.crop ? options.crop->y1 - options.crop->y0 : image.height;
  if (format == PictureFormat::exr || image::png_can_hold(width, height)) return;
  throw Error(ErrorKind::usage,
              fmt::format("{} x {} pixels are too many for a PNG; write an .exr or take a --crop",
                          width, height));
}

std::vector<std::uint8_t> encode(const image::Film& film, PictureFormat format,
                                 const scene::Image& image) {
  if (format == PictureFormat::exr) return image::encode_exr(film);
  const double ev = image.exposure_given ? image.exposure_ev : image::automatic_exposure_ev(film);
  return image::encode_png(image::develop(film, ev));
}

void warn_of_nan(const image::Film& film) {
  if (film.nan_pixels == 0) return;
  warn(fmt::format("{} pixels came out as no number and were set to black", film.nan_pixels));
}

/// Each name once, with how many devices bear it.
std::string names_of(const std::vector<opencl::Device>& devices) {
  std::map<std::string, int> counts;
  for (const opencl::Device& device : devices) ++counts[device.name];
  std::string text;
  for (const auto& [name, count] : counts) {
    if (!text.empty()) text += " and ";
    text += count == 1 ? name : fmt::format("{} x {}", count, name);
  }
  return text;
}

std::string summary(const fs::path& output, const image::Film& film, int spp,
                    const std::vector<opencl::Device>& devices, double seconds) {
  return fmt::format("wrote {} ({} x {}, {} spp) in {:.1f} s on {}", output.string(), film.width,
                     film.height, spp, seconds, names_of(devices));
}

}  // namespace

int render(const RenderOptions& options) {
  const Stopwatch watch;
  const fs::path output =
      options.output.empty() ? default_picture(options.input.scene) : options.output;
  const PictureFormat format = picture_format(output);
  image::require_writable(output);
  const Interrupt interrupt;
  ProgressBar bar(stderr_style(options.quiet), print_stderr);
  const WarningsAbove warnings(bar, options.quiet);

  CommandSeconds seconds;
  Stopwatch phase;
  scene::Scene scene = scene_to_render(options);
  seconds.reading = phase.restart();
  require_encodable(options, scene.image, format);
  const auto devices = opencl::select_devices(opencl::effective_selector(options.device));
  render::Session session({devices, options.lanes, options.memory_limit_bytes, 0});
  seconds.device = phase.restart();
  session.begin_kernels();
  world::resolve(scene);
  seconds.placing = phase.seconds();
  const image::Film film = session.render(
      scene, interrupt.token(), [&bar](const render::Progress& progress) { bar.update(progress); },
      options.crop);
  bar.clear();
  warn_of_nan(film);
  phase.restart();
  const auto bytes = encode(film, format, scene.image);
  seconds.encoding = phase.restart();
  if (interrupt.token().stop_requested()) throw Error(ErrorKind::interrupted, "interrupted");
  image::write_file(output, bytes);
  seconds.writing = phase.seconds();

  if (!options.quiet) {
    bar.message(summary(output, film, scene.image.spp, devices, watch.seconds()));
  }
  if (options.stats) {
    print_stderr(stats_text(session.stats(), peak_memory_bytes()) + seconds_text(seconds));
  }
  return 0;
}

}  // namespace aerostat::cli

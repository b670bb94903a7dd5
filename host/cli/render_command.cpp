#include <future>
#include <optional>

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "cli/band_file.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/label_files.hpp"
#include "cli/long_render.hpp"
#include "cli/parse.hpp"
#include "cli/picture.hpp"
#include "cli/progress_bar.hpp"
#include "cli/progress_text.hpp"
#include "cli/report.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "denoise/denoise.hpp"
#include "image/pixel_filter.hpp"
#include "image/write.hpp"
#include "map/map_view.hpp"
#include "map/own_grid.hpp"
#include "render/scene_cache.hpp"
#include "render/session.hpp"
#include "render/settings.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {

namespace {

namespace fs = std::filesystem;

bool is_map(const RenderOptions& options, PictureFormat format) {
  return format == PictureFormat::geotiff || options.world_file;
}

/// Returns the unresolved scene with all options applied. A band becomes a crop.
scene::Scene scene_to_render(RenderOptions& options, PictureFormat format,
                             world::ReliefCache& reliefs) {
  SceneOptions input = options.input;
  // Options win over --set.
  if (!options.quality.empty()) input.overrides.emplace_back("/quality=" + options.quality);
  scene::Scene scene =
      read_scene(input, reliefs, is_map(options, format) ? Staging::map : Staging::view);
  if (options.width) scene.image.width = *options.width;
  if (options.height) scene.image.height = *options.height;
  if (options.spp) scene.image.spp = *options.spp;
  if (options.seed) scene.image.seed = *options.seed;
  if (options.shard) {
    options.crop = band_crop(*options.shard, scene.image.width, scene.image.height);
  }
  if (options.crop) require_inside(*options.crop, scene.image.width, scene.image.height);
  return scene;
}

/// Throws an Error if the picture could not be finished, before work is done for nothing.
void require_encodable(const RenderOptions& options, const scene::Image& image,
                       PictureFormat format) {
  if (options.denoise) denoise::require_library();
  const int width = options.crop ? options.crop->x1 - options.crop->x0 : image.width;
  const int height = options.crop ? options.crop->y1 - options.crop->y0 : image.height;
  if (format != PictureFormat::png || image::png_can_hold(width, height)) return;
  throw Error(ErrorKind::usage,
              fmt::format("{} x {} pixels are too many for a PNG; write an .exr or take a --crop",
                          width, height));
}

/// Where a map lies, and the grid of its elevation data that it is written in.
struct MapFile {
  map::MapView view;
  map::OwnGrid grid;
};

/// Returns where the map lies, or nothing if the file is no map.
std::optional<MapFile> map_file(const RenderOptions& options, PictureFormat format,
                                const scene::ResolvedScene& scene, world::ReliefCache& reliefs) {
  if (format != PictureFormat::geotiff) return std::nullopt;
  const render::Crop part =
      options.crop.value_or(render::Crop{0, 0, scene->image.width, scene->image.height});
  MapFile file;
  file.view = map::map_view(scene, {part.x0, part.y0}, "--output");
  file.grid =
      map::own_grid(scene, file.view, part.x1 - part.x0, part.y1 - part.y0, "--output", reliefs);
  return file;
}

std::vector<std::uint8_t> encode(const image::Film& film, PictureFormat format,
                                 const scene::Scene& scene, bool is_band,
                                 const std::optional<MapFile>& map) {
  if (is_band) return encode_band(film, scene);
  if (format == PictureFormat::exr) return image::encode_exr(film);
  const image::Pixels pixels = develop(film, scene.image);
  if (!map) return image::encode_png(pixels);
  return map::encode_geotiff(map::in_own_grid(pixels, map->view, map->grid),
                             map->grid.georeference);
}

struct Opened {
  std::unique_ptr<render::Session> session;
  std::vector<opencl::Device> devices;
  double seconds = 0.0;  // time that finding the devices took
};

/// Returns what the film of the file holds.
render::Contents contents_of(const RenderOptions& options, PictureFormat format) {
  // Bands are joined to pictures of both formats.
  if (options.shard) return render::Contents::everything;
  return format == PictureFormat::exr ? render::Contents::layers : render::Contents::picture;
}

bool has_guides(const RenderOptions& options, PictureFormat format) {
  return format == PictureFormat::exr || options.denoise;
}

/// Opens a session, which begins to load or compile its kernels.
Opened open_session(const RenderOptions& options, PictureFormat format,
                    const render::SelfTest& test,
                    const std::shared_ptr<render::SceneCache>& cache) {
  const Stopwatch watch;
  render::Options session_options = session_options_of(options.device, test);
  session_options.cache = cache;
  session_options.contents = contents_of(options, format);
  session_options.guides = has_guides(options, format);
  session_options.filtered = !options.denoise;
  Opened opened{std::make_unique<render::Session>(session_options), session_options.devices,
                watch.seconds()};
  opened.session->begin_kernels(test.integrator);
  return opened;
}

/// Takes the noise out of a film whose pixels are not filtered yet, and filters them.
void denoise_pixels(image::Film& film, scene::Filter filter, const std::stop_token& stop) {
  denoise::denoise(film, {.stop = stop});
  image::filter_pixels(film, render::side_weight_of(filter));
}

/// Keeps the session until the process ends. The system then frees all of its memory at once,
/// which saves some 40 ms. The destructor, and with it the driver's compiler, would free the
/// memory in small pieces.
void keep_to_the_end(std::unique_ptr<render::Session> session) {
  // A leak checker looks for the pointer, which a compiler would leave out if it were not marked as
  // used.
  [[gnu::used]] static const render::Session* const kept = session.release();
}

/// Returns the samples per pixel in words.
std::string samples_text(const LongRender& course, const RenderOptions& options, int spp) {
  if (course.missing().empty()) return fmt::format("{} spp", spp);
  if (options.time_limit_s <= 0.0) return course.missing();
  return fmt::format("{} in the time limit of {}", course.missing(),
                     duration_text(options.time_limit_s));
}

/// Returns a line about the picture.
std::string summary(const fs::path& output, const image::Film& film, const std::string& samples,
                    const std::vector<opencl::Device>& devices, double seconds) {
  return fmt::format("wrote {} ({} x {}, {}) in {:.1f} s on {}", name_of_output(output), film.width,
                     film.height, samples, seconds, names_of(devices));
}

fs::path name_of_picture(const RenderOptions& options) {
  return options.output.empty() ? default_picture(options.input.scene) : options.output;
}

/// Returns the format of the picture's file. Throws Error{usage} for a band in another format.
PictureFormat format_of(const RenderOptions& options) {
  const PictureFormat format = picture_format(name_of_picture(options), options.format);
  require_band(options, format);
  return format;
}

/// Starts oneTBB before drivers are loaded in another thread. Otherwise the libraries that it
/// loads, and the requests of its new threads to the loader, would wait for the drivers.
void start_threads() {
  tbb::parallel_for(0, tbb::this_task_arena::max_concurrency(), [](int) {});
}

void print_stats(const render::Session& session, const CommandSeconds& seconds) {
  print_stderr(stats_text(session.stats(), peak_memory_bytes()) + seconds_text(seconds));
}

}  // namespace

int render(RenderOptions options) {
  const Stopwatch watch;
  const PictureFormat format = format_of(options);
  const fs::path output = output_file(name_of_picture(options), options.input, true);
  LabelFiles labels(options, output, format);
  Interrupt interrupt;
  ProgressBar bar(stderr_style(options.quiet), print_stderr);
  const WarningsAbove warnings(bar, options.quiet);
  LongRender course(options, output, interrupt, bar, watch);

  CommandSeconds seconds;
  Stopwatch phase;
  const auto cache = std::make_shared<render::SceneCache>();
  const scene::Scene scene = scene_to_render(options, format, cache->reliefs);
  if (options.shard && is_kept_band(output, scene, *options.crop, options.quiet)) return 0;
  seconds.reading = phase.restart();
  require_encodable(options, scene.image, format);
  start_threads();
  // Drivers are loaded while the ground is laid out.
  const render::SelfTest test = self_test_of(scene.light, interrupt.token(), bar);
  auto opening =
      std::async(std::launch::async, [&] { return open_session(options, format, test, cache); });
  const scene::ResolvedScene resolved = resolve_scene(scene, options.input, cache->reliefs);
  labels.find(resolved, cache->reliefs);
  const std::optional<MapFile> map = map_file(options, format, resolved, cache->reliefs);
  seconds.placing = phase.seconds();
  Opened opened = opening.get();
  seconds.device = opened.seconds;
  image::Film film = course.render(*opened.session, resolved, contents_of(options, format),
                                   has_guides(options, format));
  bar.clear();
  warn_of_nan(film);
  phase.restart();
  if (options.denoise) denoise_pixels(film, scene.image.filter, course.token());
  seconds.denoising = phase.restart();
  const auto bytes = encode(film, format, scene, options.shard.has_value(), map);
  seconds.encoding = phase.restart();
  stop_if_asked(course.token());
  write_file(output, bytes);
  labels.write(film, bytes);
  seconds.writing = phase.seconds();
  if (!options.quiet) {
    const std::string samples = samples_text(course, options, scene.image.spp);
    bar.message(summary(output, film, samples, opened.devices, watch.seconds()));
  }
  if (options.stats) print_stats(*opened.session, seconds);
  keep_to_the_end(std::move(opened.session));
  course.finish(name_of_output(output));
  return 0;
}

}  // namespace aerostat::cli

#include "render/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <future>
#include <mutex>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "opencl/launch.hpp"
#include "pack/pack_scene.hpp"
#include "render/abandonable.hpp"
#include "render/film_buffer.hpp"
#include "render/geometry.hpp"
#include "render/programs.hpp"
#include "render/tiles.hpp"

namespace aerostat::render {
namespace {

// One launch of the three kernels takes about this long, and two are in flight: a watchdog never
// fires, and an interrupt is answered in time.
constexpr double kLaunchSeconds = 0.03;
constexpr std::uint64_t kFirstLaunchSamples = 1u << 15;
constexpr std::uint64_t kMostLaunchSamples = 1u << 20;
constexpr std::size_t kLaunchesInFlight = 2;

/// The commands of one tile, and how many rays they stand for.
struct Launch {
  cl::Event camera, shadow, shade;
  std::uint64_t samples = 0;
};

/// Every sample that met something has sent one ray to each light that casts shadows.
std::uint64_t shadow_rays_of(const image::Film& film, const scene::Scene& scene, int samples) {
  std::uint64_t hits = 0;
  for (const float alpha : film.alpha) {
    hits += static_cast<std::uint64_t>(std::lround(alpha * static_cast<float>(samples)));
  }
  const auto lamps = std::count_if(scene.lights.begin(), scene.lights.end(),
                                   [](const scene::PointLight& light) { return light.shadows; });
  return hits * (static_cast<std::uint64_t>(lamps) + (scene.sun.shadows ? 1 : 0));
}

}  // namespace

struct Session::State {
  State(Options given)
      : options(std::move(given)),
        lanes(options.lanes != 0 ? options.lanes : options.device.lanes),
        context(options.device),
        budget(options.memory_limit_bytes != 0 ? options.memory_limit_bytes
                                               : options.device.memory_bytes) {}

  void prepare(const scene::Scene& scene);
  void begin_programs();
  void await_programs();
  image::Film trace(const scene::Scene& scene, const Crop& crop);
  void trace_pass(AeroLaunch& launch, const Crop& crop, const PacketShape& shape);
  void enqueue_tile(const AeroLaunch& launch);
  void retire(bool all);
  void report(Stage stage, double fraction);
  image::Film read_passes(const scene::Scene& scene, const Crop& crop);
  void publish(image::Film read);
  void finish(const scene::Scene& scene, const Crop& crop);
  void stop_if_asked() const;
  std::uint64_t samples_per_launch() const;

  Options options;
  int lanes;
  opencl::Context context;
  opencl::MemoryBudget budget;
  std::optional<Programs> programs;
  std::future<Programs> programs_to_come;         // outlives a render that is given up
  std::shared_ptr<const HostGeometry> geometry;   // the newest that was built
  std::shared_ptr<const HostGeometry> on_device;  // what `device` holds
  std::shared_ptr<FrameArrays> frame = std::make_shared<FrameArrays>();
  DeviceGeometry device;
  opencl::Buffer<AeroScene> scene_buffer;
  opencl::Buffer<AeroFilmPixel> film;
  opencl::RawBuffer hits, visible;
  std::uint64_t packets_capacity = 0;

  std::stop_token stop;
  ProgressCallback progress;
  Stopwatch watch, since_report;
  Stats stats;
  std::deque<Launch> in_flight;
  std::uint64_t samples_total = 0, samples_done = 0;
  int passes_done = 0;  // samples per pixel
  double rate = 0.0;    // samples per second, smoothed

  mutable std::mutex snapshot_mutex;
  image::Film latest;
  std::function<image::Film()> finished;  // reads the film of a render that came to its end
  AbandonableWork background;
};

void Session::State::stop_if_asked() const {
  if (stop.stop_requested()) throw Error(ErrorKind::interrupted, "interrupted");
}

void Session::State::report(Stage stage, double fraction) {
  since_report.restart();
  if (!progress) return;
  progress({stage, fraction, stats.primary_rays + stats.shadow_rays, watch.seconds(), passes_done});
}

void Session::State::begin_programs() {
  if (programs || programs_to_come.valid()) return;
  programs_to_come =
      std::async(std::launch::async, [this] { return build_programs(context, lanes); });
}

/// A driver's compiler knows no interruption: a render that is stopped leaves it at work for the
/// next one.
void Session::State::await_programs() {
  if (programs) return;
  do {
    stop_if_asked();
    report(Stage::kernels, 0.0);
  } while (programs_to_come.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready);
  programs = programs_to_come.get();
  stats.programs_built = 3;
  stats.kernel_seconds = programs->seconds;
}

/// Everything before the first ray: world, trees, kernels, buffers, as far as they are not there.
void Session::State::prepare(const scene::Scene& scene) {
  report(Stage::world, 0.0);
  begin_programs();
  const auto old = geometry;
  const auto fresh =
      background.run([scene, old] { return build_geometry(scene, old.get(), Meshes::release); },
                     stop, [this] { report(Stage::world, 0.0); });
  geometry = fresh;
  stats.worlds_built = fresh->worlds_built;
  stats.trees_built = fresh->trees_built;
  stats.world_seconds = fresh->world_seconds;
  stats.tree_seconds = fresh->tree_seconds;
  await_programs();
  stop_if_asked();
  report(Stage::upload, 0.0);
  const Stopwatch upload_watch;
  if (!on_device || fresh->land != on_device->land || fresh->balloon != on_device->balloon) {
    on_device = nullptr;
    device = {};
    const auto tree = background.run([fresh] { return join_trees(*fresh); }, stop,
                                     [this] { report(Stage::upload, 0.0); });
    frame->assemble(*fresh);
    device = upload(context, budget, tree, frame, [this] { stop_if_asked(); });
  }
  on_device = fresh;
  const AeroScene packed = pack::pack_scene(scene);
  scene_buffer = {context, budget, std::span(&packed, 1), "the scene"};
  const auto pixels =
      static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height);
  if (film.size() != pixels) {
    film = {};
    film = {context, budget, pixels, "the film"};
  }
  stats.upload_seconds = upload_watch.seconds();
}

std::uint64_t Session::State::samples_per_launch() const {
  if (options.tile_pixels > 0) return static_cast<std::uint64_t>(options.tile_pixels);
  if (rate <= 0.0) return kFirstLaunchSamples;
  return std::clamp(static_cast<std::uint64_t>(rate * kLaunchSeconds), kFirstLaunchSamples / 16,
                    kMostLaunchSamples);
}

void Session::State::enqueue_tile(const AeroLaunch& launch) {
  const std::uint64_t packets = launch.tile.block_count;
  const auto lane_count = static_cast<std::uint64_t>(lanes);
  if (packets > packets_capacity) {
    retire(true);
    hits = {};
    visible = {};
    // A hit is four words per lane, the lights that reach it one.
    hits = {context, budget, packets * lane_count * 16, "the hits", CL_MEM_READ_WRITE};
    visible = {context, budget, packets * lane_count * 4, "the shadows", CL_MEM_READ_WRITE};
    packets_capacity = packets;
  }
  const opencl::LaunchSize size = packet_range(packets, lanes);
  Launch work;
  work.samples = packets * lane_count;
  work.camera = opencl::launch(context, programs->trace_camera_rays, size, launch, device.nodes,
                               device.triangles, device.grid, hits.handle());
  work.shadow = opencl::launch(context, programs->trace_shadow_rays, size, launch, scene_buffer,
                               device.nodes, device.triangles, device.grid, device.faces,
                               device.vertices, hits.handle(), visible.handle());
  work.shade =
      opencl::launch(context, programs->shade_hits, size, launch, scene_buffer, device.grid,
                     device.faces, device.vertices, hits.handle(), visible.handle(), film);
  in_flight.push_back(work);
}

/// Waits for the oldest launch, or for all, and counts what they did.
void Session::State::retire(bool all) {
  while (in_flight.size() >= (all ? 1 : kLaunchesInFlight)) {
    const Launch work = in_flight.front();
    in_flight.pop_front();
    const double shade = opencl::device_seconds(work.shade);
    const double camera = opencl::device_seconds(work.camera);
    const double shadow = opencl::device_seconds(work.shadow);
    stats.shade_device_seconds += shade;
    stats.primary_device_seconds += camera;
    stats.shadow_device_seconds += shadow;
    samples_done += work.samples;
    // By the device's clock: the host's tells nothing when several launches end while it sleeps.
    const double spent = camera + shadow + shade;
    if (spent > 0.0) {
      const double now_rate = static_cast<double>(work.samples) / spent;
      rate = rate <= 0.0 ? now_rate : 0.7 * rate + 0.3 * now_rate;
    }
    report(Stage::rays,
           std::min(1.0, static_cast<double>(samples_done) / static_cast<double>(samples_total)));
  }
}

void Session::State::trace_pass(AeroLaunch& launch, const Crop& crop, const PacketShape& shape) {
  Tiles tiles(crop, shape, launch.tile.first_sample);
  while (!tiles.done()) {
    stop_if_asked();
    launch.tile = tiles.next(samples_per_launch() / static_cast<std::uint64_t>(lanes));
    enqueue_tile(launch);
    const auto pixels = static_cast<std::uint64_t>(launch.tile.x1 - launch.tile.x0) *
                        (launch.tile.y1 - launch.tile.y0);
    stats.primary_rays += pixels << shape.log2_samples;
    retire(false);
  }
  retire(true);
}

image::Film Session::State::trace(const scene::Scene& scene, const Crop& crop) {
  const Stopwatch rays_watch;
  AeroLaunch launch{};
  launch.frame = pack::pack_frame(scene);
  opencl::launch(context, programs->clear_film, packet_range(film.size(), 1), film,
                 static_cast<cl_uint>(film.size()));
  const auto pixels =
      static_cast<std::uint64_t>(crop.x1 - crop.x0) * static_cast<std::uint64_t>(crop.y1 - crop.y0);
  samples_total = pixels * static_cast<std::uint64_t>(scene.image.spp);
  samples_done = 0;
  passes_done = 0;
  while (passes_done < scene.image.spp) {
    // A long render shows something early; samples are added in their order all the same, so every
    // bit stays what it was.
    const bool first_look = passes_done == 0 && scene.image.spp > lanes;
    const PacketShape shape = packet_shape(lanes, first_look ? 1 : scene.image.spp - passes_done);
    launch.tile.first_sample = static_cast<cl_uint>(passes_done);
    trace_pass(launch, crop, shape);
    passes_done += 1 << shape.log2_samples;
    if (passes_done < scene.image.spp) publish(read_passes(scene, crop));
  }
  image::Film read = read_passes(scene, crop);
  finish(scene, crop);
  stats.rays_seconds = rays_watch.seconds();
  return read;
}

image::Film Session::State::read_passes(const scene::Scene& scene, const Crop& crop) {
  image::Film read = read_film(film, scene.image.width, crop, passes_done);
  stats.shadow_rays = shadow_rays_of(read, scene, passes_done);
  return read;
}

void Session::State::publish(image::Film read) {
  const std::lock_guard lock(snapshot_mutex);
  latest = std::move(read);
}

/// The whole film goes to the caller; for a snapshot it is read again from the device, where it
/// stays until the next render.
void Session::State::finish(const scene::Scene& scene, const Crop& crop) {
  const std::lock_guard lock(snapshot_mutex);
  latest = {};
  finished = [this, width = scene.image.width, crop, samples = passes_done] {
    return read_film(film, width, crop, samples);
  };
}

namespace {

Crop checked_crop(const scene::Scene& scene, const std::optional<Crop>& crop) {
  const Crop all{0, 0, scene.image.width, scene.image.height};
  if (!crop) return all;
  if (crop->x0 < 0 || crop->y0 < 0 || crop->x1 > all.x1 || crop->y1 > all.y1 ||
      crop->x0 >= crop->x1 || crop->y0 >= crop->y1) {
    throw Error(ErrorKind::usage,
                fmt::format("crop {},{},{},{} is not inside the image of {} x {} pixels", crop->x0,
                            crop->y0, crop->x1, crop->y1, all.x1, all.y1));
  }
  return *crop;
}

}  // namespace

Session::Session(Options options) : state_(std::make_unique<State>(std::move(options))) {}

Session::~Session() = default;

void Session::begin_kernels() {
  state_->begin_programs();
}

image::Film Session::render(const scene::Scene& scene, std::stop_token stop,
                            const ProgressCallback& progress, std::optional<Crop> crop) {
  State& state = *state_;
  const Crop area = checked_crop(scene, crop);
  state.stop = std::move(stop);
  state.progress = progress;
  state.stats = {};
  state.watch.restart();
  state.in_flight.clear();
  {
    const std::lock_guard lock(state.snapshot_mutex);
    state.latest = {};
    state.finished = nullptr;
  }
  state.prepare(scene);
  state.stats.triangles = state.device.triangle_count();
  state.stats.tree = state.device.tree;
  image::Film film = state.trace(scene, area);
  state.stats.device_bytes = state.budget.used();
  state.report(Stage::done, 1.0);
  return film;
}

image::Film Session::snapshot() const {
  const std::lock_guard lock(state_->snapshot_mutex);
  return state_->finished ? state_->finished() : state_->latest;
}

const Stats& Session::stats() const {
  return state_->stats;
}

}  // namespace aerostat::render

#include "render/session.hpp"

#include <algorithm>
#include <functional>
#include <future>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "image/tone.hpp"
#include "image/write.hpp"
#include "pack/daylight.hpp"
#include "pack/pack_scene.hpp"
#include "render/abandonable.hpp"
#include "render/device_team.hpp"
#include "render/metering.hpp"
#include "render/passes.hpp"
#include "render/scene_cache.hpp"
#include "render/test_hooks.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {
namespace {

/// Returns the number of shadow rays: each hit sends one to each light that casts shadows.
std::uint64_t shadow_rays_of(std::uint64_t hits, const scene::Scene& scene) {
  const auto lamps = std::count_if(scene.lights.begin(), scene.lights.end(),
                                   [](const scene::PointLight& light) { return light.shadows; });
  return hits * (static_cast<std::uint64_t>(lamps) + (scene.sun.shadows ? 1 : 0));
}

/// Returns the noise at which pixels count as converged. A display shows about the square root of
/// the light, so noise is measured there. A white card in the sun is white, and shades below a
/// fiftieth of it count as dark.
AeroConvergence convergence_of(const scene::Image& image, const dvec3& daylight,
                               const AeroWindow& film) {
  const double white = image::luminance(daylight);
  const double noise = image.adaptive_threshold;
  return {static_cast<float>(4.0 * noise * noise * white), static_cast<float>(0.02 * white),
          film.width, film.height};
}

/// Returns whether a render of `crop` takes exactly the rays of `metering`, in one pass. Then a
/// film of its own would only repeat them.
bool takes_all_rays_of(const AeroFrame& metering, const AeroFrame& whole, const Crop& crop,
                       const PassPlan& plan) {
  return metering.width == whole.width && metering.height == whole.height &&
         metering.samples == whole.samples && metering.sample_stride == whole.sample_stride &&
         crop.pixels() == std::size_t{whole.width} * whole.height &&
         static_cast<std::uint32_t>(plan.samples_from(0)) == whole.samples;
}

/// The time that a launch aims at, in seconds. Chosen by eye.
double launch_seconds_of(Use use) {
  return use == Use::interactive ? 0.02 : 0.03;
}

}  // namespace

struct Session::State {
  State(Options given, const TestHooks& hooks)
      : options(std::move(given)), change_scene(hooks.change_scene), team(options, hooks) {
    if (!options.cache) options.cache = std::make_shared<SceneCache>();
  }

  void await_programs();
  void build(const scene::ResolvedScene& scene, Plants plants);
  void upload();
  void assemble(const bvh::JoinedBvh& tree);
  void prepare(const scene::ResolvedScene& scene, const scene::ResolvedScene& shown,
               const Crop& crop, Plants plants);
  void meter(const AeroFrame& metering);
  image::Film trace(const scene::ResolvedScene& resolved, const Crop& crop);
  void trace_pass(const Pass& pass, RowQueue& queue, const PassPlan& plan);
  image::Film read_passes(const scene::Scene& scene, const FilmArea& area, const RowQueue& queue);
  void publish(image::Film read);
  void finish(const FilmArea& area, const RowQueue& queue);
  void report(Stage stage, double fraction);
  void stop_if_asked() const;
  bool is_single_picture() const { return options.use == Use::single_picture; }
  void collect_stats();

  Options options;
  /// TestHooks::change_scene.
  std::function<void(pack::PackedScene&)> change_scene;
  DeviceTeam team;
  /// The newest geometry that was built.
  std::shared_ptr<const HostGeometry> geometry;
  /// The arrays of its groups, until the frame takes them.
  GroupArrays fresh;
  /// The geometry that the devices hold.
  std::shared_ptr<const HostGeometry> on_device;
  /// The bounds of all of it.
  bvh::Bounds bounds;
  std::shared_ptr<FrameArrays> frame = std::make_shared<FrameArrays>();

  std::stop_token stop;
  ProgressCallback progress;
  Stopwatch watch;
  Stats stats;
  /// The samples per pixel that whole passes have taken.
  int passes_done = 0;

  mutable std::mutex snapshot_mutex;
  image::Film latest;
  vec3 daylight{1.0f};
  double metered_ev = 0.0;
  /// Reads the film of a render that came to its end.
  std::function<image::Film()> finished;
  AbandonableWork background;
};

void Session::State::stop_if_asked() const {
  aerostat::stop_if_asked(stop);
}

void Session::State::report(Stage stage, double fraction) {
  if (!progress) return;
  const std::uint64_t rays = stats.rays.sum();
  progress({stage, fraction, rays, watch.seconds(), passes_done});
}

/// Waits for the kernels. A driver's compiler cannot be interrupted, so a render that is stopped
/// leaves it at work for the next one.
void Session::State::await_programs() {
  const auto waiting = [this](double fraction) {
    stop_if_asked();
    report(Stage::kernels, fraction);
  };
  stats.programs_built = team.await_programs(waiting, stats.kernel_seconds);
}

void Session::State::build(const scene::ResolvedScene& scene, Plants plants) {
  const auto old = geometry;
  const auto where = is_single_picture() ? scatter::Where::in_sight : scatter::Where::everywhere;
  GeometryOptions how{Meshes::release, plants, where, options.carving};
  how.kinds.insert(how.kinds.end(), options.more_kinds.begin(), options.more_kinds.end());
  // Work that is given up may outlive the session's other members, but not the cache.
  BuiltGeometry built = background.run(
      [scene, old, how, cache = options.cache]() mutable {
        how.reliefs = &cache->reliefs;
        how.models = &cache->models;
        return build_geometry(scene, old.get(), how);
      },
      stop, [this] { report(Stage::world, 0.0); });
  geometry = std::move(built.geometry);
  fresh.merge(built.arrays);
  std::erase_if(fresh, [this](const auto& one) { return !has_group(geometry->world, one.first); });
  stats.worlds_built = geometry->worlds_built;
  stats.trees_built = geometry->trees_built;
  stats.world_seconds = geometry->world_seconds;
  stats.tree_seconds = geometry->tree_seconds;
}

void Session::State::upload() {
  if (!on_device || !same_groups(*geometry, *on_device)) {
    on_device = nullptr;
    team.drop_geometry();
    const auto tree = background.run([shared = geometry] { return join_trees(*shared); }, stop,
                                     [this] { report(Stage::upload, 0.0); });
    assemble(*tree);
    bounds = tree->bounds;
    team.set_geometry(tree, frame, [this] { stop_if_asked(); });
  }
  on_device = geometry;
}

void Session::State::assemble(const bvh::JoinedBvh& tree) {
  try {
    frame->assemble(*geometry, tree, std::exchange(fresh, {}));
  } catch (const Error&) {
    // The arrays are lost, so the next render builds everything again.
    geometry = nullptr;
    throw;
  }
}

/// Prepares the first ray: builds the world, trees, kernels and buffers that are missing. `shown`
/// is the scene at the size of the film.
void Session::State::prepare(const scene::ResolvedScene& scene, const scene::ResolvedScene& shown,
                             const Crop& crop, Plants plants) {
  report(Stage::world, 0.0);
  team.begin_programs(scene->light);
  // For a single picture, air and clouds are computed on the cores that building the world leaves
  // idle. Previews follow each other: their worlds are small, and a stop would have to wait for
  // work that runs beside.
  const auto when = is_single_picture() ? std::launch::async : std::launch::deferred;
  auto packing = std::async(when, [this, &shown] {
    return pack::pack_scene(shown, options.cache->packing, options.cache->reliefs,
                            options.cache->models);
  });
  build(scene, plants);
  await_programs();
  stop_if_asked();
  report(Stage::upload, 0.0);
  const Stopwatch upload_watch;
  upload();
  pack::PackedScene packed = packing.get();
  if (change_scene) change_scene(packed);
  const std::size_t pixels = PassPlan(shown->image, crop, team.lanes()).area_from(0).pixels();
  team.begin_frame(packed, std::max(pixels, static_cast<std::size_t>(kMeteringPixels)));
  daylight = vec3(pack::daylight(packed.numbers, scene.eye().y));
  stats.upload_seconds = upload_watch.seconds();
}

void Session::State::trace_pass(const Pass& pass, RowQueue& queue, const PassPlan& plan) {
  const auto rays_in_all = static_cast<double>(plan.rays());
  team.trace(pass, queue, stop, [&] {
    stats.rays[KernelStage::primary] = team.rays_done();
    report(Stage::rays,
           std::min(1.0, static_cast<double>(stats.rays[KernelStage::primary]) / rays_in_all));
  });
  stop_if_asked();
  stats.rays[KernelStage::primary] = team.rays_done();
}

/// Finds the exposure of all that the frame `metering` shows.
void Session::State::meter(const AeroFrame& metering) {
  const Stopwatch metering_watch;
  const auto width = static_cast<int>(metering.width), height = static_cast<int>(metering.height);
  const Crop all{0, 0, width, height};
  team.begin_film(all, Layers::light_alone);
  RowQueue queue(0, height, static_cast<int>(options.devices.size()));
  const Pass pass{metering,
                  all,
                  0,
                  static_cast<int>(metering.samples),
                  options.tile_pixels,
                  launch_seconds_of(options.use)};
  team.trace(pass, queue, stop, [this] { report(Stage::rays, 0.0); });
  stop_if_asked();
  const FilmArea area{width, height, all, all};
  metered_ev = image::automatic_exposure_ev(
      read_film(team.film_rows(queue), area, Layers::light_alone).film);
  stats.metering_seconds = metering_watch.seconds();
}

image::Film Session::State::trace(const scene::ResolvedScene& resolved, const Crop& crop) {
  const AeroFrame whole = pack::pack_frame(resolved, bounds);
  const scene::Scene& scene = *resolved;
  const AeroFrame metering = metering_frame(whole);
  const PassPlan plan(scene.image, crop, team.lanes());
  const bool is_metered = options.contents != Contents::layers && !scene.image.exposure_ev;
  const bool meters_itself = takes_all_rays_of(metering, whole, crop, plan);
  if (is_metered && !meters_itself) meter(metering);
  const Stopwatch rays_watch;
  const FilmArea area{scene.image.width, scene.image.height, plan.area_from(0), crop};
  team.begin_film(area.window, layers_of(options));
  RowQueue queue(area.window.y0, area.window.y1, static_cast<int>(options.devices.size()));
  Pass pass{whole, {}, 0, 0, options.tile_pixels, launch_seconds_of(options.use)};
  const AeroConvergence convergence =
      convergence_of(scene.image, dvec3(daylight), window_of(area.window));
  for (passes_done = 0; passes_done < scene.image.spp; passes_done += pass.samples) {
    if (passes_done > 0) publish(read_passes(scene, area, queue));
    pass.area = plan.area_from(passes_done);
    pass.first_sample = passes_done;
    pass.samples = plan.samples_from(passes_done);
    if (plan.decides_before(passes_done)) team.mark_converged(convergence, queue);
    trace_pass(pass, queue, plan);
  }
  image::Film read = read_passes(scene, area, queue);
  if (is_metered && meters_itself) {
    metered_ev = read.metered_ev = image::automatic_exposure_ev(read);
  }
  finish(area, queue);
  stats.rays_seconds = rays_watch.seconds();
  return read;
}

image::Film Session::State::read_passes(const scene::Scene& scene, const FilmArea& area,
                                        const RowQueue& queue) {
  ReadFilm read = read_film(team.film_rows(queue), area, layers_of(options));
  read.film.daylight = daylight;
  read.film.metered_ev = metered_ev;
  stats.rays[KernelStage::primary] = read.samples;
  stats.rays[KernelStage::shadow] = shadow_rays_of(read.hits, scene);
  stats.rays[KernelStage::ambient] = scene.sky.ambient_occlusion ? read.hits : 0;
  return std::move(read.film);
}

void Session::State::publish(image::Film read) {
  const std::lock_guard lock(snapshot_mutex);
  latest = std::move(read);
}

/// Keeps a way to read the film again for snapshots. It stays on the devices until the next
/// render.
void Session::State::finish(const FilmArea& area, const RowQueue& queue) {
  const std::lock_guard lock(snapshot_mutex);
  latest = {};
  finished = [parts = team.film_rows(queue), area, light = daylight, ev = metered_ev,
              layers = layers_of(options)] {
    image::Film film = read_film(parts, area, layers).film;
    film.daylight = light;
    film.metered_ev = ev;
    return film;
  };
}

void Session::State::collect_stats() {
  stats.triangles = team.geometry().triangle_count();
  stats.tree = team.geometry().tree;
  stats.devices = team.stats();
  for (const DeviceStats& one : stats.devices) {
    for (const KernelStage stage : kKernelStages) {
      stats.device_seconds[stage] += one.seconds[stage];
    }
    stats.device_bytes += one.bytes;
  }
}

namespace {

Crop checked_crop(const scene::Image& image, const std::optional<Crop>& crop) {
  const Crop all{0, 0, image.width, image.height};
  if (!crop) return all;
  if (crop->x0 < 0 || crop->y0 < 0 || crop->x1 > all.x1 || crop->y1 > all.y1 ||
      crop->x0 >= crop->x1 || crop->y0 >= crop->y1) {
    throw Error(ErrorKind::usage,
                fmt::format("crop {},{},{},{} is not inside the image of {} x {} pixels", crop->x0,
                            crop->y0, crop->x1, crop->y1, all.x1, all.y1));
  }
  return *crop;
}

/// Returns the picture's settings for a film whose sides have `shrink` times fewer pixels.
scene::Image shrunk(scene::Image image, int shrink) {
  image.width = (image.width + shrink - 1) / shrink;
  image.height = (image.height + shrink - 1) / shrink;
  return image;
}

}  // namespace

Session::Session(Options options) : Session(std::move(options), TestHooks()) {}

Session::Session(Options options, const TestHooks& hooks)
    : state_(std::make_unique<State>(std::move(options), hooks)) {}

Session::~Session() = default;

void Session::begin_kernels(scene::Integrator integrator) {
  state_->team.begin_programs(integrator);
}

image::Film Session::render(const scene::ResolvedScene& scene, std::stop_token stop,
                            const ProgressCallback& progress, std::optional<Crop> crop,
                            Plants plants, int shrink) {
  State& state = *state_;
  if (plants == Plants::as_they_stand && state.is_single_picture()) {
    throw Error(ErrorKind::internal,
                "plants as they stand, found a session for single pictures, "
                "expected an interactive one");
  }
  const scene::ResolvedScene shown = scene.with_image(shrunk(scene->image, shrink));
  const Crop area = checked_crop(shown->image, crop);
  state.stop = std::move(stop);
  state.progress = progress;
  state.stats = {};
  state.passes_done = 0;
  state.metered_ev = 0.0;
  state.watch.restart();
  {
    const std::lock_guard lock(state.snapshot_mutex);
    state.latest = {};
    state.finished = nullptr;
  }
  state.prepare(scene, shown, area, plants);
  image::Film film = state.trace(shown, area);
  state.collect_stats();
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

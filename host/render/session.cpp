#include "render/session.hpp"

#include <algorithm>
#include <functional>
#include <future>
#include <mutex>
#include <utility>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "pack/daylight.hpp"
#include "pack/pack_scene.hpp"
#include "render/metering.hpp"
#include "render/session_state.hpp"
#include "render/settings.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {

void Session::State::stop_if_asked() const {
  aerostat::stop_if_asked(stop);
}

void Session::State::report(Stage stage, double fraction) {
  if (progress) progress(progress_of(stage, fraction));
}

Progress Session::State::progress_of(Stage stage, double fraction) const {
  return {stage, fraction, stats.rays.sum(), watch.seconds(), passes_done};
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
  team.expect_ambient_occlusion(scene->sky.ambient_occlusion);
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
  pack::PackedScene packed = packing.get();
  add_air_shadows(*geometry, shown, options.cache->packing.shadows, packed);
  if (change_scene) change_scene(packed);
  const std::size_t pixels = std::max(plan_of(shown->image, crop).area_from(0).pixels(),
                                      static_cast<std::size_t>(kMeteringPixels));
  team.require_room(memory_need(*geometry, packed, pixels, layers_of(options)));
  upload();
  team.begin_frame(packed, pixels);
  daylight = vec3(pack::daylight(packed.numbers, scene.eye().y));
  stats.upload_seconds = upload_watch.seconds();
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
  return state_->render(scene, {}, std::move(stop), progress, crop, plants, shrink);
}

image::Film Session::render_on(const scene::ResolvedScene& scene, const Course& course,
                               std::stop_token stop, const ProgressCallback& progress,
                               std::optional<Crop> crop) {
  return state_->render(scene, course, std::move(stop), progress, crop, Plants::as_seen, 1);
}

image::Film Session::State::render(const scene::ResolvedScene& scene, const Course& course,
                                   std::stop_token token, const ProgressCallback& callback,
                                   const std::optional<Crop>& crop, Plants plants, int shrink) {
  if (plants == Plants::as_they_stand && is_single_picture()) {
    throw Error(ErrorKind::internal,
                "plants as they stand, found a session for single pictures, "
                "expected an interactive one");
  }
  const scene::ResolvedScene shown = scene.with_image(shrunk(scene->image, shrink));
  const Crop pixels = checked_crop(shown->image, crop);
  stop = std::move(token);
  progress = callback;
  stats = {};
  passes_done = 0;
  rays_before = 0;
  fraction_done = 0.0;
  metered_ev = 0.0;
  watch.restart();
  {
    const std::lock_guard lock(snapshot_mutex);
    latest = {};
    finished = nullptr;
  }
  prepare(scene, shown, pixels, plants);
  image::Film film = trace(shown, pixels, course);
  collect_stats();
  report(Stage::done, 1.0);
  return film;
}

int Session::lanes() const {
  return state_->team.lanes();
}

Crop Session::film_window(const scene::Image& image, std::optional<Crop> crop) const {
  return state_->plan_of(image, checked_crop(image, crop)).area_from(0);
}

image::Film Session::snapshot() const {
  const std::lock_guard lock(state_->snapshot_mutex);
  return state_->finished ? state_->finished() : state_->latest;
}

const Stats& Session::stats() const {
  return state_->stats;
}

}  // namespace aerostat::render

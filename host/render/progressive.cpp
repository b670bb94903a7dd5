#include "render/progressive.hpp"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "render/abandonable.hpp"
#include "render/scene_cache.hpp"
#include "render/test_hooks.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"

namespace aerostat::render {
namespace {

/// The largest shrink of a preview, and the cells of a coarse land on each side. Chosen by eye.
constexpr int kMostShrink = 16;
constexpr int kRoughCells = 192;
/// The time of the first preview in seconds. Chosen by eye.
constexpr double kFirstLook_s = 0.05;
/// The patience for the first look at a rough scene, in seconds. Carving and building the land take
/// the same time again.
constexpr double kFirstRoughLook_s = 0.03;
/// The drafted pixels per second that are assumed before any were measured.
constexpr double kFirstRate = 1e6;
constexpr std::chrono::milliseconds kRestBeforeFineLand(150);

scene::Scene drafted(scene::Scene scene) {
  scene.image.spp = 1;
  scene.sun.soft_shadows = false;
  scene.sky.ambient_occlusion = false;
  return scene;
}

bool is_draft(const scene::Scene& scene) {
  return scene.image.spp == 1 && !scene.sun.soft_shadows && !scene.sky.ambient_occlusion;
}

int shrunk(int pixels, int shrink) {
  return (pixels + shrink - 1) / shrink;
}

/// Makes a scene rough: it is built fast and looks nearly the same from afar. The balloon is only
/// as fine as the largest pixels need.
scene::Scene roughened(scene::Scene scene, int shrink) {
  scene.image.width = shrunk(scene.image.width, shrink);
  scene.image.height = shrunk(scene.image.height, shrink);
  scene.terrain.cells = std::min(scene.terrain.cells, kRoughCells);
  scene.vegetation.enabled = false;
  return scene;
}

Options with_carving(Options options, world::Carving carving) {
  options.carving = carving;
  return options;
}

double pixels_of(const scene::Image& image) {
  return static_cast<double>(image.width) * static_cast<double>(image.height);
}

/// Returns after `time`, or throws Error{interrupted} as soon as `stop` is requested.
void rest(std::chrono::milliseconds time, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  wake.wait_for(lock, stop, time, [] { return false; });
  stop_if_asked(stop);
}

}  // namespace

std::vector<Step> steps_to(double pixels, double pixels_per_second, double patience_s,
                           bool is_draft) {
  std::vector<Step> steps;
  const double affordable = pixels_per_second * patience_s;
  int shrink = 1;
  while (shrink < kMostShrink && pixels / (shrink * shrink) > affordable) shrink *= 2;
  for (; shrink > 1; shrink /= 2) steps.push_back({shrink, true});
  if (!is_draft) steps.push_back({1, true});
  steps.push_back({1, is_draft});
  return steps;
}

struct Progressive::State {
  State(const Options& options, const TestHooks& hooks)
      : cache(options.cache),
        fine(with_carving(options, world::Carving::fine), hooks),
        coarse(with_carving(options, world::Carving::coarse), hooks) {}

  void find_surface(const scene::Scene& scene, world::Carving carving);
  scene::ResolvedScene resolved(const scene::Scene& scene, bool rough) const;
  void show_steps(Session& session, const scene::Scene& scene, bool rough);
  void show_step(Session& session, const scene::Scene& scene, const Step& step, bool rough);
  void measure(const Step& step, const scene::Scene& scene, bool rough, const Stats& stats);
  bool has_land(const scene::Scene& scene) const {
    return built && world::same_land(*built, scene);
  }

  double& draft_rate(const scene::Scene& scene, bool rough) {
    return draft_rates.try_emplace({scene.biome.kind, rough}, kFirstRate).first->second;
  }

  std::shared_ptr<SceneCache> cache;  // of both sessions
  Session fine, coarse;
  /// The scene whose land `fine` holds, and the surface of this land.
  std::optional<scene::Scene> built;
  std::shared_ptr<const world::Surface> built_surface;
  /// The drafted pixels per second that were measured for each biome, fine or rough. Woods and
  /// waves take longer than dunes.
  std::map<std::pair<scene::BiomeKind, bool>, double> draft_rates;
  AbandonableWork background;

  // The next fields belong to the present render.
  std::shared_ptr<const world::Surface> surface;
  /// Objects are made as fine as pixels that are this many times larger need.
  int world_shrink = 1;
  std::stop_token stop;
  PreviewCallback show;
  ProgressCallback progress;
  Stopwatch watch;
};

/// Takes the present surface if it is that of the scene, else carves a new one.
void Progressive::State::find_surface(const scene::Scene& scene, world::Carving carving) {
  if (has_land(scene)) {
    surface = built_surface;
    return;
  }
  const auto carve = [scene, carving, kept = cache] {
    return std::make_shared<const world::Surface>(scene, carving, kept->reliefs);
  };
  surface = background.run(carve, stop, [this] {
    if (progress) progress({Stage::world, 0.0, 0, watch.seconds(), 0});
  });
}

/// Resolves a scene on the present surface.
scene::ResolvedScene Progressive::State::resolved(const scene::Scene& scene, bool rough) const {
  const scene::ResolvedScene result = world::resolve(scene, *surface);
  return rough ? world::with_eye_unburied(result, *surface, kRoughCells) : result;
}

void Progressive::State::show_steps(Session& session, const scene::Scene& scene, bool rough) {
  auto steps = steps_to(pixels_of(scene.image), draft_rate(scene, rough),
                        rough ? kFirstRoughLook_s : kFirstLook_s, is_draft(scene));
  // Only two looks at a coarse land are shown, because the fine land is worth more than further
  // pixels of the coarse one.
  if (rough) steps.resize(std::min<std::size_t>(steps.size(), 2));
  world_shrink = rough ? steps.back().shrink : 1;
  for (const Step& step : steps) show_step(session, scene, step, rough);
}

void Progressive::State::show_step(Session& session, const scene::Scene& scene, const Step& step,
                                   bool rough) {
  scene::Scene shown = step.draft ? drafted(scene) : scene;
  if (rough) shown = roughened(shown, world_shrink);
  const bool last = step.shrink == 1 && !rough && step.draft == is_draft(scene);
  // Until the view rests, the plants stay as they were placed for a former eye.
  const Plants plants = last ? Plants::as_seen : Plants::as_they_stand;
  Preview preview{image::Film(),
                  resolved(scene, rough),
                  surface,
                  nullptr,
                  step.shrink,
                  0,
                  rough,
                  step.draft,
                  false,
                  {},
                  0.0};
  const auto watch_passes = [&](const Progress& now) {
    if (progress) progress(now);
    if (!rough && now.stage >= Stage::upload) {
      built = scene;
      built_surface = surface;
    }
    if (now.stage != Stage::rays || now.samples_done <= preview.samples) return;
    preview.film = session.snapshot();
    preview.models = cache->models.models_of(shown);
    preview.samples = now.samples_done;
    preview.stats = session.stats();
    preview.seconds = watch.seconds();
    show(preview);
  };
  preview.film = session.render(resolved(shown, rough), stop, watch_passes, {}, plants,
                                step.shrink / world_shrink);
  preview.models = cache->models.models_of(shown);
  preview.samples = shown.image.spp;
  preview.complete = last;
  preview.stats = session.stats();
  preview.seconds = watch.seconds();
  if (step.draft) measure(step, scene, rough, preview.stats);
  show(preview);
}

void Progressive::State::measure(const Step& step, const scene::Scene& scene, bool rough,
                                 const Stats& stats) {
  if (stats.rays_seconds <= 0.0) return;
  const double pixels = pixels_of(scene.image) / (step.shrink * step.shrink);
  double& rate = draft_rate(scene, rough);
  rate = 0.5 * rate + 0.5 * pixels / stats.rays_seconds;
}

Progressive::Progressive(Options options) : Progressive(std::move(options), TestHooks()) {}

Progressive::Progressive(Options options, const TestHooks& hooks) {
  options.use = Use::interactive;
  if (!options.cache) options.cache = std::make_shared<SceneCache>();
  state_ = std::make_unique<State>(options, hooks);
}

Progressive::~Progressive() = default;

void Progressive::render(const scene::Scene& scene, const std::stop_token& stop,
                         const PreviewCallback& show, const ProgressCallback& progress) {
  State& state = *state_;
  state.stop = stop;
  state.show = show;
  state.progress = progress;
  state.watch.restart();
  state.coarse.begin_kernels(scene.light);
  if (!state.has_land(scene)) {
    state.find_surface(scene, world::Carving::coarse);
    state.show_steps(state.coarse, scene, true);
    rest(kRestBeforeFineLand, stop);
  }
  state.find_surface(scene, world::Carving::fine);
  state.show_steps(state.fine, scene, false);
}

}  // namespace aerostat::render

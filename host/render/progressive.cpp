#include "render/progressive.hpp"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>

#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "render/abandonable.hpp"
#include "render/scene_cache.hpp"
#include "world/world.hpp"

namespace aerostat::render {
namespace {

/// The largest shrink of a preview, and the cells of a coarse land on each side. Chosen by eye.
constexpr int kMostShrink = 16;
constexpr int kRoughCells = 192;
/// The times of a launch and of the first preview in seconds. Chosen by eye.
constexpr double kLaunch_s = 0.02;
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

/// Returns options with launches so short that a stop is answered within 50 ms.
Options promptly(Options options) {
  options.launch_seconds = kLaunch_s;
  return options;
}

Options coarsely(const Options& given) {
  Options options = promptly(given);
  options.carving = world::Carving::coarse;
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
  explicit State(const Options& options)
      : cache(options.cache), fine(promptly(options)), coarse(coarsely(options)) {}

  scene::Scene placed(const scene::Scene& scene, world::Carving carving);
  void show_steps(Session& session, const scene::Scene& resolved, bool rough);
  void show_step(Session& session, const scene::Scene& resolved, const Step& step, bool rough);
  void measure(const Step& step, const scene::Scene& resolved, bool rough, const Stats& stats);
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
  // ^ The drafted pixels per second that were measured for each biome, fine or rough. Woods and
  // waves take longer than dunes.
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

/// Returns the scene with all heights known. Uses the present land if it fits the scene, else
/// carves a new one first.
scene::Scene Progressive::State::placed(const scene::Scene& scene, world::Carving carving) {
  const auto known = has_land(scene) ? built_surface : nullptr;
  const auto resolve = [scene, carving, known, kept = cache] {
    scene::Scene copy = scene;
    auto ground =
        known ? known : std::make_shared<const world::Surface>(copy, carving, kept->reliefs);
    world::resolve(copy, *ground);
    if (carving == world::Carving::coarse) world::unbury_eye(copy, *ground, kRoughCells);
    return std::pair(std::move(copy), std::move(ground));
  };
  const auto waiting = [this] {
    if (progress) progress({Stage::world, 0.0, 0, watch.seconds(), 0});
  };
  auto [placed_scene, its_surface] = known ? resolve() : background.run(resolve, stop, waiting);
  surface = std::move(its_surface);
  return placed_scene;
}

void Progressive::State::show_steps(Session& session, const scene::Scene& resolved, bool rough) {
  auto steps = steps_to(pixels_of(resolved.image), draft_rate(resolved, rough),
                        rough ? kFirstRoughLook_s : kFirstLook_s, is_draft(resolved));
  // Only two looks at a coarse land are shown, because the fine land is worth more than further
  // pixels of the coarse one.
  if (rough) steps.resize(std::min<std::size_t>(steps.size(), 2));
  world_shrink = rough ? steps.back().shrink : 1;
  for (const Step& step : steps) show_step(session, resolved, step, rough);
}

void Progressive::State::show_step(Session& session, const scene::Scene& resolved, const Step& step,
                                   bool rough) {
  scene::Scene scene = step.draft ? drafted(resolved) : resolved;
  if (rough) scene = roughened(scene, world_shrink);
  const bool last = step.shrink == 1 && !rough && step.draft == is_draft(resolved);
  // Until the view rests, the plants stay as they were placed for a former eye.
  const Plants plants = last ? Plants::as_seen : Plants::as_they_stand;
  Preview preview{image::Film(), resolved,   surface, step.shrink, 0,
                  rough,         step.draft, false,   {},          0.0};
  const auto watch_passes = [&](const Progress& now) {
    if (progress) progress(now);
    if (!rough && now.stage >= Stage::upload) {
      built = resolved;
      built_surface = surface;
    }
    if (now.stage != Stage::rays || now.samples_done <= preview.samples) return;
    preview.film = session.snapshot();
    preview.samples = now.samples_done;
    preview.stats = session.stats();
    preview.seconds = watch.seconds();
    show(preview);
  };
  preview.film = session.render(scene, stop, watch_passes, {}, plants, step.shrink / world_shrink);
  preview.samples = scene.image.spp;
  preview.complete = last;
  preview.stats = session.stats();
  preview.seconds = watch.seconds();
  if (step.draft) measure(step, resolved, rough, preview.stats);
  show(preview);
}

void Progressive::State::measure(const Step& step, const scene::Scene& resolved, bool rough,
                                 const Stats& stats) {
  if (stats.rays_seconds <= 0.0) return;
  const double pixels = pixels_of(resolved.image) / (step.shrink * step.shrink);
  double& rate = draft_rate(resolved, rough);
  rate = 0.5 * rate + 0.5 * pixels / stats.rays_seconds;
}

Progressive::Progressive(Options options) {
  if (!options.cache) options.cache = std::make_shared<SceneCache>();
  state_ = std::make_unique<State>(options);
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
    state.show_steps(state.coarse, state.placed(scene, world::Carving::coarse), true);
    rest(kRestBeforeFineLand, stop);
  }
  state.show_steps(state.fine, state.placed(scene, world::Carving::fine), false);
}

}  // namespace aerostat::render

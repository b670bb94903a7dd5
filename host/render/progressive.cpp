#include "render/progressive.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "render/abandonable.hpp"
#include "world/world.hpp"

namespace aerostat::render {
namespace {

constexpr int kMostShrink = 16;
constexpr int kRoughCells = 192;
constexpr double kFirstLook_s = 0.05;
constexpr double kFirstRate = 1e6;  // drafted pixels per second, before one was measured
constexpr std::chrono::milliseconds kSettling(150);

scene::Scene drafted(scene::Scene scene) {
  scene.image.spp = 1;
  scene.sun.soft_shadows = false;
  scene.sky.ambient_occlusion = false;
  return scene;
}

bool is_draft(const scene::Scene& scene) {
  return scene.image.spp == 1 && !scene.sun.soft_shadows && !scene.sky.ambient_occlusion;
}

/// Soon built and nearly the same from afar.
scene::Scene roughened(scene::Scene scene) {
  scene.terrain.cells = std::min(scene.terrain.cells, kRoughCells);
  scene.vegetation.enabled = false;
  return scene;
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
  if (stop.stop_requested()) throw Error(ErrorKind::interrupted, "interrupted");
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
  explicit State(const Options& options) : fine(options), coarse(options) {}

  scene::Scene resolved(const scene::Scene& scene);
  void show_steps(Session& session, const scene::Scene& resolved, bool rough);
  void show_step(Session& session, const scene::Scene& resolved, const Step& step, bool rough);
  void measure(const Step& step, const scene::Scene& resolved, const Stats& stats);
  bool has_land(const scene::Scene& resolved) const {
    return built && world::same_land(*built, resolved);
  }

  Session fine, coarse;
  std::optional<scene::Scene> built;  // whose land `fine` holds
  double draft_rate = kFirstRate;
  AbandonableWork background;

  // Of the render under way.
  std::shared_ptr<const world::Surface> surface;
  std::stop_token stop;
  LookCallback show;
  ProgressCallback progress;
  Stopwatch watch;
};

/// Carved land takes some tenths of a second to know its heights.
scene::Scene Progressive::State::resolved(const scene::Scene& scene) {
  const auto resolve = [scene] {
    scene::Scene copy = scene;
    world::resolve(copy);
    return std::pair(copy, std::make_shared<const world::Surface>(copy));
  };
  auto [resolved_scene, its_surface] = background.run(resolve, stop, [this] {
    if (progress) progress({Stage::world, 0.0, 0, watch.seconds(), 0});
  });
  surface = std::move(its_surface);
  return resolved_scene;
}

void Progressive::State::show_steps(Session& session, const scene::Scene& resolved, bool rough) {
  auto steps = steps_to(pixels_of(resolved.image), draft_rate, kFirstLook_s, is_draft(resolved));
  // The fine land is worth waiting for more than more pixels of a coarse one.
  if (rough) steps.resize(std::min<std::size_t>(steps.size(), 2));
  for (const Step& step : steps) show_step(session, resolved, step, rough);
}

void Progressive::State::show_step(Session& session, const scene::Scene& resolved, const Step& step,
                                   bool rough) {
  scene::Scene scene = step.draft ? drafted(resolved) : resolved;
  if (rough) scene = roughened(scene);
  const bool last = step.shrink == 1 && !rough && step.draft == is_draft(resolved);
  // Trees of a former eye do until the view rests.
  const Plants plants = last ? Plants::as_seen : Plants::as_they_stand;
  Look look{{}, resolved, surface, step.shrink, 0, rough, step.draft, false, {}, 0.0};
  const auto watch_passes = [&](const Progress& now) {
    if (progress) progress(now);
    if (now.stage != Stage::rays || now.samples_done <= look.samples) return;
    look.film = session.snapshot();
    look.samples = now.samples_done;
    look.stats = session.stats();
    look.seconds = watch.seconds();
    show(look);
  };
  look.film = session.render(scene, stop, watch_passes, {}, plants, step.shrink);
  look.samples = scene.image.spp;
  look.complete = last;
  look.stats = session.stats();
  look.seconds = watch.seconds();
  measure(step, resolved, look.stats);
  show(look);
}

void Progressive::State::measure(const Step& step, const scene::Scene& resolved,
                                 const Stats& stats) {
  if (!step.draft || stats.rays_seconds <= 0.0) return;
  const double pixels = pixels_of(resolved.image) / (step.shrink * step.shrink);
  draft_rate = 0.5 * draft_rate + 0.5 * pixels / stats.rays_seconds;
}

Progressive::Progressive(Options options) : state_(std::make_unique<State>(std::move(options))) {}

Progressive::~Progressive() = default;

void Progressive::render(const scene::Scene& scene, const std::stop_token& stop,
                         const LookCallback& show, const ProgressCallback& progress) {
  State& state = *state_;
  state.stop = stop;
  state.show = show;
  state.progress = progress;
  state.watch.restart();
  state.coarse.begin_kernels();
  const scene::Scene resolved = state.resolved(scene);
  if (!state.has_land(resolved)) {
    state.built.reset();
    state.show_steps(state.coarse, resolved, true);
    rest(kSettling, stop);
  }
  state.show_steps(state.fine, resolved, false);
  state.built = resolved;
}

}  // namespace aerostat::render

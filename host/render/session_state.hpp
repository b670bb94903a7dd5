#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "render/abandonable.hpp"
#include "render/device_team.hpp"
#include "render/film_sums.hpp"
#include "render/passes.hpp"
#include "render/scene_cache.hpp"
#include "render/session.hpp"
#include "render/test_hooks.hpp"

/// The inner part of a session. session.cpp prepares the first ray, and session_rays.cpp traces.
namespace aerostat::render {

struct Session::State {
  State(Options given, const TestHooks& hooks)
      : options(std::move(given)), change_scene(hooks.change_scene), team(options, hooks) {
    if (!options.cache) options.cache = std::make_shared<SceneCache>();
  }

  image::Film render(const scene::ResolvedScene& scene, const Course& course, std::stop_token token,
                     const ProgressCallback& callback, const std::optional<Crop>& crop,
                     Plants plants, int shrink);
  PassPlan plan_of(const scene::Image& image, const Crop& crop) const {
    return {image, crop, team.lanes(), options.filtered};
  }
  void await_programs();
  void build(const scene::ResolvedScene& scene, Plants plants);
  void upload();
  void assemble(const bvh::JoinedBvh& tree);
  void prepare(const scene::ResolvedScene& scene, const scene::ResolvedScene& shown,
               const Crop& crop, Plants plants);
  void meter(const AeroFrame& metering);
  image::Film trace(const scene::ResolvedScene& resolved, const Crop& crop, const Course& course);
  void take_sums(const FilmSums& sums, const PassPlan& plan, RowQueue& queue);
  void trace_passes(const scene::Scene& scene, const AeroFrame& whole, const FilmArea& area,
                    const PassPlan& plan, const Course& course, RowQueue& queue);
  bool trace_pass(const Pass& pass, RowQueue& queue, const PassPlan& plan, const FilmArea& area,
                  const Course& course);
  bool pause(const Pass& pass, const RowQueue& queue, const std::vector<RowRange>& waiting,
             const FilmArea& area, const Course& course);
  FilmSums read_sums_of(int samples_done, std::vector<RowRange> waiting, const FilmArea& area,
                        const RowQueue& queue);
  image::Film read_passes(const scene::Scene& scene, const FilmArea& area, const RowQueue& queue);
  void publish(image::Film read);
  void finish(const FilmArea& area, const RowQueue& queue);
  Progress progress_of(Stage stage, double fraction) const;
  void report(Stage stage, double fraction);
  void watch_device();
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
  /// The eye rays of the sums that the render began with, and the share of all that are done.
  std::uint64_t rays_before = 0;
  double fraction_done = 0.0;
  /// The rays that were done when the device was last watched, and how often they were the same.
  std::uint64_t rays_watched = 0;
  int times_idle = 0;

  mutable std::mutex snapshot_mutex;
  image::Film latest;
  vec3 daylight{1.0f};
  double metered_ev = 0.0;
  /// Reads the film of a render that came to its end.
  std::function<image::Film()> finished;
  AbandonableWork background;
};

}  // namespace aerostat::render

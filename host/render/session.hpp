#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "bvh/bvh.hpp"
#include "image/film.hpp"
#include "opencl/device.hpp"
#include "render/kernel_stage.hpp"
#include "scene/scene.hpp"
#include "world/surface.hpp"

namespace aerostat::world {
struct GroupKind;
}

/// Rendering as a library: a render can be started, observed, cancelled and read while it refines.
namespace aerostat::render {

struct SceneCache;

/// What a film holds beside the light: all layers, or none, which is less to read back.
enum class Layers { all, light_alone };

struct Options {
  std::vector<opencl::Device> devices;   // that share each picture; at least one
  int lanes = 0;                         // 0: what each device prefers
  std::uint64_t memory_limit_bytes = 0;  // buffers on each device; 0: what it reports
  int tile_pixels = 0;                   // 0: chosen so that launches stay short
  double launch_seconds = 0.03;          // so short; two are in flight, which a stop waits for
  /// Plants that a picture cannot show, and whose shade it cannot show, are not placed. Less work
  /// for one picture, more for one who moves the view.
  bool plants_in_sight_alone = false;
  /// How finely land is carved; scenes must be resolved on the same.
  world::Carving carving = world::Carving::fine;
  Layers layers = Layers::all;
  /// Whether films tell the exposure that suits them (image::Film::metered_ev). A film that nobody
  /// develops needs none.
  bool meters = true;
  /// Kinds of groups (world/group.hpp) that scenes have beside those of world::all_kinds.
  std::vector<const world::GroupKind*> more_kinds = {};
  /// What the session keeps of scenes beside their geometry; null: it has its own. A caller that
  /// resolves the scenes gives the cache with which it does so.
  std::shared_ptr<SceneCache> cache = nullptr;
  /// For tests: called before each launch, on the thread that launches, with the device that it is
  /// for. What it throws comes out as if the launch had failed.
  std::function<void(const opencl::Device&)> before_launch = {};
};

/// A part of the image: pixels x0 <= x < x1, y0 <= y < y1.
struct Crop {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  std::size_t pixels() const {
    return static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0);
  }
};

/// Which plants a picture shows. They are placed around the eye, in the detail that it sees, which
/// takes some tenths of a second. While a view is being moved they may stay as they stand for a
/// former eye: a picture in good time, which depends on what was rendered before.
enum class Plants { as_seen, as_they_stand };

enum class Stage { world, tree, kernels, upload, rays, done };

struct Progress {
  Stage stage = Stage::world;
  double fraction = 0.0;  // of the stage
  std::uint64_t rays = 0;
  double seconds = 0.0;  // since the render began
  int samples_done = 0;  // per pixel, whole passes
};

/// Called from the thread that renders, at least every 100 ms of it.
using ProgressCallback = std::function<void(const Progress&)>;

/// What one device did for a render. Seconds are by its own clock.
struct DeviceStats {
  std::string selector, name;
  std::uint64_t primary_rays = 0;
  PerStage<double> seconds;
  std::uint64_t bytes = 0;
};

/// What a render did. Counts of what was re-used let a caller see that nothing was built twice.
struct Stats {
  double world_seconds = 0.0;
  double tree_seconds = 0.0;
  double kernel_seconds = 0.0;
  double upload_seconds = 0.0;
  double metering_seconds = 0.0;
  double rays_seconds = 0.0;
  /// The seconds of each kernel on all devices together, by their own clocks.
  PerStage<double> device_seconds;
  /// The rays that each kernel traced. Shading traces none.
  PerStage<std::uint64_t> rays;
  std::uint64_t triangles = 0;
  std::uint64_t device_bytes = 0;
  int worlds_built = 0;  // groups built by this render: 0 if all was kept
  int trees_built = 0;
  int programs_built = 0;
  bvh::BuildStats tree;
  std::vector<DeviceStats> devices;
};

/// Renders scenes, one after the other, keeping meshes, trees, buffers and programs that the next
/// scene can use. Several devices share a picture by its rows, each taking the next ones when it is
/// done with its last; devices of one lane width give the bits that one of them would give alone.
/// What goes wrong on one of several ends the render with an error that names it. Not for use from
/// two threads at once, except `snapshot`.
class Session {
 public:
  explicit Session(Options options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Begins to build the kernels in the background, if they are not there; a caller that still has
  /// something else to do before `render` saves the time. Their errors come from `render`.
  void begin_kernels();

  /// Renders all samples of `scene` (resolved) and returns the film of `crop` (default: all of it).
  /// If `stop` is requested, throws Error{interrupted} within 100 ms of device work; what was done
  /// until then stays readable by `snapshot`. Throws Error of other kinds as the parts do.
  /// With `shrink` > 1 the film has that many times fewer pixels a side, rounded up, and so have
  /// crops; the world is that of the whole picture, so that going on with a larger one builds
  /// nothing.
  /// Unless the scene gives an exposure, the picture is metered before, at some pixels all over it,
  /// so that its parts agree.
  image::Film render(const scene::Scene& scene, std::stop_token stop = {},
                     const ProgressCallback& progress = {}, std::optional<Crop> crop = {},
                     Plants plants = Plants::as_seen, int shrink = 1);

  /// The film of the whole passes finished so far, from any thread; empty before the first.
  image::Film snapshot() const;

  /// Of the last render.
  const Stats& stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat::render

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
#include "scene/picture.hpp"
#include "scene/resolved_scene.hpp"
#include "world/surface.hpp"

namespace aerostat::world {
struct GroupKind;
}

/// This is rendering as a library. A render can be started, observed, cancelled, and read while it
/// refines.
namespace aerostat::render {

struct Course;
struct SceneCache;
struct TestHooks;

/// What a session is used for.
enum class Use {
  /// Each view is rendered once, as fast as possible. Plants are left out where the picture can
  /// show neither them nor their shade. The air and the clouds are worked out on the cores that
  /// building the world leaves idle.
  single_picture,
  /// Pictures follow each other while a view moves. All plants in reach are placed, so that a view
  /// that turns builds nothing. Launches are shorter, so that a stop is answered sooner.
  interactive
};

/// What the films of a session hold.
enum class Contents {
  /// All layers but those of `guides`, and the exposure that suits the light
  /// (image::Film::metered_ev).
  everything,
  /// What developing needs: the light and its exposure. Less is read back from the devices.
  picture,
  /// The same layers without an exposure, for a film that nobody develops.
  layers
};

struct Options {
  /// The devices that share each picture. There must be at least one.
  std::vector<opencl::Device> devices;
  /// The rays of a work-item: 1, 4, 8 or 16. 0 leaves the choice to each device.
  int lanes = 0;
  /// The most bytes of buffers on each device. 0 means the memory that the device reports.
  std::uint64_t memory_limit_bytes = 0;
  /// The pixels of a launch. 0 means that launches take 0.03 s, or 0.02 s in an interactive
  /// session. A stop waits for up to two launches.
  int tile_pixels = 0;
  Use use = Use::single_picture;
  /// The detail of the land. Scenes must be resolved on land of the same detail.
  world::Carving carving = world::Carving::fine;
  Contents contents = Contents::everything;
  /// Whether films also hold the albedos and normals that guide a denoiser. They take time.
  bool guides = false;
  /// Whether pixels are filtered (/image/filter). A denoiser wants pixels that share no samples,
  /// and image::filter_pixels() filters them later.
  bool filtered = true;
  /// The kinds of groups (world/group.hpp) that scenes have beside those of world::all_kinds.
  std::vector<const world::GroupKind*> more_kinds = {};
  /// The cache of what scenes need beside their geometry. Null means that the session makes its
  /// own. A caller that resolves the scenes gives the cache that it resolves them with.
  std::shared_ptr<SceneCache> cache = nullptr;
  /// Is called if no launch comes to its end for `device_timeout_s` while rays are traced. A driver
  /// that hangs cannot be stopped, so that only the end of the process helps. Null means that the
  /// session waits without limit.
  std::function<void()> on_device_timeout = nullptr;
  double device_timeout_s = 300.0;
};

/// A part of the image. It holds the pixels x0 <= x < x1, y0 <= y < y1.
struct Crop {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  std::size_t pixels() const {
    return static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0);
  }
};

/// The plants that a picture shows. `as_seen` places them around the eye in the detail that it
/// sees, which takes some tenths of a second. `as_they_stand` keeps those of a former eye, for a
/// quick picture while a view is moved. Such a picture depends on what was rendered before, and
/// only an interactive session renders it, because another one has no plants out of the former
/// sight.
enum class Plants { as_seen, as_they_stand };

enum class Stage { world, tree, kernels, upload, rays, done };

struct Progress {
  Stage stage = Stage::world;
  /// The share of the stage that is done, from 0 to 1.
  double fraction = 0.0;
  std::uint64_t rays = 0;
  /// The time since the render began.
  double seconds = 0.0;
  /// The samples of each pixel that whole passes have taken.
  int samples_done = 0;
};

/// A function that is called from the thread that renders, at least every 100 ms.
using ProgressCallback = std::function<void(const Progress&)>;

/// The work of one device for a render. Seconds are by the device's own clock.
struct DeviceStats {
  std::string selector, name;
  std::uint64_t primary_rays = 0;
  PerStage<double> seconds;
  std::uint64_t bytes = 0;
};

/// The work of a render. The counts of what was built show a caller that nothing was built twice.
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
  /// The groups of the world that this render built. 0 means that all were kept.
  int worlds_built = 0;
  int trees_built = 0;
  int programs_built = 0;
  bvh::BuildStats tree;
  std::vector<DeviceStats> devices;
};

/// Renders scenes one after the other, and keeps the meshes, trees, buffers and programs that the
/// next scene can use. Several devices share a picture by its rows: each takes the next rows when
/// it has finished its last ones. Devices of one lane width give the same bits as one of them
/// alone. A failure of one device ends the render with an error that names the device. Only
/// `snapshot` may be called from a second thread.
class Session {
 public:
  explicit Session(Options options);
  /// Makes a session with hooks for tests (test_hooks.hpp).
  Session(Options options, const TestHooks& hooks);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Begins to build the kernels of an integrator in the background if they are not built yet. A
  /// caller that has other work to do before `render` saves that time. `render` throws the errors
  /// of the build.
  void begin_kernels(scene::Integrator integrator);

  /// Renders all samples of `scene` and returns the film of `crop`, which is the whole picture by
  /// default. If `stop` is requested, throws Error{interrupted} within 100
  /// ms of device work, and `snapshot` returns what was done until then. Throws the errors of its
  /// parts. With `shrink` > 1, the sides of the film have that many times fewer pixels, rounded up,
  /// and crops count in these pixels. The world is that of the whole picture, so that a larger
  /// picture afterwards builds nothing. If the scene gives no exposure and the films hold one, the
  /// picture is metered first at pixels all over it, so that its parts agree. Throws
  /// Error{internal} for plants as they stand in a session that is not interactive.
  image::Film render(const scene::ResolvedScene& scene, std::stop_token stop = {},
                     const ProgressCallback& progress = {}, std::optional<Crop> crop = {},
                     Plants plants = Plants::as_seen, int shrink = 1);

  /// Renders like `render`, but may go on from the sums of a former render, pause, and end early
  /// with the film so far, as `course` says. The exposure of such a film is that of the whole
  /// picture. Throws Error{usage} if the sums are not those of this picture.
  image::Film render_on(const scene::ResolvedScene& scene, const Course& course,
                        std::stop_token stop = {}, const ProgressCallback& progress = {},
                        std::optional<Crop> crop = {});

  /// Returns the lanes of the device with the widest packets, by which passes are planned.
  int lanes() const;
  /// Returns the pixels that `render` of the crop takes samples of, which are those of the sums of
  /// a render (film_sums.hpp). Throws Error{usage} if the crop is not inside the image.
  Crop film_window(const scene::Image& image, std::optional<Crop> crop = {}) const;

  /// Returns the film of the passes that are finished, which is empty before the first one. It may
  /// be called from any thread.
  image::Film snapshot() const;

  /// Returns the work of the last render.
  const Stats& stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat::render

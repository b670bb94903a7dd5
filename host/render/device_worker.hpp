#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>

#include "pack/pack_scene.hpp"
#include "render/film_buffer.hpp"
#include "render/geometry.hpp"
#include "render/programs.hpp"
#include "render/row_queue.hpp"
#include "render/session.hpp"
#include "render/test_hooks.hpp"
#include "render/tiles.hpp"

namespace aerostat::render {

struct FilmSums;
struct MemoryNeed;

/// A number of samples for every pixel of an area, which lies inside the window of the film.
struct Pass {
  AeroFrame frame{};
  Crop area;
  int first_sample = 0;
  /// The number of samples per pixel, a power of two.
  int samples = 0;
  /// The same as `tile_pixels` in Options.
  int tile_pixels = 0;
  double launch_seconds = 0.03;
};

/// One device that works on a frame, with its programs, its copy of the scene, its film and its
/// launches. Use it from one thread at a time, except where a function says otherwise. Errors of
/// its parts are passed on unchanged.
class DeviceWorker {
 public:
  /// Makes the worker of a device. It uses `lanes` and `memory_limit_bytes` of `options`.
  DeviceWorker(const opencl::Device& device, const Options& options, TestHooks hooks = {});

  const opencl::Device& device() const { return context_.device(); }
  int lanes() const { return lanes_; }

  /// Begins to build the kernels of an integrator in the background if they are not built yet.
  /// Later calls and frames use this integrator.
  void begin_programs(scene::Integrator integrator);
  /// Tells whether frames to come have ambient occlusion. The kernel for it is compiled beforehand
  /// only if they have, which is assumed until this is called.
  void expect_ambient_occlusion(bool is_expected) { ambient_expected_ = is_expected; }
  bool has_programs() const { return built().programs.has_value(); }
  /// Waits for the kernels for at most `patience`, and returns whether they are built. Call it
  /// after `begin_programs`.
  bool await_programs(std::chrono::milliseconds patience);
  /// Returns the progress of the kernels from 0 to 1. It may be called from any thread.
  double programs_fraction() const { return built().progress.fraction(); }
  double program_seconds() const { return built().programs->seconds; }

  /// Gives the geometry to the device (see `upload`) in place of the former one.
  void set_geometry(const std::shared_ptr<const bvh::Bvh>& tree,
                    const std::shared_ptr<const FrameArrays>& frame,
                    const std::function<void()>& between);
  void drop_geometry() { geometry_ = {}; }
  const DeviceGeometry& geometry() const { return geometry_; }

  /// Throws Error{exhausted} if the need is more than the device may have, before anything of it is
  /// allocated.
  void require_room(const MemoryNeed& need) const;

  /// Gives the scene to the device, and allocates a film of `pixels` pixels, with guides if the
  /// options ask for them.
  void begin_frame(const pack::PackedScene& scene, std::size_t pixels);

  /// Begins an empty film of these pixels of the image. They must be at most as many as
  /// `begin_frame` allocated. Only a film of all layers has guides.
  void begin_film(const Crop& window, Layers layers);

  /// Fills the film with the sums of a render that goes on. They must fit its window.
  void set_sums(const FilmSums& sums);

  /// Copies the rows y0 <= y < y1 of the image from another device's film of the same window.
  void adopt(int y0, int y1, const DeviceFilm& from);

  /// Marks those pixels of the film as converged that have enough samples. Call it between passes.
  void mark_converged(const AeroConvergence& convergence);

  /// Renders rows of `queue` as device number `index` until no row is left or `stop` is requested.
  /// After a stop, launches may still be running when it returns. `film_of(i)` is the film of
  /// device i.
  void trace(const Pass& pass, RowQueue& queue, int index,
             const std::function<const DeviceFilm&(int)>& film_of, const std::stop_token& stop);

  /// Returns the film with the sums over the samples so far. Reading it waits for the launches.
  const DeviceFilm& film() const { return frame_.film; }

  /// Returns the number of eye rays that are done. It counts those whose light is in the film, and
  /// those that converged pixels did not need. It may be called from any thread.
  std::uint64_t rays_done() const { return rays_done_; }
  /// Returns the statistics of the film so far. It must not be called during `trace`.
  DeviceStats stats() const;

 private:
  void set_texels(const pack::Texels& texels);

  struct Launch {
    std::vector<StageEvent> events;
    std::uint64_t rays = 0;
  };

  int rows_at_once(const Pass& pass, const PacketShape& shape) const;
  void launch_rows(AeroLaunch& launch, const Crop& area, const PacketShape& shape,
                   std::uint32_t first_sample);
  void reserve(std::uint64_t packets);
  void launch_tile(const AeroLaunch& launch);
  void retire(std::size_t most_in_flight);

  int lanes_;
  opencl::Context context_;
  opencl::MemoryBudget budget_;
  TestHooks hooks_;
  /// The layers that films can have.
  Layers layers_;
  /// The programs of an integrator.
  struct Built {
    std::optional<Programs> programs;
    KernelProgress progress;
    /// The programs that are being built. They outlive a render that is given up.
    std::future<Programs> to_come;
  };

  Built& built() { return built_[static_cast<std::size_t>(integrator_.load())]; }
  const Built& built() const { return built_[static_cast<std::size_t>(integrator_.load())]; }

  std::atomic<bool> ambient_expected_ = true;
  std::atomic<scene::Integrator> integrator_ = scene::Integrator::local;
  std::array<Built, scene::kIntegratorCount> built_;
  DeviceGeometry geometry_;
  FrameBuffers frame_;
  /// The kernels for surfaces that let rays pass. They are built for the first scene that has some.
  std::shared_ptr<const SeeThroughKernels> see_through_;
  /// The kernel for mirrors. It is built for the first scene with models from files.
  std::shared_ptr<const MirrorKernels> mirrors_;
  /// The texels that the frame has.
  pack::Texels texels_;
  /// The pixels of the image that the film holds.
  Crop window_;
  /// Tells whether pixels of the frame may be converged.
  bool some_converged_ = false;
  /// The packets that the integrator has room for.
  std::uint64_t packets_capacity_ = 0;
  /// The most packets of a launch for which there was room, or 0 if there always was.
  std::uint64_t most_packets_ = 0;

  std::deque<Launch> in_flight_;
  std::atomic<std::uint64_t> rays_done_ = 0;
  /// The eye rays per second, smoothed over launches.
  double rate_ = 0.0;
  DeviceStats stats_;
};

}  // namespace aerostat::render

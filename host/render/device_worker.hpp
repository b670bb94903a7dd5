#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>

#include "render/film_buffer.hpp"
#include "render/geometry.hpp"
#include "render/programs.hpp"
#include "render/row_queue.hpp"
#include "render/session.hpp"
#include "render/tiles.hpp"
#include "scene_params.h"

namespace aerostat::render {

/// A number of samples for every pixel of an area, which lies in the window of the film.
struct Pass {
  AeroFrame frame{};
  Crop area;
  int first_sample = 0;
  int samples = 0;      // per pixel: a power of two
  int tile_pixels = 0;  // as in Options
  double launch_seconds = 0.03;
};

/// One device at work on a frame: its programs, its copy of the scene, its film and its launches.
/// Used from one thread at a time, except where it says otherwise. What the parts throw comes out
/// as it is.
class DeviceWorker {
 public:
  /// Of `options`: `lanes`, `memory_limit_bytes` and `before_launch`.
  DeviceWorker(const opencl::Device& device, const Options& options);

  const opencl::Device& device() const { return context_.device(); }
  int lanes() const { return lanes_; }

  /// Begins to build the kernels in the background, if they are not there.
  void begin_programs();
  bool has_programs() const { return programs_.has_value(); }
  /// Whether they are there after at most `patience`. Not before `begin_programs`.
  bool await_programs(std::chrono::milliseconds patience);
  /// How far they are, from 0 to 1. From any thread.
  double programs_fraction() const { return kernel_progress_.fraction(); }
  double program_seconds() const { return programs_->seconds; }

  /// Gives the geometry to the device (see `upload`), or takes it away.
  void set_geometry(const std::shared_ptr<const bvh::Bvh>& tree,
                    const std::shared_ptr<const FrameArrays>& frame,
                    const std::function<void()>& between);
  void drop_geometry() { geometry_ = {}; }
  const DeviceGeometry& geometry() const { return geometry_; }

  /// Gives the scene to the device, and room for films of as many pixels.
  void begin_frame(const AeroScene& scene, std::size_t pixels);

  /// Begins with an empty film of these pixels of the image, at most as many as there is room for.
  void begin_film(const Crop& window);

  /// Takes over rows y0 <= y < y1 of the image from another device's film of the same window.
  void adopt(int y0, int y1, const FilmBuffer& from);

  /// Marks as converged the pixels of the film that have samples enough. Between passes.
  void mark_converged(const AeroConvergence& convergence);

  /// Renders rows of `queue` as device number `index` until none is left or `stop` is requested; in
  /// that case launches may be under way when it returns. `film_of(i)` is the film of device i.
  void trace(const Pass& pass, RowQueue& queue, int index,
             const std::function<const FilmBuffer&(int)>& film_of, const std::stop_token& stop);

  /// The sums over the samples so far. Reading waits for launches.
  const FilmBuffer& film() const { return film_; }

  /// Eye rays whose light is in the film, and those that converged pixels had no need of. From any
  /// thread.
  std::uint64_t rays_done() const { return rays_done_; }
  /// Of the film so far. Not during `trace`.
  DeviceStats stats() const;

 private:
  struct Launch {
    cl::Event camera, shadow, shade;
    std::optional<cl::Event> ambient;
    std::uint64_t rays = 0;
  };

  int rows_at_once(const Pass& pass, const PacketShape& shape) const;
  void reserve(std::uint64_t packets);
  void launch_tile(const AeroLaunch& launch);
  void retire(std::size_t most_in_flight);

  int lanes_;
  opencl::Context context_;
  opencl::MemoryBudget budget_;
  std::function<void(const opencl::Device&)> before_launch_;
  std::optional<Programs> programs_;
  KernelProgress kernel_progress_;
  std::future<Programs> programs_to_come_;  // outlives a render that is given up
  DeviceGeometry geometry_;
  opencl::Buffer<AeroScene> scene_;
  FilmBuffer film_;
  Crop window_;                  // of the image, that the film holds
  bool occlusion_ = false;       // whether the frame asks for ambient occlusion
  bool some_converged_ = false;  // pixels of the frame may be
  opencl::RawBuffer hits_, visible_, found_;
  std::uint64_t packets_capacity_ = 0;

  std::deque<Launch> in_flight_;
  std::atomic<std::uint64_t> rays_done_ = 0;
  double rate_ = 0.0;  // eye rays per second, smoothed
  DeviceStats stats_;
};

}  // namespace aerostat::render

#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "render/device_worker.hpp"
#include "render/film_sums.hpp"
#include "render/memory_need.hpp"

namespace aerostat::render {

/// How often a thread that waits for devices is told so.
inline constexpr std::chrono::milliseconds kWaitingEvery(20);

/// Several devices that work as one. The team has what each device needs for a frame, and shares
/// out the rows of the frame. If there are several devices, an Error of one of them names it.
class DeviceTeam {
 public:
  /// A function that is called every 20 ms while something takes its time. It may give up by
  /// throwing.
  using Waiting = std::function<void()>;

  /// Makes a team of the devices in `options`. Throws Error{internal} if there are none.
  DeviceTeam(const Options& options, const TestHooks& hooks);

  /// Returns the lanes of the device with the widest packets.
  int lanes() const { return lanes_; }

  /// Calls the function of the same name in DeviceWorker for all devices, as do the functions up to
  /// begin_film.
  void begin_programs(scene::Integrator integrator);
  void expect_ambient_occlusion(bool is_expected);
  void drop_geometry();
  void set_geometry(const std::shared_ptr<const bvh::Bvh>& tree,
                    const std::shared_ptr<const FrameArrays>& frame,
                    const std::function<void()>& between);
  void require_room(const MemoryNeed& need);
  void begin_frame(const pack::PackedScene& scene, std::size_t pixels);
  void begin_film(const Crop& window, Layers layers);

  /// Waits for programs that are being built, and tells `waiting` the progress of all devices
  /// together, from 0 to 1. Returns how many programs were built since the last call, and adds to
  /// `seconds` the time of the slowest device.
  int await_programs(const std::function<void(double)>& waiting, double& seconds);

  /// Marks the converged pixels of the film between passes. `queue` tells which device holds which
  /// rows.
  void mark_converged(const AeroConvergence& convergence, const RowQueue& queue);

  /// Gives the first device the sums of a render that goes on. Call it after `begin_film`, for a
  /// queue whose rows that device holds.
  void set_sums(const FilmSums& sums);

  /// Renders the rows that wait in `queue` on all devices, as a part of the pass. Returns early
  /// when `stop` is requested, and launches may still be running then.
  void trace(const Pass& pass, RowQueue& queue, const std::stop_token& stop,
             const Waiting& waiting);

  /// Returns the films that hold the rows of `queue`. Rows that nobody has rendered are empty.
  std::vector<FilmRows> film_rows(const RowQueue& queue) const;

  /// Returns the number of eye rays that are done. It counts those whose light is in the films, and
  /// those that converged pixels did not need.
  std::uint64_t rays_done() const;

  const DeviceGeometry& geometry() const { return workers_.front()->geometry(); }
  std::vector<DeviceStats> stats() const;

 private:
  template <typename F>
  void on_each(F&& f);
  template <typename F>
  auto on(DeviceWorker& worker, F&& f) -> decltype(f());
  double programs_fraction() const;
  const DeviceWorker& worker(int index) const { return *workers_[static_cast<std::size_t>(index)]; }

  std::vector<std::unique_ptr<DeviceWorker>> workers_;
  int lanes_ = 1;
};

}  // namespace aerostat::render

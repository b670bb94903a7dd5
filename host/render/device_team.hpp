#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "render/device_worker.hpp"

namespace aerostat::render {

/// Several devices as one: what each of them needs for a frame, and the frame shared out to them by
/// rows. What goes wrong on one of several comes out as an Error that names it.
class DeviceTeam {
 public:
  /// Called every 20 ms while something takes its time; may give up by throwing.
  using Waiting = std::function<void()>;

  /// Of the devices in `options`. Throws Error{internal} if there are none.
  explicit DeviceTeam(const Options& options);

  /// Of the device with the widest packets.
  int lanes() const { return lanes_; }

  /// As of DeviceWorker, for all of them.
  void begin_programs();
  void drop_geometry();
  void set_geometry(const std::shared_ptr<const bvh::Bvh>& tree,
                    const std::shared_ptr<const FrameArrays>& frame,
                    const std::function<void()>& between);
  void begin_frame(const AeroScene& scene, std::size_t pixels);
  void begin_film(const Crop& window);

  /// Waits for programs that were begun, and tells `waiting` how far those of all devices are, from
  /// 0 to 1. Returns how many were built since the last call, and adds to `seconds` what the
  /// slowest device took.
  int await_programs(const std::function<void(double)>& waiting, double& seconds);

  /// Marks converged pixels of the film, whose rows lie where `queue` says, between passes.
  void mark_converged(const AeroConvergence& convergence, const RowQueue& queue);

  /// Renders the pass on all devices; returns early, with work under way, when `stop` is requested.
  void trace(const Pass& pass, RowQueue& queue, const std::stop_token& stop,
             const Waiting& waiting);

  /// Where the rows of `queue` lie after whole passes.
  std::vector<FilmRows> film_rows(const RowQueue& queue) const;

  /// Eye rays of the film whose light is in the films or that converged pixels had no need of.
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

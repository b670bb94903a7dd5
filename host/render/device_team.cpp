#include "render/device_team.hpp"

#include <algorithm>
#include <future>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::render {
namespace {

/// Ends a pass for all devices when one of them, or the thread that waits for them, gives up.
struct Closing {
  RowQueue& queue;
  ~Closing() { queue.close(); }
};

}  // namespace

DeviceTeam::DeviceTeam(const Options& options, const TestHooks& hooks) {
  if (options.devices.empty()) throw Error(ErrorKind::internal, "there is no device to render on");
  for (const opencl::Device& device : options.devices) {
    workers_.push_back(std::make_unique<DeviceWorker>(device, options, hooks));
    lanes_ = std::max(lanes_, workers_.back()->lanes());
  }
}

/// Runs `f`. If it fails and there are several devices, the error names the device.
template <typename F>
auto DeviceTeam::on(DeviceWorker& worker, F&& f) -> decltype(f()) {
  try {
    return f();
  } catch (const Error& error) {
    if (workers_.size() == 1 || error.kind() == ErrorKind::interrupted) throw;
    throw Error(error.kind(),
                fmt::format("on {}: {}", opencl::describe(worker.device()), error.what()));
  }
}

template <typename F>
void DeviceTeam::on_each(F&& f) {
  for (const auto& worker : workers_) {
    on(*worker, [&] { f(*worker); });
  }
}

void DeviceTeam::begin_programs(scene::Integrator integrator) {
  on_each([integrator](DeviceWorker& worker) { worker.begin_programs(integrator); });
}

void DeviceTeam::expect_ambient_occlusion(bool is_expected) {
  on_each([is_expected](DeviceWorker& worker) { worker.expect_ambient_occlusion(is_expected); });
}

void DeviceTeam::drop_geometry() {
  on_each([](DeviceWorker& worker) { worker.drop_geometry(); });
}

void DeviceTeam::set_geometry(const std::shared_ptr<const bvh::Bvh>& tree,
                              const std::shared_ptr<const FrameArrays>& frame,
                              const std::function<void()>& between) {
  on_each([&](DeviceWorker& worker) { worker.set_geometry(tree, frame, between); });
}

void DeviceTeam::require_room(const MemoryNeed& need) {
  on_each([&](DeviceWorker& worker) { worker.require_room(need); });
}

void DeviceTeam::begin_frame(const pack::PackedScene& scene, std::size_t pixels) {
  on_each([&](DeviceWorker& worker) { worker.begin_frame(scene, pixels); });
}

void DeviceTeam::begin_film(const Crop& window, Layers layers) {
  on_each([&](DeviceWorker& worker) { worker.begin_film(window, layers); });
}

double DeviceTeam::programs_fraction() const {
  double sum = 0.0;
  for (const auto& worker : workers_) sum += worker->programs_fraction();
  return sum / static_cast<double>(workers_.size());
}

int DeviceTeam::await_programs(const std::function<void(double)>& waiting, double& seconds) {
  int built = 0;
  double slowest = 0.0;
  on_each([&](DeviceWorker& worker) {
    if (worker.has_programs()) return;
    do {
      waiting(programs_fraction());
    } while (!worker.await_programs(kWaitingEvery));
    built += kProgramCount;
    slowest = std::max(slowest, worker.program_seconds());
  });
  seconds += slowest;
  return built;
}

void DeviceTeam::mark_converged(const AeroConvergence& convergence, const RowQueue& queue) {
  // A pixel asks its neighbours, which another device may hold. So each device gets copies of the
  // rows beside its own.
  const std::vector<RowRun> runs = queue.held();
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const RowRun &above = runs[i - 1], &below = runs[i];
    DeviceWorker& upper = *workers_[static_cast<std::size_t>(above.holder)];
    DeviceWorker& lower = *workers_[static_cast<std::size_t>(below.holder)];
    on(upper, [&] { upper.adopt(below.y0, below.y0 + 1, lower.film()); });
    on(lower, [&] { lower.adopt(above.y1 - 1, above.y1, upper.film()); });
  }
  on_each([&](DeviceWorker& worker) { worker.mark_converged(convergence); });
}

void DeviceTeam::set_sums(const FilmSums& sums) {
  DeviceWorker& first = *workers_.front();
  on(first, [&] { first.set_sums(sums); });
}

/// Renders the pass on one thread for each device, while this thread waits for them.
void DeviceTeam::trace(const Pass& pass, RowQueue& queue, const std::stop_token& stop,
                       const Waiting& waiting) {
  const auto film_of = [this](int index) -> const DeviceFilm& { return worker(index).film(); };
  std::vector<std::future<void>> running;
  const Closing closing{queue};
  for (int index = 0; index < static_cast<int>(workers_.size()); ++index) {
    DeviceWorker& worker = *workers_[static_cast<std::size_t>(index)];
    running.push_back(std::async(std::launch::async, [&, index] {
      const Closing ending{queue};
      on(worker, [&] { worker.trace(pass, queue, index, film_of, stop); });
    }));
  }
  for (auto& one : running) {
    do {
      waiting();
    } while (one.wait_for(kWaitingEvery) != std::future_status::ready);
  }
  for (auto& one : running) one.get();
}

std::vector<FilmRows> DeviceTeam::film_rows(const RowQueue& queue) const {
  std::vector<FilmRows> parts;
  for (const RowRun& run : queue.held()) {
    // Each device cleared its whole film, so the first one has the rows that nobody holds.
    parts.push_back({run.y0, run.y1, &worker(std::max(run.holder, 0)).film()});
  }
  return parts;
}

std::uint64_t DeviceTeam::rays_done() const {
  std::uint64_t rays = 0;
  for (const auto& worker : workers_) rays += worker->rays_done();
  return rays;
}

std::vector<DeviceStats> DeviceTeam::stats() const {
  std::vector<DeviceStats> all;
  for (const auto& worker : workers_) all.push_back(worker->stats());
  return all;
}

}  // namespace aerostat::render

#include "render/device_worker.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "render/film_sums.hpp"
#include "render/memory_need.hpp"

namespace aerostat::render {
namespace {

// The limits of one launch in eye rays, and of launches in flight. Launches are short, so that no
// watchdog of a driver ends them and an interrupt is answered in time. Chosen by eye.
constexpr std::uint64_t kFirstLaunchRays = 1u << 15;
constexpr std::uint64_t kMostLaunchRays = 1u << 20;
constexpr std::size_t kLaunchesInFlight = 2;

std::uint64_t pixels_of(const AeroTile& tile) {
  return std::uint64_t{tile.x1 - tile.x0} * (tile.y1 - tile.y0);
}

std::uint32_t log2_lanes_of(const PacketShape& shape) {
  return shape.log2_w + shape.log2_h + shape.log2_samples;
}

template <typename T>
void copy_rows(const opencl::Buffer<T>& from, opencl::Buffer<T>& to, std::size_t first,
               std::size_t count) {
  std::vector<T> rows(count);
  from.read(std::span(rows), first);
  to.write(rows, first);
}

}  // namespace

DeviceWorker::DeviceWorker(const opencl::Device& device, const Options& options, TestHooks hooks)
    : lanes_(options.lanes != 0 ? options.lanes : device.lanes),
      context_(device),
      budget_(options.memory_limit_bytes != 0
                  ? opencl::MemoryBudget(options.memory_limit_bytes)
                  : opencl::MemoryBudget(device.memory_bytes, device.memory_bound)),
      hooks_(std::move(hooks)),
      layers_(layers_of(options)) {}

void DeviceWorker::begin_programs(scene::Integrator integrator) {
  if (integrator != integrator_) {
    packets_capacity_ = 0;
    most_packets_ = 0;
    rate_ = 0.0;
  }
  integrator_ = integrator;
  if (has_programs() || built().to_come.valid()) return;
  built().to_come = std::async(std::launch::async, [this, integrator, &now = built()] {
    return build_programs(context_, lanes_, integrator, layers_ == Layers::all, ambient_expected_,
                          now.progress);
  });
}

bool DeviceWorker::await_programs(std::chrono::milliseconds patience) {
  if (has_programs()) return true;
  if (built().to_come.wait_for(patience) != std::future_status::ready) return false;
  built().programs = built().to_come.get();
  return true;
}

void DeviceWorker::set_geometry(const std::shared_ptr<const bvh::Bvh>& tree,
                                const std::shared_ptr<const FrameArrays>& frame,
                                const std::function<void()>& between) {
  geometry_ = upload(context_, budget_, tree, frame, between);
}

void DeviceWorker::require_room(const MemoryNeed& need) const {
  render::require_room(need, budget_.limit(), budget_.bound());
}

void DeviceWorker::begin_frame(const pack::PackedScene& scene, std::size_t pixels) {
  in_flight_.clear();
  const AeroScene& numbers = scene.numbers;
  frame_.ambient_occlusion = numbers.sky.ambient_reach > 0.0f;
  frame_.lamps = numbers.light_count > 0;
  frame_.bounces = numbers.bounces;
  frame_.scene = {context_, budget_, std::span(&numbers, 1), "the scene"};
  frame_.sky_table = {context_, budget_, std::span(scene.sky_table), "the table of the sky"};
  frame_.sky_importance = {};
  if (scene.sky_importance) {
    frame_.sky_importance = {context_, budget_, std::span(&*scene.sky_importance, 1),
                             "the importance of the sky"};
  }
  frame_.cloud_chart = {};
  if (scene.cloud_chart) {
    frame_.cloud_chart = {context_, budget_, scene.cloud_chart, std::span(scene.cloud_chart->words),
                          "the chart of clouds"};
  }
  if (!(scene.texels == texels_)) set_texels(scene.texels);
  if (scene.see_through && !see_through_) see_through_ = build_see_through(context_, lanes_);
  frame_.see_through = scene.see_through ? see_through_ : nullptr;
  if (scene.mirrors && !mirrors_) mirrors_ = build_mirrors(context_, lanes_);
  frame_.mirrors = scene.mirrors ? mirrors_ : nullptr;
  if (frame_.film.pixels.size() == pixels) return;
  frame_.film = {};
  frame_.film.pixels = {
      context_, budget_, pixels, "the film", opencl::Access::read_write, opencl::Content::unset};
  if (layers_ != Layers::all) return;
  frame_.film.guides = {context_,
                        budget_,
                        pixels,
                        "the guides of the film",
                        opencl::Access::read_write,
                        opencl::Content::unset};
}

/// Gives the texels to the device in place of the former ones. Those of one picture need no copy.
void DeviceWorker::set_texels(const pack::Texels& texels) {
  constexpr const char* kWhat = "the texels of pictures";
  frame_.texels = {};
  texels_ = {};
  const auto& parts = texels.parts();
  if (parts.size() == 1) {
    frame_.texels = {context_, budget_, parts.front().owner, parts.front().words, kWhat};
  } else if (parts.size() > 1) {
    frame_.texels = {
        context_, budget_, texels.size(), kWhat, opencl::Access::read, opencl::Content::unset};
    std::size_t first = 0;
    for (const auto& part : parts) {
      frame_.texels.write(part.words, first);
      first += part.words.size();
    }
  }
  texels_ = texels;
}

void DeviceWorker::begin_film(const Crop& window, Layers layers) {
  in_flight_.clear();
  rays_done_ = 0;
  some_converged_ = false;
  stats_ = {};
  window_ = window;
  frame_.guides = layers == Layers::all;
  const auto pixels = static_cast<std::uint32_t>(window.pixels());
  const opencl::LaunchSize range = packet_range(pixels, 1);
  opencl::launch(context_, built().programs->clear_film, range, frame_.film.pixels, pixels);
  if (!frame_.guides) return;
  opencl::launch(context_, built().programs->clear_guides, range, frame_.film.guides, pixels);
}

void DeviceWorker::set_sums(const FilmSums& sums) {
  some_converged_ = std::any_of(sums.pixels.begin(), sums.pixels.end(),
                                [](const AeroFilmPixel& pixel) { return pixel.converged != 0; });
  frame_.film.pixels.write(sums.pixels);
  if (frame_.guides) frame_.film.guides.write(sums.guides);
}

void DeviceWorker::mark_converged(const AeroConvergence& convergence) {
  some_converged_ = true;
  opencl::launch(context_, built().programs->mark_converged, packet_range(window_.pixels(), 1),
                 frame_.film.pixels, convergence);
}

/// Returns the number of rows that keep the device busy for the time of a launch. If a packet holds
/// fewer samples than the pass asks for, the rows need several launches.
int DeviceWorker::rows_at_once(const Pass& pass, const PacketShape& shape) const {
  const auto launches = static_cast<std::uint64_t>(pass.samples >> shape.log2_samples);
  std::uint64_t rays = kFirstLaunchRays * launches;
  if (pass.tile_pixels > 0) {
    rays = static_cast<std::uint64_t>(pass.tile_pixels);
  } else if (rate_ > 0.0) {
    rays = std::clamp(static_cast<std::uint64_t>(rate_ * pass.launch_seconds),
                      kFirstLaunchRays / 16, kMostLaunchRays * launches);
  }
  const auto width = static_cast<std::uint64_t>(pass.area.x1 - pass.area.x0);
  if (most_packets_ > 0) rays = std::min(rays, (most_packets_ * launches) << log2_lanes_of(shape));
  const std::uint64_t block_row = (width * launches) << (shape.log2_h + shape.log2_samples);
  return static_cast<int>(std::max<std::uint64_t>(1, rays / block_row)) << shape.log2_h;
}

void DeviceWorker::trace(const Pass& pass, RowQueue& queue, int index,
                         const std::function<const DeviceFilm&(int)>& film_of,
                         const std::stop_token& stop) {
  const PacketShape shape = packet_shape(lanes_, pass.samples);
  AeroLaunch launch{pass.frame, {}, window_of(window_)};
  while (!stop.stop_requested()) {
    const auto run = queue.next(index, 1 << shape.log2_h, rows_at_once(pass, shape));
    if (!run) break;
    if (run->holder != index && run->holder != RowQueue::kNobody) {
      adopt(run->y0, run->y1, film_of(run->holder));
    }
    const Crop area{pass.area.x0, run->y0, pass.area.x1, run->y1};
    for (int done = 0; done < pass.samples; done += 1 << shape.log2_samples) {
      if (stop.stop_requested()) return;
      launch_rows(launch, area, shape, static_cast<std::uint32_t>(pass.first_sample + done));
    }
  }
  if (!stop.stop_requested()) retire(0);
}

/// Launches a tile, or its halves one after the other if there is no room for the buffers of all of
/// its packets.
void DeviceWorker::launch_rows(AeroLaunch& launch, const Crop& area, const PacketShape& shape,
                               std::uint32_t first_sample) {
  launch.tile = tile_of(area, shape, first_sample);
  const int least = 1 << shape.log2_h, rows = area.y1 - area.y0;
  try {
    reserve(launch.tile.block_count);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::exhausted || rows <= least) throw;
    most_packets_ = std::max<std::uint64_t>(1, launch.tile.block_count / 2);
    const int middle = area.y0 + (rows / 2 + least - 1) / least * least;
    launch_rows(launch, {area.x0, area.y0, area.x1, middle}, shape, first_sample);
    launch_rows(launch, {area.x0, middle, area.x1, area.y1}, shape, first_sample);
    return;
  }
  launch_tile(launch);
  retire(kLaunchesInFlight - 1);
}

/// Copies these rows from the film of another device, so that their sums are continued in the same
/// order of samples.
void DeviceWorker::adopt(int y0, int y1, const DeviceFilm& from) {
  const auto width = static_cast<std::size_t>(window_.x1 - window_.x0);
  const std::size_t first = static_cast<std::size_t>(y0 - window_.y0) * width;
  const std::size_t count = static_cast<std::size_t>(y1 - y0) * width;
  copy_rows(from.pixels, frame_.film.pixels, first, count);
  if (frame_.guides) copy_rows(from.guides, frame_.film.guides, first, count);
}

/// Lets the integrator allocate the buffers that its kernels hand to each other.
void DeviceWorker::reserve(std::uint64_t packets) {
  if (packets <= packets_capacity_) return;
  retire(0);
  packets_capacity_ = 0;
  built().programs->integrator->reserve(context_, budget_, packets, lanes_);
  packets_capacity_ = packets;
}

void DeviceWorker::launch_tile(const AeroLaunch& launch) {
  if (hooks_.before_launch) hooks_.before_launch(device());
  const std::uint64_t packets = launch.tile.block_count;
  Launch work;
  work.rays = pixels_of(launch.tile) << launch.tile.log2_samples;
  work.events = built().programs->integrator->launch(
      context_, launch, packet_range(packets, lanes_), geometry_, frame_);
  in_flight_.push_back(std::move(work));
}

/// Waits for the oldest launches and counts their rays, until at most `most_in_flight` are left.
void DeviceWorker::retire(std::size_t most_in_flight) {
  while (in_flight_.size() > most_in_flight) {
    const Launch work = std::move(in_flight_.front());
    in_flight_.pop_front();
    double spent = 0.0;
    // The time is taken from the clock of the device, because the clock of the host tells nothing
    // when several launches end while the host sleeps.
    for (const auto& [stage, event] : work.events) {
      const double seconds = opencl::device_seconds(event);
      stats_.seconds[stage] += seconds;
      spent += seconds;
    }
    rays_done_ += work.rays;
    // Converged pixels take no time, so a rate with them would be wrong for the others.
    if (spent > 0.0 && !some_converged_) {
      const double now_rate = static_cast<double>(work.rays) / spent;
      rate_ = rate_ <= 0.0 ? now_rate : 0.7 * rate_ + 0.3 * now_rate;
    }
  }
}

DeviceStats DeviceWorker::stats() const {
  DeviceStats stats = stats_;
  stats.selector = device().selector();
  stats.name = device().name;
  stats.primary_rays = rays_done_;
  stats.bytes = budget_.used();
  return stats;
}

}  // namespace aerostat::render

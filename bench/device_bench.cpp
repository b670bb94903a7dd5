#include "device_bench.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "opencl/launch.hpp"
#include "pack/pack_scene.hpp"
#include "render/programs.hpp"
#include "scene/scene.hpp"

namespace aerostat::bench {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(ErrorKind::io, "cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the product's kernels together with those of the bench.
opencl::SourceTree with_bench(opencl::SourceTree sources) {
  const std::filesystem::path folder = AEROSTAT_BENCH_KERNEL_DIR;
  sources["bench_rays.cl"] = read_text(folder / "bench_rays.cl");
  sources["count_rays.cl"] = read_text(folder / "count_rays.cl");
  sources["device/ray_buffer.clh"] = read_text(folder / "ray_buffer.clh");
  sources["device/bounce.clh"] = read_text(folder / "bounce.clh");
  return sources;
}

}  // namespace

std::uint64_t RaySet::active() const {
  std::uint64_t count = 0;
  for (std::size_t packet = 0; packet < packets; ++packet) {
    const float* t_max = data.data() + (packet * 8 + 3) * static_cast<std::size_t>(lanes);
    count += static_cast<std::uint64_t>(
        std::count_if(t_max, t_max + lanes, [](float t) { return t >= 0.0f; }));
  }
  return count;
}

DeviceBench::DeviceBench(const opencl::Device& device, int lanes, const scene::ResolvedScene& shown,
                         const render::Frame& frame, const opencl::SourceTree& kernels)
    : lanes_(lanes != 0 ? lanes : device.lanes), context_(device) {
  device_ = render::upload(context_, budget_, frame.tree, frame.arrays);
  const auto sources = with_bench(kernels);
  trace_camera_ =
      opencl::Program(context_, sources, "trace_camera.cl", lanes_).kernel("trace_camera_rays");
  trace_shadow_ =
      opencl::Program(context_, sources, "trace_shadow.cl", lanes_).kernel("trace_shadow_rays");
  const opencl::Program bench(context_, sources, "bench_rays.cl", lanes_);
  write_camera_ = bench.kernel("write_camera_rays");
  write_shadow_ = bench.kernel("write_shadow_rays");
  write_bounce_ = bench.kernel("write_bounce_rays");
  trace_rays_ = bench.kernel("trace_rays");
  count_rays_ = opencl::Program(context_, sources, "count_rays.cl", lanes_).kernel("count_rays");

  scene::Image image = shown->image;
  image.spp = 1;
  launch_.frame = pack::pack_frame(shown.with_image(image));
  const render::Crop all{0, 0, image.width, image.height};
  launch_.tile = render::tile_of(all, render::packet_shape(lanes_, 1), 0);
  launch_.film = render::window_of(all);
  const auto packed = pack::pack_scene(shown);
  scene_ = {context_, budget_, std::span(&packed.numbers, 1), "the scene"};
  const std::vector<AeroFilmPixel> film(std::size_t{launch_.frame.width} * launch_.frame.height);
  film_ = {context_, budget_, std::span(film), "the film"};
  const std::size_t rays = std::size_t{launch_.tile.block_count} * static_cast<std::size_t>(lanes_);
  hits_ = {context_, budget_, rays, "the hits"};
  visible_ = {context_, budget_, rays, "the shadows"};
  rays_ = {context_, budget_, rays * 8, "the rays"};
}

opencl::LaunchSize DeviceBench::size() const {
  return render::packet_range(launch_.tile.block_count, lanes_);
}

RaySet DeviceBench::camera_rays() {
  rays_on_device_ = nullptr;
  opencl::launch(context_, write_camera_, size(), launch_, rays_);
  return {lanes_, launch_.tile.block_count, rays_.read()};
}

RaySet DeviceBench::shadow_rays() {
  rays_on_device_ = nullptr;
  time_camera_kernel();
  opencl::launch(context_, write_shadow_, size(), launch_, scene_, device_.instances, device_.grid,
                 device_.faces, device_.vertices, hits_, rays_);
  return {lanes_, launch_.tile.block_count, rays_.read()};
}

RaySet DeviceBench::bounce_rays() {
  rays_on_device_ = nullptr;
  time_camera_kernel();
  opencl::launch(context_, write_bounce_, size(), launch_, device_.instances, device_.grid,
                 device_.faces, device_.vertices, hits_, rays_);
  return {lanes_, launch_.tile.block_count, rays_.read()};
}

double DeviceBench::time_camera_kernel() {
  return opencl::device_seconds(opencl::launch(context_, trace_camera_, size(), launch_,
                                               device_.nodes, device_.triangles, device_.instances,
                                               device_.grid, film_, hits_));
}

double DeviceBench::time_shadow_kernel() {
  time_camera_kernel();
  return opencl::device_seconds(opencl::launch(
      context_, trace_shadow_, size(), launch_, scene_, device_.nodes, device_.triangles,
      device_.instances, device_.grid, device_.faces, device_.vertices, hits_, visible_));
}

const opencl::Buffer<float>& DeviceBench::uploaded(const RaySet& rays) {
  if (rays_on_device_ != &rays) rays_.write(std::span(rays.data));
  rays_on_device_ = &rays;
  return rays_;
}

double DeviceBench::time_rays(const RaySet& rays, bool any_hit) {
  return opencl::device_seconds(opencl::launch(context_, trace_rays_, size(), device_.nodes,
                                               device_.triangles, device_.instances, device_.grid,
                                               uploaded(rays), static_cast<std::uint32_t>(any_hit),
                                               static_cast<std::uint32_t>(rays.packets), hits_));
}

PacketCounts DeviceBench::count(const RaySet& rays, bool any_hit) {
  opencl::Buffer<std::uint32_t> counters(context_, budget_, std::size_t{rays.packets} * 4,
                                         "the counters");
  opencl::launch(context_, count_rays_, size(), device_.nodes, device_.triangles, device_.instances,
                 device_.grid, uploaded(rays), static_cast<std::uint32_t>(any_hit),
                 static_cast<std::uint32_t>(rays.packets), counters);
  double sums[4] = {};
  const auto values = counters.read();
  for (std::size_t i = 0; i < values.size(); ++i) sums[i % 4] += values[i];
  const double packets = std::max(1.0, sums[0]);
  return {sums[1] / packets, sums[2] / packets, sums[3] / packets};
}

}  // namespace aerostat::bench

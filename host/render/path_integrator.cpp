#include "render/integrator.hpp"

namespace aerostat::render {
namespace {

/// The rays to lights that each surface of a path asks for (LIGHT_RAYS of integrator/path.clh).
constexpr std::uint32_t kLightRays = 3;
/// The ray that a scene without lamps does without (RAY_TO_LAMP).
constexpr std::uint32_t kRayToLamp = 2;

/// Paths that go from surface to surface. All paths of a tile reach their next surfaces together.
class PathIntegrator final : public Integrator {
 public:
  explicit PathIntegrator(PathKernels kernels) : kernels_(std::move(kernels)) {}

  void reserve(const opencl::Context& context, const opencl::MemoryBudget& budget,
               std::uint64_t packets, int lanes) override {
    hits_ = {};
    paths_ = {};
    const std::size_t rays = packets * static_cast<std::size_t>(lanes);
    hits_ = {context, budget, rays, "the hits"};
    paths_ = {context, budget, rays, "the paths"};
  }

  std::vector<StageEvent> launch(const opencl::Context& context, const AeroLaunch& launch,
                                 const opencl::LaunchSize& size, const DeviceGeometry& geometry,
                                 const FrameBuffers& frame) const override {
    std::vector<StageEvent> events;
    const std::uint32_t blocks = launch.tile.block_count;
    events.emplace_back(KernelStage::shading, opencl::launch(context, kernels_.start_paths, size,
                                                             launch, frame.film.pixels, paths_));
    // After the last surface, paths still look for the sky and for surfaces that shine.
    for (std::uint32_t bounce = 0; bounce <= frame.bounces + 1; ++bounce) {
      events.emplace_back(
          bounce == 0 ? KernelStage::primary : KernelStage::bounced,
          opencl::launch(context, kernels_.extend_paths, size, blocks, geometry.nodes,
                         geometry.triangles, geometry.instances, geometry.grid, paths_, hits_));
      if (frame.see_through) {
        events.emplace_back(
            bounce == 0 ? KernelStage::primary : KernelStage::bounced,
            opencl::launch(context, frame.see_through->pass_path_rays, size, blocks, frame.scene,
                           frame.texels, geometry.nodes, geometry.triangles, geometry.instances,
                           geometry.grid, geometry.faces, geometry.vertices, paths_, hits_));
      }
      if (bounce == 0) {
        note_guides(kernels_.note_guides, context, launch, size, geometry, frame, hits_, events);
      }
      events.emplace_back(
          KernelStage::shading,
          opencl::launch(context, kernels_.scatter_at_hits, size, launch, bounce, frame.scene,
                         frame.sky_table, frame.sky_importance, frame.cloud_chart, frame.texels,
                         geometry.instances, geometry.grid, geometry.faces, geometry.vertices,
                         hits_, paths_));
      if (bounce > frame.bounces) break;
      for (std::uint32_t light = 0; light < kLightRays; ++light) {
        if (light == kRayToLamp && !frame.lamps) continue;
        events.emplace_back(KernelStage::shadow,
                            trace_lights(context, size, blocks, light, geometry, frame));
      }
    }
    events.emplace_back(KernelStage::shading, opencl::launch(context, kernels_.add_paths, size,
                                                             launch, paths_, frame.film.pixels));
    return events;
  }

 private:
  opencl::Event trace_lights(const opencl::Context& context, const opencl::LaunchSize& size,
                             std::uint32_t blocks, std::uint32_t light,
                             const DeviceGeometry& geometry, const FrameBuffers& frame) const {
    if (frame.see_through) {
      return opencl::launch(context, frame.see_through->trace_light_rays_on, size, blocks, light,
                            frame.scene, frame.texels, geometry.nodes, geometry.triangles,
                            geometry.instances, geometry.grid, geometry.faces, geometry.vertices,
                            paths_);
    }
    return opencl::launch(context, kernels_.trace_light_rays, size, blocks, light, geometry.nodes,
                          geometry.triangles, geometry.instances, geometry.grid, paths_);
  }

  PathKernels kernels_;
  HitBuffer hits_;
  PathBuffer paths_;
};

}  // namespace

std::unique_ptr<Integrator> make_integrator(PathKernels kernels) {
  return std::make_unique<PathIntegrator>(std::move(kernels));
}

}  // namespace aerostat::render

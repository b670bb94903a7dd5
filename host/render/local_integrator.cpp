#include "render/integrator.hpp"

namespace aerostat::render {
namespace {

/// Phong's local model: eye rays, shadow rays, rays towards the sky, and shading.
class LocalIntegrator final : public Integrator {
 public:
  explicit LocalIntegrator(LocalKernels kernels) : kernels_(std::move(kernels)) {}

  void reserve(const opencl::Context& context, const opencl::MemoryBudget& budget,
               std::uint64_t packets, int lanes) override {
    hits_ = {};
    visible_ = {};
    found_ = {};
    const std::size_t rays = packets * static_cast<std::size_t>(lanes);
    hits_ = {context, budget, rays, "the hits"};
    visible_ = {context, budget, rays, "the shadows"};
    found_ = {context, budget, rays, "what is around the hits"};
  }

  std::vector<StageEvent> launch(const opencl::Context& context, const AeroLaunch& launch,
                                 const opencl::LaunchSize& size, const DeviceGeometry& geometry,
                                 const FrameBuffers& frame) const override {
    std::vector<StageEvent> events;
    events.emplace_back(KernelStage::primary,
                        opencl::launch(context, kernels_.trace_camera_rays, size, launch,
                                       geometry.nodes, geometry.triangles, geometry.instances,
                                       geometry.grid, frame.film.pixels, hits_));
    if (frame.see_through) {
      events.emplace_back(
          KernelStage::primary,
          opencl::launch(context, frame.see_through->pass_eye_rays, size, launch, frame.scene,
                         frame.texels, geometry.nodes, geometry.triangles, geometry.instances,
                         geometry.grid, geometry.faces, geometry.vertices, hits_));
    }
    note_guides(kernels_.note_guides, context, launch, size, geometry, frame, hits_, events);
    events.emplace_back(KernelStage::shadow, trace_shadows(context, launch, size, geometry, frame));
    if (frame.mirrors) {
      events.emplace_back(
          KernelStage::shadow,
          opencl::launch(context, frame.mirrors->look_into_mirrors, size, launch, frame.scene,
                         frame.texels, geometry.nodes, geometry.triangles, geometry.instances,
                         geometry.grid, geometry.faces, geometry.vertices, frame.cloud_chart, hits_,
                         visible_));
    }
    if (frame.ambient_occlusion) {
      events.emplace_back(
          KernelStage::ambient,
          opencl::launch(context, kernels_.trace_ambient_rays, size, launch, frame.scene,
                         geometry.nodes, geometry.triangles, geometry.instances, geometry.grid,
                         geometry.faces, geometry.vertices, hits_, found_));
    }
    events.emplace_back(
        KernelStage::shading,
        opencl::launch(context, kernels_.shade_hits, size, launch, frame.scene, frame.sky_table,
                       frame.cloud_chart, frame.texels, geometry.instances, geometry.grid,
                       geometry.faces, geometry.vertices, hits_, visible_, found_,
                       frame.film.pixels));
    return events;
  }

 private:
  opencl::Event trace_shadows(const opencl::Context& context, const AeroLaunch& launch,
                              const opencl::LaunchSize& size, const DeviceGeometry& geometry,
                              const FrameBuffers& frame) const {
    if (frame.see_through) {
      return opencl::launch(context, frame.see_through->trace_shadow_rays_on, size, launch,
                            frame.scene, frame.texels, geometry.nodes, geometry.triangles,
                            geometry.instances, geometry.grid, geometry.faces, geometry.vertices,
                            hits_, visible_);
    }
    return opencl::launch(context, kernels_.trace_shadow_rays, size, launch, frame.scene,
                          geometry.nodes, geometry.triangles, geometry.instances, geometry.grid,
                          geometry.faces, geometry.vertices, hits_, visible_);
  }

  LocalKernels kernels_;
  HitBuffer hits_;
  VisibleBuffer visible_;
  FoundBuffer found_;
};

}  // namespace

std::unique_ptr<Integrator> make_integrator(LocalKernels kernels) {
  return std::make_unique<LocalIntegrator>(std::move(kernels));
}

}  // namespace aerostat::render

#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "camera.h"
#include "opencl/launch.hpp"
#include "render/buffers.hpp"
#include "render/geometry.hpp"
#include "render/kernel_stage.hpp"

namespace aerostat::render {

/// The kernels by which rays go on behind surfaces that they pass.
struct SeeThroughKernels {
  opencl::TypedKernel<AeroLaunch, SceneBuffer, TexelBuffer, NodeBuffer, TriangleBuffer,
                      InstanceBuffer, GridBuffer, FaceBuffer, VertexBuffer, HitBuffer>
      pass_eye_rays;
  opencl::TypedKernel<AeroLaunch, SceneBuffer, TexelBuffer, NodeBuffer, TriangleBuffer,
                      InstanceBuffer, GridBuffer, FaceBuffer, VertexBuffer, HitBuffer,
                      VisibleBuffer>
      trace_shadow_rays_on;
  opencl::TypedKernel<std::uint32_t, SceneBuffer, TexelBuffer, NodeBuffer, TriangleBuffer,
                      InstanceBuffer, GridBuffer, FaceBuffer, VertexBuffer, PathBuffer, HitBuffer>
      pass_path_rays;
  opencl::TypedKernel<std::uint32_t, std::uint32_t, SceneBuffer, TexelBuffer, NodeBuffer,
                      TriangleBuffer, InstanceBuffer, GridBuffer, FaceBuffer, VertexBuffer,
                      PathBuffer>
      trace_light_rays_on;
};

/// The kernel that finds what still water and models from files mirror.
struct MirrorKernels {
  opencl::TypedKernel<AeroLaunch, SceneBuffer, TexelBuffer, NodeBuffer, TriangleBuffer,
                      InstanceBuffer, GridBuffer, FaceBuffer, VertexBuffer, CloudChartBuffer,
                      HitBuffer, VisibleBuffer>
      look_into_mirrors;
};

/// What a device renders a frame from, and the film that it adds to.
struct FrameBuffers {
  SceneBuffer scene;
  SkyTableBuffer sky_table;
  SkyImportanceBuffer sky_importance;
  CloudChartBuffer cloud_chart;
  TexelBuffer texels;
  DeviceFilm film;
  /// Whether launches add to the guides of the film.
  bool guides = false;
  /// The numbers of the scene that decide which kernels run.
  bool ambient_occlusion = false;
  bool lamps = false;
  std::uint32_t bounces = 0;
  /// The kernels for surfaces that let rays pass, or null if the scene has none.
  std::shared_ptr<const SeeThroughKernels> see_through;
  /// The kernel for mirrors, or null if the scene has neither models from files nor still water.
  std::shared_ptr<const MirrorKernels> mirrors;
};

/// A command of a launch and the stage that it belongs to.
using StageEvent = std::pair<KernelStage, opencl::Event>;

/// A way of finding the light of a tile: kernels, and the buffers by which they hand packets to
/// each other.
class Integrator {
 public:
  Integrator() = default;
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  virtual ~Integrator() = default;

  /// Allocates the buffers for so many packets of `lanes` lanes. Throws Error{exhausted}.
  virtual void reserve(const opencl::Context& context, const opencl::MemoryBudget& budget,
                       std::uint64_t packets, int lanes) = 0;

  /// Enqueues the kernels that add the light of a tile to the film.
  virtual std::vector<StageEvent> launch(const opencl::Context& context, const AeroLaunch& launch,
                                         const opencl::LaunchSize& size,
                                         const DeviceGeometry& geometry,
                                         const FrameBuffers& frame) const = 0;
};

/// The kernel that adds to the guides of a film.
using NoteGuides =
    opencl::TypedKernel<AeroLaunch, SceneBuffer, TexelBuffer, InstanceBuffer, GridBuffer,
                        FaceBuffer, VertexBuffer, HitBuffer, FilmBuffer, GuideBuffer>;

/// Enqueues it for the hits of a tile's eye rays if the frame asks for guides.
void note_guides(const NoteGuides& kernel, const opencl::Context& context, const AeroLaunch& launch,
                 const opencl::LaunchSize& size, const DeviceGeometry& geometry,
                 const FrameBuffers& frame, const HitBuffer& hits, std::vector<StageEvent>& events);

/// The kernels of the local integrator.
struct LocalKernels {
  opencl::TypedKernel<AeroLaunch, NodeBuffer, TriangleBuffer, InstanceBuffer, GridBuffer,
                      FilmBuffer, HitBuffer>
      trace_camera_rays;
  opencl::TypedKernel<AeroLaunch, SceneBuffer, NodeBuffer, TriangleBuffer, InstanceBuffer,
                      GridBuffer, FaceBuffer, VertexBuffer, HitBuffer, VisibleBuffer>
      trace_shadow_rays;
  opencl::TypedKernel<AeroLaunch, SceneBuffer, NodeBuffer, TriangleBuffer, InstanceBuffer,
                      GridBuffer, FaceBuffer, VertexBuffer, HitBuffer, FoundBuffer>
      trace_ambient_rays;
  opencl::TypedKernel<AeroLaunch, SceneBuffer, SkyTableBuffer, CloudChartBuffer, TexelBuffer,
                      InstanceBuffer, GridBuffer, FaceBuffer, VertexBuffer, HitBuffer,
                      VisibleBuffer, FoundBuffer, FilmBuffer>
      shade_hits;
  NoteGuides note_guides;
};

/// The kernels of the path integrator.
struct PathKernels {
  opencl::TypedKernel<AeroLaunch, FilmBuffer, PathBuffer> start_paths;
  opencl::TypedKernel<std::uint32_t, NodeBuffer, TriangleBuffer, InstanceBuffer, GridBuffer,
                      PathBuffer, HitBuffer>
      extend_paths;
  opencl::TypedKernel<AeroLaunch, std::uint32_t, SceneBuffer, SkyTableBuffer, SkyImportanceBuffer,
                      CloudChartBuffer, TexelBuffer, InstanceBuffer, GridBuffer, FaceBuffer,
                      VertexBuffer, HitBuffer, PathBuffer>
      scatter_at_hits;
  opencl::TypedKernel<std::uint32_t, std::uint32_t, NodeBuffer, TriangleBuffer, InstanceBuffer,
                      GridBuffer, PathBuffer>
      trace_light_rays;
  opencl::TypedKernel<AeroLaunch, PathBuffer, FilmBuffer> add_paths;
  NoteGuides note_guides;
};

std::unique_ptr<Integrator> make_integrator(LocalKernels kernels);
std::unique_ptr<Integrator> make_integrator(PathKernels kernels);

}  // namespace aerostat::render

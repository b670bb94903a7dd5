#include "render/integrator.hpp"

namespace aerostat::render {

void note_guides(const NoteGuides& kernel, const opencl::Context& context, const AeroLaunch& launch,
                 const opencl::LaunchSize& size, const DeviceGeometry& geometry,
                 const FrameBuffers& frame, const HitBuffer& hits,
                 std::vector<StageEvent>& events) {
  if (!frame.guides) return;
  events.emplace_back(
      KernelStage::shading,
      opencl::launch(context, kernel, size, launch, frame.scene, frame.texels, geometry.instances,
                     geometry.grid, geometry.faces, geometry.vertices, hits, frame.film.pixels,
                     frame.film.guides));
}

}  // namespace aerostat::render

#pragma once

#include <cstddef>
#include <cstdint>

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfPixelType.h>

#include "image/film.hpp"

/// The layers of a film as channels of an OpenEXR file.
namespace aerostat::image {

/// Calls `use(name, type, first, stride)` for each channel of the layers that a film has: its
/// first value, and the bytes from one pixel to the next.
template <typename Use>
void each_channel(const Film& film, const Use& use) {
  const auto numbers = [&use](const char* name, Imf::PixelType type, const auto& values) {
    if (!values.empty()) use(name, type, static_cast<const void*>(values.data()), sizeof values[0]);
  };
  const auto vectors = [&use](const char* x, const char* y, const char* z,
                              const Array<vec3>& values) {
    if (values.empty()) return;
    use(x, Imf::FLOAT, static_cast<const void*>(&values[0].x), sizeof(vec3));
    use(y, Imf::FLOAT, static_cast<const void*>(&values[0].y), sizeof(vec3));
    use(z, Imf::FLOAT, static_cast<const void*>(&values[0].z), sizeof(vec3));
  };
  vectors("R", "G", "B", film.radiance);
  numbers("A", Imf::FLOAT, film.alpha);
  numbers("Z", Imf::FLOAT, film.distance_m);
  vectors("albedo.R", "albedo.G", "albedo.B", film.albedo);
  vectors("N.X", "N.Y", "N.Z", film.normal_ws);
  numbers("id", Imf::UINT, film.object_id);
  numbers("samples", Imf::UINT, film.samples);
}

/// Returns the place in memory of all channels of a film, for the pixels that it has.
inline Imf::FrameBuffer frame_of(const Film& film) {
  const Imath::Box2i window({film.first.x, film.first.y},
                            {film.first.x + film.width - 1, film.first.y + film.height - 1});
  Imf::FrameBuffer frame;
  each_channel(film,
               [&](const char* name, Imf::PixelType type, const void* first, std::size_t stride) {
                 frame.insert(name, Imf::Slice::Make(type, first, window, stride));
               });
  return frame;
}

}  // namespace aerostat::image

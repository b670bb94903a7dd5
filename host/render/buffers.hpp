#pragma once

#include <cstdint>

#include "bvh_node.h"
#include "film_pixel.h"
#include "instance.h"
#include "opencl/buffer.hpp"
#include "packet_words.h"
#include "scene_params.h"
#include "trace_triangle.h"

/// The buffers of a render on a device. Each has a type of its own, by which kernels tell them
/// apart.
namespace aerostat::render {

using SceneBuffer = opencl::Buffer<AeroScene>;
using SkyTableBuffer = opencl::Buffer<AeroSkyCell>;
using SkyImportanceBuffer = opencl::Buffer<AeroSkyImportance>;
using CloudChartBuffer = opencl::Buffer<AeroChartWord>;
/// The texels of the drape, the land cover and the textures of models (pack::Texels).
using TexelBuffer = opencl::Buffer<std::uint32_t>;
using NodeBuffer = opencl::Buffer<AeroBvhNode>;
using TriangleBuffer = opencl::Buffer<AeroTriangle>;
using FaceBuffer = opencl::Buffer<AeroFace>;
using VertexBuffer = opencl::Buffer<AeroVertex>;
using InstanceBuffer = opencl::Buffer<AeroInstance>;
/// The heights of the ground.
using GridBuffer = opencl::Buffer<float>;
using FilmBuffer = opencl::Buffer<AeroFilmPixel>;
using GuideBuffer = opencl::Buffer<AeroFilmGuide>;

/// The film of a device.
struct DeviceFilm {
  FilmBuffer pixels;
  /// The guides of a denoiser, or nothing if nobody asks for them.
  GuideBuffer guides;
};

/// An element for each lane of each packet of a tile.
using HitBuffer = opencl::Buffer<AeroHitWords>;
using VisibleBuffer = opencl::Buffer<AeroVisibleWords>;
using FoundBuffer = opencl::Buffer<AeroFoundWords>;
using PathBuffer = opencl::Buffer<AeroPathWords>;

}  // namespace aerostat::render

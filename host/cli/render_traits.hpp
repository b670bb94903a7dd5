#pragma once

#include "cli/options.hpp"
#include "render/checkpoint.hpp"
#include "render/session.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {

/// Returns all that the bits of a render depend on, in words: the program with its kernels, the
/// scene, the content of the files that it names, size, part, quality, seed, lanes and layers. Of
/// files above 2 MiB, the size and the first and last MiB count. Throws Error{io} if a file cannot
/// be read.
render::Traits traits_of(const scene::Scene& scene, const render::Crop& part, int lanes,
                         render::Contents contents, bool guides);

}  // namespace aerostat::cli

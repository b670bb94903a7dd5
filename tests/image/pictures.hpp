#pragma once

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "render/session.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "support/resolved.hpp"

/// Provides the seven scenes at a small size and sessions on the device that aerostat would choose,
/// for all tests of whole pictures.
namespace aerostat::test {

/// The names of the seven scenes. Neighbours share their terrain, so a session that renders them in
/// this order keeps it.
inline constexpr std::array<const char*, 7> kScenes = {
    "snow", "snow-basket", "tropical", "tropical-basket", "sand", "sand-basket", "sand-empty"};

struct Size {
  int width = 96;
  int height = 64;
  int spp = 4;
  /// The cells of the terrain on each side.
  int cells = 128;
};

/// Returns scenes/<name>.json at another size and without plants. All its heights count from the
/// sea, so that `resolved` makes it what world::resolve would make of the file.
scene::Scene small_scene(const std::string& name, const Size& size = {});

/// Returns scenes/<name>.json in the same way, but with plants near the camera.
scene::Scene planted_scene(const std::string& name, const Size& size = {});

/// Returns the devices of AEROSTAT_DEVICE, or the automatic one if it is not set. Throws if there
/// is no device, so the test fails.
const std::vector<opencl::Device>& devices();

/// Returns the options of an interactive session on `devices()`.
render::Options options(int lanes = 0);

/// The cache of all sessions that are made with `options`, so that few lands are carved.
const std::shared_ptr<render::SceneCache>& shared_cache();

/// Returns the session of all tests of this process that need no session of their own.
render::Session& shared_session();

/// Returns whether two films hold the same bits, and where they differ.
testing::AssertionResult same_bits(const image::Film& a, const image::Film& b);

/// Returns the part of a film inside `crop`.
image::Film cut(image::Film film, const render::Crop& crop);

}  // namespace aerostat::test

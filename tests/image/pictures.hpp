#pragma once

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "render/session.hpp"
#include "scene/io.hpp"

/// What the tests of whole pictures share: the seven scenes at a small size, and sessions on the
/// device that aerostat would choose.
namespace aerostat::test {

/// Neighbours share their terrain, so that a session that renders them in this order keeps it.
inline constexpr std::array<const char*, 7> kScenes = {
    "snow", "snow-basket", "tropical", "tropical-basket", "sand", "sand-basket", "sand-empty"};

struct Size {
  int width = 96;
  int height = 64;
  int spp = 4;
  int cells = 128;  // of the terrain, per side
};

/// scenes/<name>.json, resolved, at another size and without plants.
scene::Scene small_scene(const std::string& name, const Size& size = {});

/// The same with plants near the camera.
scene::Scene planted_scene(const std::string& name, const Size& size = {});

/// The devices of AEROSTAT_DEVICE, else the automatic one. No device is a failure: throws.
const std::vector<opencl::Device>& devices();

/// Options on `devices()`.
render::Options options(int lanes = 0);

/// The session of all tests of this process that need no session of their own.
render::Session& shared_session();

/// Whether two films hold the same bits, and where not.
testing::AssertionResult same_bits(const image::Film& a, const image::Film& b);

/// The part of a film inside `crop`.
image::Film cut(const image::Film& film, const render::Crop& crop);

}  // namespace aerostat::test

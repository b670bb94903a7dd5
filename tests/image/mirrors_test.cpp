// Tests what still water and models from files mirror.
#include <cmath>
#include <string>

#include "flat_land.hpp"
#include "support/drape_files.hpp"

namespace aerostat::test {
namespace {

/// A square of 8 m that stands upright and faces the south.
constexpr const char* kBoard =
    "mtllib board.mtl\nusemtl paint\n"
    "v -4 0 0\nv 4 0 0\nv 4 8 0\nv -4 8 0\nf 1 2 3 4\n";

class Mirrors : public testing::Test {
 protected:
  /// Returns flat land seen from 2 m above it, towards the north.
  static scene::Scene level_view() {
    scene::Scene scene = flat_land();
    scene.camera.position = {0.0, 2.0, 0.0};
    scene.camera.target = {0.0, 2.0, -10.0};
    scene.camera.up = {0.0, 1.0, 0.0};
    scene.camera.fov_y_deg = 60.0;
    scene.sun.irradiance = 3.0;
    scene.sun.direction = glm::normalize(dvec3(0.0, 1.0, 0.3));
    return scene;
  }

  scene::PlacedModel model(const std::string& name, const std::string& text,
                           const dvec3& position) const {
    scene::PlacedModel placed;
    placed.file = folder_.write(name, text).string();
    placed.position = position;
    return placed;
  }

  /// Returns the radiance at an angle below the horizon in the middle column.
  static vec3 below(const image::Film& film, double angle_deg) {
    const double half = 0.5 * film.height;
    const double share = std::tan(glm::radians(angle_deg)) / std::tan(glm::radians(30.0));
    const auto row = static_cast<std::size_t>(half + half * share);
    return film.radiance[row * static_cast<std::size_t>(film.width) +
                         static_cast<std::size_t>(film.width) / 2];
  }

  DrapeFolder folder_;
};

/// An eye 1 m above water sees the board, which is 10 m away, mirrored 8 degrees below the horizon.
TEST_F(Mirrors, WaterMirrorsModelsInTheirColour) {
  folder_.write("board.mtl", "newmtl paint\nKd 1 0 0\nPr 1\n");
  scene::Scene scene = level_view();
  scene.biome.water.enabled = true;
  scene.biome.water.level_m = 1.0;
  scene.biome.water.wave_slope = 0.0;
  const vec3 without = below(shared_session().render(resolved(scene)), 8.0);
  scene.objects.push_back(model("board.obj", kBoard, {0.0, 0.0, -10.0}));
  const vec3 with = below(shared_session().render(resolved(scene)), 8.0);
  EXPECT_GT(with.x / with.y, 2.0f * without.x / without.y);
  // Beside the board nothing has changed.
  EXPECT_GT(with.x, 0.02f);
}

/// Returns a balloon lit by its burners alone, 60 m away over still water at night. Its middle is
/// 18 degrees above the horizon.
scene::Scene night_over_water(scene::Scene scene) {
  scene.camera.fov_y_deg = 60.0;
  scene.sun.irradiance = 0.0;
  scene.biome.water.enabled = true;
  scene.biome.water.level_m = 1.0;
  scene.biome.water.wave_slope = 0.0;
  scene.balloon.enabled = true;
  scene.balloon.burner = 1.0;
  scene.balloon.position = {0.0, 12.0, -60.0};
  return scene;
}

// Water mirrors the share of light that Fresnel's equations say.
TEST_F(Mirrors, StillWaterMirrorsTheGlowOfABalloon) {
  const image::Film film = shared_session().render(resolved(night_over_water(level_view())));
  const double cosine = std::sin(glm::radians(18.0));
  const double share = 0.0204 + (1.0 - 0.0204) * std::pow(1.0 - cosine, 5.0);
  const vec3 direct = below(film, -18.0), mirrored = below(film, 18.0);
  ASSERT_GT(direct.x, 1e-4f);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mirrored[c] / direct[c], share, 0.35 * share) << "channel " << c;
  }
}

TEST_F(Mirrors, RoughWaterIsLeftToAGuess) {
  scene::Scene scene = night_over_water(level_view());
  scene.biome.water.wave_slope = 0.11;
  const image::Film film = shared_session().render(resolved(scene));
  EXPECT_LT(below(film, 18.0).x, 0.01f * below(film, -18.0).x);
}

/// A mirror that leans over shows the ground at its foot, on which the sun shines from the south.
/// A roof far above the eye shades that ground.
TEST_F(Mirrors, ModelsMirrorWhetherTheSunShines) {
  folder_.write("board.mtl", "newmtl paint\nKd 1 1 1\nPm 1\nPr 0.05\n");
  scene::Scene scene = level_view();
  scene.sun.direction = glm::normalize(dvec3(0.0, 0.64, 0.77));
  scene.objects.push_back(model("mirror.obj",
                                "mtllib board.mtl\nusemtl paint\n"
                                "v -4 0 0\nv 4 0 0\nv 4 4 3\nv -4 4 3\nf 1 2 3 4\n",
                                {0.0, 1.0, -10.0}));
  const image::Film lit = shared_session().render(resolved(scene));
  scene.sun.irradiance = 0.0;
  const image::Film dark = shared_session().render(resolved(scene));
  scene.sun.irradiance = 3.0;
  scene.objects.push_back(
      model("roof.obj", "v -9 0 -9\nv 9 0 -9\nv 9 0 9\nv -9 0 9\nf 4 3 2 1\n", {0.0, 20.0, 13.0}));
  const image::Film shaded = shared_session().render(resolved(scene));
  const float sunlit = below(lit, 1.0).x - below(dark, 1.0).x;
  EXPECT_GT(sunlit, 0.1f) << "the mirror shows sunlit ground";
  EXPECT_LT(below(shaded, 1.0).x - below(dark, 1.0).x, 0.3f * sunlit);
}

}  // namespace
}  // namespace aerostat::test

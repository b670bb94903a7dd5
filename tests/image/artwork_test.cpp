// Tests pictures on the envelope: where they lie, their colours and edges, and the light through
// them.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "artwork/unrolled.hpp"
#include "flat_land.hpp"
#include "model/envelope_shape.hpp"
#include "model/rigging.hpp"
#include "render/scene_cache.hpp"
#include "support/drape_files.hpp"
#include "support/error_of.hpp"

namespace aerostat::test {
namespace {

using scene::ArtworkWrap;

constexpr std::array kRed{255, 0, 0, 255}, kBlue{0, 0, 255, 255};
/// The width of a pixel in metres at the front of the envelope, 9.4 m before its axis.
constexpr double kEyeDistance = 60.0;
const double kPixel = 2.0 * (kEyeDistance - 9.4) * std::tan(glm::radians(10.0)) / 120.0;
const vec3 kCloth(0.2f, 0.5f, 0.3f);

/// Renders with the albedos of what each pixel sees.
image::Film seen(const scene::Scene& scene) {
  render::Options how = options();
  how.guides = true;
  static render::Session session(how);
  return session.render(resolved(scene));
}

class ArtworkTest : public testing::Test {
 protected:
  /// Returns a balloon of one colour, whose cloth only reflects, seen from 60 m before its widest
  /// place. Pixels are 15 cm wide there.
  static scene::Scene balloon_scene() {
    scene::Scene scene = flat_land();
    scene.balloon = scene::Balloon();
    scene.balloon.height_above = scene::HeightReference::sea;
    scene.balloon.position = {0.0, 30.0, 0.0};
    scene.balloon.burner = 0.0;
    scene.balloon.colors = {kCloth};
    look_from(scene, 0.0);
    scene.camera.up = {0.0, 1.0, 0.0};
    scene.camera.fov_y_deg = 20.0;
    scene.image.width = 160;
    scene.image.height = 120;
    scene.sky.radiance = vec3(1.0f);
    scene::Material& cloth = scene.material(scene::MaterialId::envelope);
    cloth = {};
    return scene;
  }

  /// Puts the camera at a direction around the balloon, level with its widest place.
  static void look_from(scene::Scene& scene, double around_deg) {
    const double angle = glm::radians(around_deg);
    const scene::Balloon& balloon = scene.balloon;
    const model::EnvelopeShape shape(balloon.diameter_m, balloon.gores);
    const double arc = shape.mouth_arc() + artwork::Unrolled(balloon).widest_height();
    const double middle = 30.0 + model::mouth_height(balloon.diameter_m) +
                          shape.fabric(0, 0.0, {arc, 0.0}).position.y;
    scene.camera.position =
        dvec3(kEyeDistance * std::sin(angle), middle, -kEyeDistance * std::cos(angle));
    scene.camera.target = {0.0, middle, 0.0};
  }

  scene::Artwork picture(const std::string& name, int width, int height,
                         const PixelAt& pixel_at) const {
    scene::Artwork artwork;
    artwork.file = folder_.write_png(name, width, height, pixel_at, 0.0, 0.0, 1.0).string();
    return artwork;
  }

  static vec3 albedo_at(const image::Film& film, int x, int y) {
    return film.albedo[static_cast<std::size_t>(y * film.width + x)];
  }

  /// Returns the mean albedo of a square of pixels, so that seams matter little.
  static vec3 mean_at(const image::Film& film, int x, int y) {
    vec3 sum(0.0f);
    for (int j = -4; j <= 4; ++j) {
      for (int i = -4; i <= 4; ++i) sum += albedo_at(film, x + i, y + j) / 81.0f;
    }
    return sum;
  }

  DrapeFolder folder_;
};

TEST_F(ArtworkTest, MotifsLieWhereTheyAreSaidToAndAreNotMirrored) {
  scene::Artwork motif =
      picture("flag.png", 64, 64, [](int column, int) { return column < 32 ? kRed : kBlue; });
  motif.wrap = ArtworkWrap::motif;
  motif.width_m = 4.0;
  for (const auto light : {scene::Integrator::local, scene::Integrator::path}) {
    for (const double around : {0.0, 90.0, 200.0}) {
      scene::Scene scene = balloon_scene();
      scene.light = light;
      scene.balloon.heading_deg = 40.0;
      motif.around_deg = around;
      scene.balloon.artwork = {motif};
      look_from(scene, around + 40.0);
      const image::Film film = seen(scene);
      const int x = film.width / 2, y = film.height / 2;
      const vec3 left = mean_at(film, x - 7, y), right = mean_at(film, x + 7, y);
      EXPECT_GT(left.x, 0.75f) << around;
      EXPECT_LT(left.z, 0.02f) << around;
      EXPECT_GT(right.z, 0.75f) << around;
      EXPECT_LT(right.x, 0.02f) << around;
      const vec3 beside = mean_at(film, x + 35, y);
      EXPECT_NEAR(beside.x / beside.y, kCloth.x / kCloth.y, 0.01f) << "the cloth goes on beside it";
    }
  }
}

/// A motif of 4 m is 4 m wide and as high as its proportions say, along the cloth.
TEST_F(ArtworkTest, MotifsHaveTheirSizeInMetres) {
  scene::Artwork motif = picture("red.png", 8, 4, [](int, int) { return kRed; });
  motif.wrap = ArtworkWrap::motif;
  motif.width_m = 4.0;
  scene::Scene scene = balloon_scene();
  scene.balloon.artwork = {motif};
  const image::Film film = seen(scene);
  double columns = 0.0, rows = 0.0;
  const auto is_red = [&](int x, int y) {
    return albedo_at(film, x, y).x > 0.2f && albedo_at(film, x, y).z < 0.12f;
  };
  for (int x = 0; x < film.width; ++x) columns += is_red(x, film.height / 2 + 4);
  for (int y = 0; y < film.height; ++y) rows += is_red(film.width / 2 + 4, y);
  // The chord of an arc of 4 m on a circle of 9.4 m is 3.97 m long, and lies 0.2 m behind its
  // middle.
  EXPECT_NEAR(columns * kPixel, 3.97, 0.25);
  EXPECT_NEAR(rows * kPixel, 2.0, 0.25);
}

/// Where a wrap ends, it begins again: a picture of two halves that is turned by half a turn, with
/// its halves exchanged, is the same.
TEST_F(ArtworkTest, WrapsCloseBehindTheBalloon) {
  scene::Artwork one = picture("one.png", 2, 1, [](int x, int) { return x == 0 ? kRed : kBlue; });
  scene::Artwork other =
      picture("other.png", 2, 1, [](int x, int) { return x == 0 ? kBlue : kRed; });
  other.around_deg = 180.0;
  scene::Scene scene = balloon_scene();
  scene.balloon.artwork = {one};
  const image::Film a = seen(scene);
  scene.balloon.artwork = {other};
  const image::Film b = seen(scene);
  float largest = 0.0f;
  for (std::size_t i = 0; i < a.albedo.size(); ++i) {
    largest = std::max(largest, glm::distance(a.albedo[i], b.albedo[i]));
  }
  EXPECT_LT(largest, 2e-3f);
  EXPECT_GT(albedo_at(a, 50, 60).x, albedo_at(a, 110, 60).x) << "there is something to see";
}

TEST_F(ArtworkTest, BandsKeepTheirHeightsAndProportions) {
  scene::Artwork band = picture("band.png", 8, 8, [](int x, int) { return x < 4 ? kRed : kBlue; });
  band.wrap = ArtworkWrap::band;
  scene::Scene scene = balloon_scene();
  const double middle = artwork::Unrolled(scene.balloon).widest_height();
  band.heights_m = dvec2(middle - 2.0, middle + 2.0);
  scene.balloon.artwork = {band};
  const image::Film film = seen(scene);
  const auto is_cloth = [](const vec3& color) {
    return std::abs(color.x / color.y - kCloth.x / kCloth.y) < 0.02f;
  };
  const int x = film.width / 2, y = film.height / 2;
  const int edge = static_cast<int>(std::lround(2.0 / kPixel));
  EXPECT_FALSE(is_cloth(mean_at(film, x + 4, y - edge + 6)));
  EXPECT_TRUE(is_cloth(mean_at(film, x + 4, y - edge - 6)));
  EXPECT_TRUE(is_cloth(mean_at(film, x + 4, y + edge + 6)));
  // 15 copies of 4 m fill 59 m, so that the middle of one lies before the eye, 2 m of blue to the
  // right of it and then red again.
  const int step = static_cast<int>(std::lround(1.0 / kPixel));
  EXPECT_GT(mean_at(film, x + step, y).z, 0.75f);
  EXPECT_GT(mean_at(film, x + 3 * step, y).x, 0.75f);
  EXPECT_GT(mean_at(film, x - step, y).x, 0.75f);
}

TEST_F(ArtworkTest, OpacityShowsTheCloth) {
  scene::Scene scene = balloon_scene();
  scene.sun.irradiance = 3.0;
  scene.material(scene::MaterialId::envelope).translucency = 0.3;
  const image::Film bare = seen(scene);
  scene.balloon.artwork = {picture("nothing.png", 4, 4, [](int, int) {
    return std::array{255, 255, 255, 0};
  })};
  const image::Film clear = seen(scene);
  for (std::size_t i = 0; i < bare.radiance.size(); ++i) {
    ASSERT_LT(glm::distance(bare.radiance[i], clear.radiance[i]), 1e-5f) << i;
  }
  scene.material(scene::MaterialId::envelope).translucency = 0.0;
  scene.balloon.artwork = {picture("half.png", 4, 4, [](int, int) {
    return std::array{255, 0, 0, 128};
  })};
  const image::Film half = seen(scene);
  const vec3 mixed = mean_at(half, half.width / 2 + 4, half.height / 2);
  const float share = 128.0f / 255.0f;
  const vec3 expected = glm::mix(kCloth, vec3(1.0f, 0.0f, 0.0f), share);
  // The dye of panels differs by up to a twentieth.
  EXPECT_NEAR(mixed.x / mixed.y, expected.x / expected.y, 0.05f * expected.x / expected.y);
  EXPECT_NEAR(mixed.z / mixed.y, expected.z / expected.y, 0.02f);
}

TEST_F(ArtworkTest, LaterPicturesLieOverFormerOnes) {
  scene::Scene scene = balloon_scene();
  scene::Artwork above = picture("blue.png", 2, 2, [](int, int) { return kBlue; });
  above.wrap = ArtworkWrap::motif;
  scene.balloon.artwork = {picture("red.png", 2, 2, [](int, int) { return kRed; }), above};
  const image::Film film = seen(scene);
  EXPECT_GT(mean_at(film, film.width / 2, film.height / 2).z, 0.75f);
  EXPECT_GT(mean_at(film, film.width / 2 + 50, film.height / 2).x, 0.75f);
}

/// The sun behind the envelope shines through it in the colour of the picture.
TEST_F(ArtworkTest, LightThatShinesThroughIsDyed) {
  for (const auto light : {scene::Integrator::local, scene::Integrator::path}) {
    scene::Scene scene = balloon_scene();
    scene.light = light;
    scene.image.spp = 16;
    scene.sky.radiance = vec3(0.01f);
    scene.sun.irradiance = 5.0;
    scene.sun.direction = glm::normalize(dvec3(0.0, 0.3, 1.0));
    scene.balloon.colors = {vec3(0.6f)};
    scene.material(scene::MaterialId::envelope).translucency = 0.4;
    const image::Film bare = seen(scene);
    scene.balloon.artwork = {picture("red.png", 2, 2, [](int, int) { return kRed; })};
    const image::Film red = seen(scene);
    const std::size_t at = static_cast<std::size_t>(60 * bare.width + 84);
    EXPECT_GT(bare.radiance[at].y, 0.02f);
    EXPECT_LT(red.radiance[at].y, 0.15f * red.radiance[at].x);
    EXPECT_GT(red.radiance[at].x, bare.radiance[at].x);
  }
}

/// Gore number 5 of the template is red in the upper half of the cloth, and lies there as a whole.
TEST_F(ArtworkTest, WhatIsDrawnOnTheTemplateLiesOnItsGore) {
  scene::Scene scene = balloon_scene();
  const artwork::Unrolled cloth(scene.balloon);
  const int gores = cloth.gores(), width = 40 * gores, height = 400;
  scene::Artwork drawn = picture("gores.png", width, height, [&](int x, int y) {
    const double up = (1.0 - (y + 0.5) / height) * cloth.height();
    const double from_middle = (x + 0.5) / 40.0 - 5.5;
    const double half = 0.5 * cloth.gore_width(up) / cloth.widest_gore();
    const bool inside = std::abs(from_middle) < half && up > cloth.widest_height();
    return inside ? kRed : std::array{0, 0, 0, 0};
  });
  drawn.wrap = ArtworkWrap::gores;
  scene.balloon.artwork = {drawn};
  // The middle of gore 5 lies 6 gores from the right-hand side, against the clock.
  look_from(scene, 90.0 - 360.0 * 6.0 / gores);
  const image::Film film = seen(scene);
  const auto is_red = [&](int x, int y) { return albedo_at(film, x, y).z < 0.1f * kCloth.z; };
  const int x = film.width / 2, y = film.height / 2;
  const int half = static_cast<int>(0.5 * cloth.widest_gore() / kPixel);
  for (const int row : {y - 50, y - 30, y - 10}) EXPECT_TRUE(is_red(x, row)) << row;
  EXPECT_FALSE(is_red(x, y + 12));
  EXPECT_TRUE(is_red(x - half + 2, y - 10));
  EXPECT_TRUE(is_red(x + half - 2, y - 10));
  EXPECT_FALSE(is_red(x - half - 3, y - 10));
  EXPECT_FALSE(is_red(x + half + 3, y - 10));
}

TEST_F(ArtworkTest, BalloonsHaveTheirOwn) {
  scene::Scene scene = balloon_scene();
  scene.balloons.push_back(scene.balloon);
  scene.balloon.position.x = -14.0;
  scene.balloons[0].position.x = 14.0;
  scene.balloon.artwork = {picture("red.png", 2, 2, [](int, int) { return kRed; })};
  scene.balloons[0].artwork = {picture("blue.png", 2, 2, [](int, int) { return kBlue; })};
  scene.camera.fov_y_deg = 40.0;
  const image::Film film = seen(scene);
  EXPECT_GT(mean_at(film, film.width / 2 + 45, film.height / 2).x, 0.7f) << "west is on the right";
  EXPECT_GT(mean_at(film, film.width / 2 - 45, film.height / 2).z, 0.7f);
}

TEST_F(ArtworkTest, FilesAreReadOnce) {
  render::Options how = options();
  how.cache = std::make_shared<render::SceneCache>();
  render::Session session(how);
  scene::Scene scene = balloon_scene();
  scene::Artwork motif = picture("red.png", 2, 2, [](int, int) { return kRed; });
  motif.wrap = ArtworkWrap::motif;
  scene.balloon.artwork = {motif, motif};
  session.render(resolved(scene));
  scene.balloon.artwork[1].around_deg = 30.0;
  session.render(resolved(scene));
  EXPECT_EQ(how.cache->packing.artwork.files_read(), 1);
}

TEST_F(ArtworkTest, FaultsNameThePicture) {
  scene::Scene scene = balloon_scene();
  scene.balloon.artwork.emplace_back().file = "no/such/logo.png";
  const Error missing = error_of([&] { shared_session().render(resolved(scene)); });
  EXPECT_EQ(missing.kind(), ErrorKind::io);
  EXPECT_NE(std::string(missing.what()).find("/balloon/artwork/0: no/such/logo.png"),
            std::string::npos)
      << missing.what();
  scene.balloon.artwork[0].file = folder_.write("logo.gif", "GIF89a").string();
  const Error foreign = error_of([&] { shared_session().render(resolved(scene)); });
  EXPECT_EQ(foreign.kind(), ErrorKind::bad_data);
  EXPECT_NE(std::string(foreign.what()).find("expected a PNG, JPEG or SVG"), std::string::npos);
  scene.balloon.artwork[0].file = folder_.write("logo.png", "\x89PNG\r\n\x1a\nand so on").string();
  EXPECT_EQ(error_of([&] { shared_session().render(resolved(scene)); }).kind(),
            ErrorKind::bad_data);
}

}  // namespace
}  // namespace aerostat::test

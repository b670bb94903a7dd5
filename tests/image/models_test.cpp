// Tests models from files in pictures: where they stand, what is read and built again, and the
// colours of their textures.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "flat_land.hpp"
#include "render/scene_cache.hpp"
#include "support/drape_files.hpp"
#include "support/error_of.hpp"

namespace aerostat::test {
namespace {

/// A square of 20 m that lies on the ground, with the left half of its texture to the west.
constexpr const char* kBoard =
    "mtllib board.mtl\n"
    "v -10 0 -10\nv 10 0 -10\nv 10 0 10\nv -10 0 10\n"
    "vt 0 1\nvt 1 1\nvt 1 0\nvt 0 0\n"
    "usemtl paint\nf 1/1 4/4 3/3\nf 1/1 3/3 2/2\n";

/// A box of 4 x 10 x 2 m, without materials.
constexpr const char* kBox =
    "v 0 0 0\nv 4 0 0\nv 4 0 2\nv 0 0 2\nv 0 10 0\nv 4 10 0\nv 4 10 2\nv 0 10 2\n"
    "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

/// Returns the linear value of one encoded in sRGB, above its linear toe.
double linear_of(double encoded) {
  return std::pow((encoded + 0.055) / 1.055, 2.4);
}

class PlacedModels : public testing::Test {
 protected:
  scene::PlacedModel model(const std::string& name, const std::string& text,
                           const dvec3& position = dvec3(0.0)) const {
    scene::PlacedModel placed;
    placed.file = folder_.write(name, text).string();
    placed.position = position;
    return placed;
  }

  static std::size_t at(const image::Film& film, int x, int y) {
    return static_cast<std::size_t>(y * film.width + x);
  }

  static std::size_t pixels_of_models(const image::Film& film) {
    return static_cast<std::size_t>(std::count(film.object_id.begin(), film.object_id.end(),
                                               static_cast<std::uint32_t>(scene::ObjectId::model)));
  }

  DrapeFolder folder_;
};

/// The west of the board is black, its middle grey and its east white. Black shows what the mirror
/// of the surface reflects, and what the others reflect beyond that is in proportion to the light
/// of their texels.
TEST_F(PlacedModels, HaveTheColoursOfTheirTextures) {
  folder_.write_png(
      "paint.png", 3, 1,
      [](int column, int) {
        const int grey = std::array{0, 128, 255}[static_cast<std::size_t>(column)];
        return std::array{grey, grey, grey, 255};
      },
      0.0, 0.0, 1.0);
  folder_.write("board.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd paint.png\n");
  for (const auto light : {scene::Integrator::local, scene::Integrator::path}) {
    scene::Scene scene = flat_land();
    scene.objects.push_back(model("board.obj", kBoard, {0.0, 0.01, 0.0}));
    scene.sun.irradiance = 3.0;
    scene.sun.direction = {0.0, 1.0, 0.0};
    scene.light = light;
    scene.bounces = 0;
    const image::Film film = shared_session().render(resolved(scene));
    const int y = film.height / 2, x = film.width / 2;
    const auto red = [&](int column) {
      return static_cast<double>(film.radiance[at(film, column, y)].x);
    };
    ASSERT_EQ(film.object_id[at(film, x, y)], static_cast<std::uint32_t>(scene::ObjectId::model));
    const double metres = point_under(scene, 1, 0).x - point_under(scene, 0, 0).x;
    const int third = static_cast<int>(std::lround(20.0 / 3.0 / metres));
    const double black = red(x - third), white = red(x + third);
    const double grey = 0.5 * (red(x - 1) + red(x));
    EXPECT_GT(white, 0.8 * 3.0 / std::numbers::pi);
    EXPECT_LT(black, 0.05);
    // A hundredth comes from the neighbours, which are mixed in within a pixel of the middle.
    EXPECT_NEAR((grey - black) / (white - black), linear_of(128.0 / 255.0), 0.015);
  }
}

/// A board 5 m above the ground whose west is cut out of its picture. The ground below it is seen
/// through the hole and is lit through it.
TEST_F(PlacedModels, LetRaysPassWhereTheirPictureIsTransparent) {
  folder_.write_png(
      "paint.png", 2, 1,
      [](int column, int) {
        return std::array{0, 200, 0, column == 0 ? 0 : 255};
      },
      0.0, 0.0, 1.0);
  folder_.write("board.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd paint.png\nmap_d paint.png\n");
  for (const auto light : {scene::Integrator::local, scene::Integrator::path}) {
    scene::Scene scene = flat_land();
    scene.sun.irradiance = 3.0;
    scene.sun.direction = glm::normalize(dvec3(0.02, 1.0, 0.0));
    scene.light = light;
    scene.bounces = 1;
    const image::Film bare = shared_session().render(resolved(scene));
    scene.objects.push_back(model("board.obj", kBoard, {0.0, 5.0, 0.0}));
    const image::Film film = shared_session().render(resolved(scene));
    const std::size_t west = at(film, film.width / 2 - 8, film.height / 2),
                      east = at(film, film.width / 2 + 8, film.height / 2);
    EXPECT_EQ(film.object_id[west], static_cast<std::uint32_t>(scene::ObjectId::terrain));
    EXPECT_NEAR(film.distance_m[west], bare.distance_m[west], 1e-3);
    expect_radiance(dvec3(bare.radiance[west]), dvec3(film.radiance[west]), 0.02);
    EXPECT_EQ(film.object_id[east], static_cast<std::uint32_t>(scene::ObjectId::model));
    EXPECT_GT(film.radiance[east].y, 10.0f * film.radiance[east].x);
  }
}

TEST_F(PlacedModels, StandOnTheGround) {
  scene::Scene scene = flat_land();
  scene.objects.push_back(model("box.obj", kBox));
  scene.objects.back().height_m = 5.0;
  image::Film film = shared_session().render(resolved(scene));
  const std::size_t middle = at(film, film.width / 2, film.height / 2);
  EXPECT_NEAR(film.distance_m[middle], kEyeHeight - 5.0, 5e-3);
  const std::size_t low = pixels_of_models(film);
  scene.objects.back().height_above = scene::HeightReference::sea;
  scene.objects.back().position.y = 7.0;
  film = shared_session().render(resolved(scene));
  EXPECT_NEAR(film.distance_m[middle], kEyeHeight - 12.0, 5e-3);
  EXPECT_GT(pixels_of_models(film), low);
}

TEST_F(PlacedModels, TurnClockwise) {
  scene::Scene scene = flat_land();
  // A wedge that is broad in the east and pointed in the west.
  scene.objects.push_back(
      model("wedge.obj", "v 0 0 0\nv 8 0 -0.5\nv 8 0 0.5\nv 0 0.1 0\nf 1 3 2\nf 4 2 3\n"));
  scene.objects.back().heading_deg = 90.0;
  const image::Film film = shared_session().render(resolved(scene));
  // Its broad end is in the south now.
  const double metres = point_under(scene, 1, 0).x - point_under(scene, 0, 0).x;
  const int end = static_cast<int>(std::lround(3.5 / metres));
  const auto is_model = [&](int x, int y) {
    return film.object_id[at(film, film.width / 2 + x, film.height / 2 + y)] ==
           static_cast<std::uint32_t>(scene::ObjectId::model);
  };
  EXPECT_TRUE(is_model(0, end - 1));
  EXPECT_FALSE(is_model(end - 1, 0));
  EXPECT_FALSE(is_model(1 - end, 0));
}

TEST_F(PlacedModels, AreReadAndBuiltOnlyWhenTheyChange) {
  scene::Scene scene = flat_land();
  scene.objects.push_back(model("box.obj", kBox));
  scene.objects.push_back(model("box.obj", kBox, {6.0, 0.0, 0.0}));
  render::Options how = options();
  how.cache = std::make_shared<render::SceneCache>();
  render::Session session(how);
  session.render(resolved(scene));
  EXPECT_EQ(how.cache->models.files_read(), 1);
  scene.camera.target->x += 1.0;
  session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 0);
  scene.objects[1].position.z += 2.0;
  const image::Film moved = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 1) << "the models";
  EXPECT_EQ(how.cache->models.files_read(), 1);
  scene.objects.push_back(model("board.obj", kBoard, {0.0, 0.0, 12.0}));
  session.render(resolved(scene));
  EXPECT_EQ(how.cache->models.files_read(), 2) << "the box is not read again";
  scene.objects.pop_back();
  EXPECT_TRUE(same_bits(session.render(resolved(scene)), moved));
}

TEST_F(PlacedModels, ThatAreMissingAreAnErrorWithTheirPath) {
  scene::Scene scene = flat_land();
  scene.objects.emplace_back().file = "no/such/church.glb";
  const Error error = error_of([&] { shared_session().render(resolved(scene)); });
  EXPECT_EQ(error.kind(), ErrorKind::io);
  EXPECT_NE(std::string(error.what()).find("no/such/church.glb"), std::string::npos)
      << error.what();
}

TEST_F(PlacedModels, PlainOnesHaveTheirBaseColour) {
  folder_.write("board.mtl", "newmtl paint\nKd 0.5 0.25 0.125\n");
  scene::Scene scene = flat_land();
  scene.surfaces = scene::Surfaces::plain;
  scene.material(scene::MaterialId::terrain).albedo = vec3(kAlbedo);
  scene.sun.irradiance = 3.0;
  scene.sun.direction = {0.0, 1.0, 0.0};
  const image::Film bare = shared_session().render(resolved(scene));
  scene.objects.push_back(model("board.obj", kBoard, {0.0, 0.01, 0.0}));
  const image::Film film = shared_session().render(resolved(scene));
  const std::size_t middle = at(film, film.width / 2, film.height / 2);
  ASSERT_EQ(film.object_id[middle], static_cast<std::uint32_t>(scene::ObjectId::model));
  const dvec3 white = dvec3(bare.radiance[middle]) / kAlbedo;
  const dvec3 color(linear_of(0.5), linear_of(0.25), linear_of(0.125));
  expect_radiance(white * color, dvec3(film.radiance[middle]), 1e-3);
}

}  // namespace
}  // namespace aerostat::test

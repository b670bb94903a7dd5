#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "scene/palettes.hpp"

namespace aerostat::scene {
namespace {

Scene read(const std::string& body, const std::vector<Override>& overrides = {}) {
  return read_text(R"({"version": 1)" + (body.empty() ? "" : ", " + body) + "}", "test.json",
                   overrides);
}

class SceneFile : public testing::TestWithParam<const char*> {
 protected:
  static std::filesystem::path path() {
    return std::filesystem::path(AEROSTAT_SOURCE_DIR) / "scenes" /
           (std::string(GetParam()) + ".json");
  }
};

TEST_P(SceneFile, DumpOfDumpIsTheSameText) {
  const std::string dump = write_text(read_file(path()));
  EXPECT_EQ(write_text(read_text(dump, "dump")), dump);
  EXPECT_EQ(dump.back(), '\n');
}

TEST_P(SceneFile, IsWhatItsNameSays) {
  const Scene scene = read_file(path());
  const std::string name = GetParam();
  const BiomeKind kind = name.starts_with("snow")       ? BiomeKind::snow
                         : name.starts_with("tropical") ? BiomeKind::tropical
                                                        : BiomeKind::sand;
  EXPECT_EQ(scene.biome.kind, kind);
  EXPECT_EQ(scene.camera.view, name.ends_with("-basket") ? View::basket : View::outside);
  EXPECT_EQ(scene.balloon.enabled, !name.ends_with("-empty"));
  EXPECT_EQ(scene.camera.position.has_value(), scene.camera.view == View::outside);
}

INSTANTIATE_TEST_SUITE_P(All, SceneFile,
                         testing::Values("snow", "snow-basket", "tropical", "tropical-basket",
                                         "sand", "sand-basket", "sand-empty"),
                         [](const auto& file) {
                           std::string name = file.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(SceneQuality, SetsSamplesSoftShadowsAndOcclusion) {
  for (const auto& [name, spp, soft] :
       {std::tuple("draft", 1, false), std::tuple("standard", 4, true),
        std::tuple("final", 256, true)}) {
    const Scene scene = read(R"("biome": "snow")", {{"/quality", name}});
    EXPECT_EQ(scene.image.spp, spp) << name;
    EXPECT_EQ(scene.sun.soft_shadows, soft) << name;
    EXPECT_EQ(scene.sky.ambient_occlusion, soft) << name;
  }
  EXPECT_EQ(read("").quality, Quality::standard);
  EXPECT_EQ(read("").image.spp, 4);
}

TEST(Haze, IsMadeOfEverLargerDropletsAsItThickens) {
  const Haze usual = read(R"("biome": "snow")").haze;
  const auto haze = [](const std::string& fields) {
    return read(R"("biome": "snow", "haze": {)" + fields + "}").haze;
  };
  EXPECT_EQ(haze(R"("visibility_m": 6000)").angstrom, usual.angstrom);
  EXPECT_EQ(haze(R"("visibility_m": 6000)").albedo, usual.albedo);
  // The expected values are Kim's exponents.
  EXPECT_NEAR(haze(R"("visibility_m": 2000)").angstrom, 0.66, 1e-12);
  EXPECT_NEAR(haze(R"("visibility_m": 800)").angstrom, 0.3, 1e-12);
  EXPECT_EQ(haze(R"("visibility_m": 500)").angstrom, 0.0);
  EXPECT_NEAR(haze(R"("visibility_m": 600)").albedo.y, 1.0 - 0.1 * (1.0 - usual.albedo.y), 1e-6);
  // Values that the scene gives are not replaced.
  const Haze smoke = haze(R"("visibility_m": 500, "angstrom": 2, "albedo": [0.3, 0.3, 0.3])");
  EXPECT_EQ(smoke.angstrom, 2.0);
  EXPECT_EQ(smoke.albedo, vec3(0.3f));
}

TEST(SceneQuality, LeavesWhatTheSceneSays) {
  const Scene draft =
      read(R"("quality": "draft", "image": {"spp": 7}, "sun": {"soft_shadows": true},
                              "sky": {"ambient_occlusion": true})");
  EXPECT_EQ(draft.image.spp, 7);
  EXPECT_TRUE(draft.sun.soft_shadows);
  EXPECT_TRUE(draft.sky.ambient_occlusion);
  const Scene best = read(R"("quality": "final", "sky": {"ambient_occlusion": false})");
  EXPECT_EQ(best.image.spp, 256);
  EXPECT_GT(best.image.adaptive_threshold, 0.0);
  EXPECT_EQ(draft.image.adaptive_threshold, 0.0);
  EXPECT_FALSE(best.sky.ambient_occlusion);
  EXPECT_EQ(write_text(read_text(write_text(draft), "dump")), write_text(draft));
}

TEST(SceneDefaults, EveryBiomeBringsItsOwn) {
  const Scene snow = read(R"("biome": "snow")");
  const Scene tropical = read(R"("biome": {"kind": "tropical"})");
  const Scene sand = read(R"("biome": "sand")");
  EXPECT_EQ(snow.terrain.kind, TerrainKind::mountains);
  EXPECT_EQ(tropical.terrain.kind, TerrainKind::island);
  EXPECT_EQ(sand.terrain.kind, TerrainKind::dunes);
  EXPECT_FALSE(snow.biome.water.enabled);
  EXPECT_TRUE(tropical.biome.water.enabled);
  EXPECT_NE(snow.balloon.colors, tropical.balloon.colors);
  EXPECT_NE(tropical.balloon.colors, sand.balloon.colors);
  EXPECT_NE(snow.sun.direction, sand.sun.direction);
  EXPECT_NE(snow.air.ground_albedo, sand.air.ground_albedo);
  EXPECT_NE(snow.haze.visibility_m, tropical.haze.visibility_m);
  EXPECT_EQ(write_text(read("")), write_text(snow));
}

TEST(ScenePalettes, GiveTheColorsUnlessColorsAreGiven) {
  EXPECT_EQ(read(R"("balloon": {"palette": "plum"})").balloon.colors,
            palette_colors(Palette::plum));
  const Scene both = read(R"("balloon": {"palette": "plum", "colors": [[0.1, 0.2, 0.3]]})");
  ASSERT_EQ(both.balloon.colors.size(), 1u);
  EXPECT_FLOAT_EQ(both.balloon.colors[0].y, 0.2f);
  // A scene that was written out has both the palette and its colours. Another palette replaces
  // both.
  const std::string dumped = write_text(both);
  EXPECT_EQ(read_text(dumped, "x.json").balloon.colors, both.balloon.colors);
  EXPECT_EQ(read_text(dumped, "x.json", {{"/balloon/palette", "glacier"}}).balloon.colors,
            palette_colors(Palette::glacier));
  const Scene further = read(R"("balloons": [{}, {}, {"palette": "ember"}])");
  EXPECT_NE(further.balloons[0].colors, further.balloons[1].colors);
  EXPECT_EQ(further.balloons[2].colors, palette_colors(Palette::ember));
  EXPECT_EQ(write_text(read_text(write_text(further), "x.json")), write_text(further));
}

TEST(SceneDefaults, ArePlausible) {
  for (const BiomeKind kind :
       {BiomeKind::snow, BiomeKind::tropical, BiomeKind::sand, BiomeKind::meadow}) {
    const Scene scene = defaults(kind, View::outside);
    EXPECT_NEAR(glm::length(scene.sun.direction), 1.0, 1e-12);
    const double elevation = std::asin(scene.sun.direction.y) * 180.0 / kPi;
    EXPECT_GE(elevation, 8.0);
    EXPECT_LE(elevation, 25.0);
    EXPECT_FALSE(scene.balloon.colors.empty());
    EXPECT_EQ(scene.balloon.height_above, HeightReference::ground);
    EXPECT_GT(scene.material(MaterialId::flame).emission.x, 1.0f);
    EXPECT_DOUBLE_EQ(scene.material(MaterialId::envelope).translucency, 0.3);
  }
}

TEST(SceneDefaults, BasketViewLeavesTheCameraToTheWorld) {
  const Scene scene = read(R"("camera": {"view": "basket"})");
  EXPECT_FALSE(scene.camera.position);
  EXPECT_FALSE(scene.camera.target);
  EXPECT_EQ(write_text(scene).find("\"target\""), std::string::npos);

  const Scene placed = read(R"("camera": {"view": "basket", "position": [1, 2, 3]})");
  EXPECT_TRUE(placed.camera.position);
  EXPECT_FALSE(placed.camera.target);
  EXPECT_EQ(*placed.camera.position, dvec3(1, 2, 3));
}

TEST(SceneText, FileOverridesDefaults) {
  const Scene scene = read(R"(
    // comments of both kinds
    "image": {"width": 320, "height": 200 /* small */},
    "terrain": {"kind": "dunes", "seed": 4294967295, "fractal": {"octaves": 5}},
    "lights": [{"position": [1, 2, 3]}, {"position": [4, 5, 6], "shadows": false}],
    "materials": {"basket": {"specular": 0.5}},
    "shading": "gouraud")");
  EXPECT_EQ(scene.image.width, 320);
  EXPECT_EQ(scene.terrain.kind, TerrainKind::dunes);
  EXPECT_EQ(scene.terrain.seed, 4294967295u);
  EXPECT_EQ(scene.terrain.fractal.octaves, 5);
  EXPECT_EQ(scene.terrain.fractal.kind, FractalKind::ridged);
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[1].position, dvec3(4, 5, 6));
  EXPECT_FALSE(scene.lights[1].shadows);
  EXPECT_DOUBLE_EQ(scene.material(MaterialId::basket).specular, 0.5);
  EXPECT_EQ(scene.shading, Shading::gouraud);
}

TEST(SceneText, NumbersKeepTheirShortText) {
  const std::string dump = write_text(read(R"("air": {"ground_albedo": [0.35, 0.1, 1e-7]},
      "haze": {"visibility_m": 12345.678}, "balloon": {"position": [0.1, -0.0, 1e5]})"));
  EXPECT_NE(dump.find("\"ground_albedo\": [0.35, 0.1, 1e-07]"), std::string::npos) << dump;
  EXPECT_NE(dump.find("\"visibility_m\": 12345.678"), std::string::npos);
  EXPECT_NE(dump.find("\"position\": [0.1, 0, 100000]"), std::string::npos);
}

TEST(SceneText, EveryFieldSurvivesTheRoundTrip) {
  Scene scene = defaults(BiomeKind::sand, View::basket);
  scene.camera = {View::basket,
                  dvec3(1.5, 2, 3),
                  dvec3(4, 5, 6),
                  {},
                  {},
                  HeightReference::sea,
                  {0, 1, 0.25},
                  Lens::thin_lens,
                  33,
                  4.5,
                  0.125,
                  77,
                  88};
  scene.terrain.center = {12.5, -7};
  scene.terrain.fractal = {FractalKind::fbm, 3, 1.7, 0.7, 0.9};
  scene.biome.ground.snow_slope_deg[1] = 61;
  scene.biome.water.absorption_per_m = {0.31f, 0.07f, 0.0123456789f};
  scene.lights = {{{1, 2, 3}, {0.5f, 1, 1}, 7, false}};
  scene.fog = {true, 123.0, 45.0, 6.0, 7.0, 89.0};
  scene.haze = {12345.0, 678.0, 0.5, 0.6, {0.7f, 0.8f, 0.9f}};
  scene.shading = Shading::flat;
  scene.image = {33, 44, 5, 6, 0.0625, Filter::tent, -1.5, 4500, 0.25};
  const std::string dump = write_text(scene);
  const Scene back = read_text(dump, "dump");
  EXPECT_EQ(write_text(back), dump);
  EXPECT_EQ(*back.camera.target, *scene.camera.target);
  EXPECT_EQ(back.camera.height_above, HeightReference::sea);
  EXPECT_EQ(back.biome.water.absorption_per_m, scene.biome.water.absorption_per_m);
  EXPECT_EQ(back.lights[0].color, scene.lights[0].color);
  EXPECT_EQ(back.image.filter, Filter::tent);
  EXPECT_EQ(back.image.exposure_ev, -1.5);
  EXPECT_EQ(back.image.adaptive_threshold, 0.0625);
  EXPECT_EQ(back.image.white_balance_k, 4500);
  EXPECT_EQ(back.image.vignette, 0.25);
  EXPECT_EQ(back.camera.lens, Lens::thin_lens);
  EXPECT_EQ(back.camera.focus_m, 77);
  EXPECT_EQ(back.camera.aperture_m, scene.camera.aperture_m);
  EXPECT_EQ(back.camera.view_height_m, 88);
  EXPECT_EQ(back.fog, scene.fog);
  EXPECT_EQ(back.haze.albedo, scene.haze.albedo);
  EXPECT_EQ(back.terrain, scene.terrain);
}

TEST(SceneText, RealLandSurvivesTheRoundTrip) {
  Scene scene = defaults(BiomeKind::meadow, View::outside);
  set_elevation(scene);
  scene.terrain.source = {"a.tif", "b/"};
  scene.terrain.crs = "EPSG:2056";
  scene.terrain.place.easting = 2600000;
  scene.terrain.place.northing = 1200000;
  scene.terrain.raw = {640, 480, SampleType::uint16, true, 12};
  scene.balloon.track = FlightTrack{"flight.igc", "", 0.25, 2, "", 3.0, TrackLine{5.0}};
  scene.camera.at = GeoPoint{46.8, 9.8, 12.5};
  scene.camera.look_at = GeoPoint{46.9, 9.9, 3000};
  const std::string dump = write_text(scene);
  const Scene back = read_text(dump, "dump");
  EXPECT_EQ(write_text(back), dump);
  EXPECT_EQ(back.terrain, scene.terrain);
  EXPECT_EQ(back.balloon.track, scene.balloon.track);
  EXPECT_EQ(back.camera.at, scene.camera.at);
  EXPECT_EQ(back.camera.look_at, scene.camera.look_at);
}

TEST(SceneText, WholeNumbersMayHaveAPoint) {
  EXPECT_EQ(read(R"("image": {"width": 640.0})").image.width, 640);
}

TEST(SceneSun, AnglesAndDirectionAgree) {
  const Scene east = read(R"("sun": {"azimuth_deg": 90, "elevation_deg": 0})");
  EXPECT_NEAR(east.sun.direction.x, 1.0, 1e-12);
  const Scene north = read(R"("sun": {"azimuth_deg": 0, "elevation_deg": 30})");
  EXPECT_NEAR(north.sun.direction.y, 0.5, 1e-12);
  EXPECT_LT(north.sun.direction.z, 0.0);
  const Scene scaled = read(R"("sun": {"direction": [0, 3, 4]})");
  EXPECT_NEAR(scaled.sun.direction.y, 0.6, 1e-12);
  EXPECT_NEAR(scaled.sun.direction.z, 0.8, 1e-12);
}

TEST(SceneSun, OneAngleKeepsTheOtherOfTheBiome) {
  const Scene usual = defaults(BiomeKind::snow, View::outside);
  const Scene turned = read(R"("sun": {"azimuth_deg": 10})");
  EXPECT_NEAR(turned.sun.direction.y, usual.sun.direction.y, 1e-12);
  EXPECT_NEAR(std::atan2(turned.sun.direction.x, -turned.sun.direction.z) * 180.0 / kPi, 10.0,
              1e-6);
}

TEST(SceneOverride, IsSplitAtTheFirstEqualsSign) {
  const Override change = parse_override("/a/b=c=d");
  EXPECT_EQ(change.pointer, "/a/b");
  EXPECT_EQ(change.value, "c=d");
  EXPECT_EQ(parse_override("/a=").value, "");
}

TEST(SceneOverride, SetsValuesOfEveryKind) {
  const Scene scene = read(R"("biome": "sand", "image": {"width": 10})",
                           {{"/image/width", "64"},
                            {"/biome/water/enabled", "true"},
                            {"/camera/view", "basket"},
                            {"/camera/up", "[0, 1, 1]"},
                            {"/lights", R"([{"position": [0, 0, 0]}])"},
                            {"/lights/0/position/1", "12"},
                            {"/lights/-", R"({"position": [9, 9, 9]})"}});
  EXPECT_EQ(scene.image.width, 64);
  EXPECT_EQ(scene.biome.kind, BiomeKind::sand);
  EXPECT_TRUE(scene.biome.water.enabled);
  EXPECT_EQ(scene.camera.view, View::basket);
  EXPECT_FALSE(scene.camera.position);
  EXPECT_EQ(scene.camera.up, dvec3(0, 1, 1));
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].position, dvec3(0, 12, 0));
}

TEST(SceneOverride, ReachesIntoDefaultArrays) {
  const Scene usual = defaults(BiomeKind::tropical, View::outside);
  const Scene scene = read(
      "", {{"/biome", "tropical"}, {"/balloon/colors/1/0", "0.5"}, {"/camera/position/1", "44"}});
  EXPECT_EQ(scene.balloon.colors.size(), usual.balloon.colors.size());
  EXPECT_FLOAT_EQ(scene.balloon.colors[1].x, 0.5f);
  EXPECT_EQ(scene.balloon.colors[1].y, usual.balloon.colors[1].y);
  EXPECT_EQ(*scene.camera.position, dvec3(usual.camera.position->x, 44, usual.camera.position->z));
}

TEST(SceneOverride, TakesTheArraysOfEachBiomeThatIsReadInTurn) {
  for (const auto& [name, biome] :
       {std::pair("tropical", BiomeKind::tropical), std::pair("snow", BiomeKind::snow),
        std::pair("sand", BiomeKind::sand)}) {
    const auto usual = defaults(biome, View::outside).air.ground_albedo;
    const Scene scene = read("", {{"/biome", name}, {"/air/ground_albedo/0", "0.25"}});
    EXPECT_FLOAT_EQ(scene.air.ground_albedo.x, 0.25f);
    EXPECT_EQ(scene.air.ground_albedo.y, usual.y) << name;
    EXPECT_EQ(scene.air.ground_albedo.z, usual.z) << name;
  }
}

TEST(SceneOverride, OfTheSunReplacesTheOtherForm) {
  const std::string dump = write_text(defaults(BiomeKind::snow, View::outside));
  const Scene raised = read_text(dump, "dump", {{"/sun/elevation_deg", "60"}});
  EXPECT_NEAR(raised.sun.direction.y, std::sin(60.0 * kPi / 180.0), 1e-6);
  const Scene usual = read_text(dump, "dump");
  EXPECT_NEAR(raised.sun.direction.x / raised.sun.direction.z,
              usual.sun.direction.x / usual.sun.direction.z, 1e-9);
  const Scene pointed =
      read(R"("sun": {"azimuth_deg": 5, "elevation_deg": 6})", {{"/sun/direction", "[0, 2, 0]"}});
  EXPECT_EQ(pointed.sun.direction, dvec3(0, 1, 0));
}

TEST(SceneOverride, OfTheSunGoesOnFromTheDirectionOfTheFile) {
  const std::string slanted = R"("sun": {"direction": [1, 1, 0]})";
  const Scene raised = read(slanted, {{"/sun/elevation_deg", "60"}});
  EXPECT_NEAR(raised.sun.direction.x, 0.5, 1e-9) << "in the azimuth of the file";
  EXPECT_NEAR(raised.sun.direction.z, 0.0, 1e-9);
  const std::vector<Override> noon{{"/sun/date", "2024-03-20"},
                                   {"/sun/time", "12:00"},
                                   {"/sun/latitude_deg", "0"},
                                   {"/sun/longitude_deg", "0"}};
  EXPECT_EQ(read(slanted, noon).sun.direction, read("", noon).sun.direction);
  EXPECT_GT(read(slanted, noon).sun.direction.y, 0.99);
}

}  // namespace
}  // namespace aerostat::scene

#include "core/error.hpp"

#include <filesystem>
#include <utility>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {
namespace {

/// Returns the error of `action`, or an empty message if it succeeds.
template <class Action>
std::pair<ErrorKind, std::string> error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return {error.kind(), error.what()};
  }
  return {ErrorKind::internal, ""};
}

std::string complaint(const std::string& text, const std::vector<Override>& overrides = {}) {
  const auto [kind, message] = error_of([&] { read_text(text, "x.json", overrides); });
  EXPECT_EQ(kind, ErrorKind::bad_data) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

std::string with(const std::string& body) {
  return R"({"version": 1, )" + body + "}";
}

struct Case {
  const char* body;
  const char* message;
};

class SceneComplaint : public testing::TestWithParam<Case> {};

TEST_P(SceneComplaint, NamesPlaceFoundAndExpected) {
  EXPECT_EQ(complaint(with(GetParam().body)), std::string("x.json: ") + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneComplaint,
    testing::Values(
        Case{R"("image": {"width": -5})",
             "/image/width: found -5, expected an integer from 1 to 32768"},
        Case{R"("image": {"width": 3.5})",
             "/image/width: found 3.5, expected an integer from 1 to 32768"},
        Case{R"("image": {"width": 123456789012345678901234567890})",
             "/image/width: found 1.2345678901234568e+29, expected an integer from 1 to 32768"},
        Case{R"("image": {"seed": 4294967296})",
             "/image/seed: found 4294967296, expected an integer from 0 to 4294967295"},
        Case{R"("image": 7)", "/image: found 7, expected an object"},
        Case{R"("image": null)", "/image: found null, expected an object"},
        Case{R"("balloon": {"enabled": "yes"})",
             "/balloon/enabled: found \"yes\", expected true or false"},
        Case{R"("camera": {"fov_y_deg": 0})",
             "/camera/fov_y_deg: found 0, expected a number from 1 to 170"},
        Case{R"("camera": {"up": [0, 1]})",
             "/camera/up: found [0,1], expected an array of 3 numbers from -1000 to 1000"},
        Case{R"("camera": {"target": [0, "a", 1]})",
             "/camera/target/1: found \"a\", expected a number from -1100000 to 1100000"},
        Case{R"("biome": "snwo")",
             "/biome/kind: found \"snwo\", expected one of \"snow\", \"tropical\", \"sand\", "
             "\"meadow\", \"auto\"; did you mean \"snow\"?"},
        Case{R"("biome": 3)",
             "/biome: found 3, expected one of \"snow\", \"tropical\", \"sand\", \"meadow\", "
             "\"auto\", or an "
             "object"},
        Case{R"("biome": {"kind": "sand", "ground": {"snow": [2, 0, 0]}})",
             "/biome/ground/snow/0: found 2, expected a number from 0 to 1"},
        Case{R"("biome": {"water": {"wave_m": 0}})",
             "/biome/water/wave_m: found 0, expected a number above 0 to 10000"},
        Case{R"("balloon": {"height_above": "balloon"})",
             "/balloon/height_above: found \"balloon\", expected one of \"sea\", \"ground\""},
        Case{R"("balloon": {"colors": []})",
             "/balloon/colors: found [], expected an array of 1 to 64 colours [red, green, blue]"},
        Case{R"("lights": {})", "/lights: found an object, expected an array of 0 to 16 objects"},
        Case{R"("balloons": {})",
             "/balloons: found an object, expected an array of 0 to 32 objects"},
        Case{R"("lights": [{"color": [1, 1, 1]}])",
             "/lights/0/position: found nothing, expected a position in metres, or a place on the "
             "Earth in at"},
        Case{R"("image": {"widht": 5})",
             "/image/widht: found an unknown key, expected one of adaptive_threshold, "
             "exposure_ev, filter, glare, height, seed, spp, vignette, white_balance_k, width; did "
             "you "
             "mean \"width\"?"},
        Case{R"("haze": {"qqqqqq": 5})",
             "/haze/qqqqqq: found an unknown key, expected one of albedo, angstrom, asymmetry, "
             "scale_height_m, visibility_m"},
        Case{R"("materials": {"rim": {"specular": -1}})",
             "/materials/rim/specular: found -1, expected a number from 0 to 10"},
        Case{R"("materials": {"sky": {}})",
             "/materials/sky: found an unknown key, expected one of basket, cables, envelope, "
             "flame, floor, frame, passenger, plant, rim, skirt, stone, terrain, track, water"},
        Case{R"("a/b~c\u001b": 5)",
             "/a~1b~0c\\u001b: found an unknown key, expected one of $schema, air, balloon, "
             "balloons, biome, bounces, camera, festival, film, fog, haze, image, light, lights, "
             "materials, mood, moon, objects, quality, shading, sky, stars, "
             "sun, surfaces, "
             "terrain, "
             "vegetation, "
             "version"},
        Case{R"("balloons": [{}, {}], "festival": {"count": 31})",
             "/festival/count: found 31, expected at most 30 beside the 2 of /balloons, 32 "
             "together"},
        Case{R"("image": {"exposure_ev": 1e999})",
             "/image/exposure_ev: found a number that is too large, expected a finite number"},
        Case{R"("image": {"spp": 1, "spp": 2})",
             "/image/spp: found this key twice, expected this key once"},
        Case{R"("sun": {"direction": [0, 0, 0]})",
             "/sun/direction: found [0,0,0], expected a vector that is not null"},
        Case{
            R"("sun": {"direction": [0, 1, 0], "azimuth_deg": 3})",
            "/sun/azimuth_deg: found an angle beside /sun/direction, expected either the direction "
            "or angles"},
        Case{R"("sun": {"date": "2024-06-21", "time": "6:30", "latitude_deg": 0})",
             "/sun/longitude_deg: found nothing, expected date, time, latitude_deg and "
             "longitude_deg, which belong together"},
        Case{R"("sun": {"date": "2024-06-31", "time": "06:30", "latitude_deg": 0,
                        "longitude_deg": 0})",
             "/sun/date: found \"2024-06-31\", expected a day of the years 1900 to 2100 such as "
             "\"2024-06-21\""},
        Case{R"("sun": {"date": "2024-06-21", "time": "6:30", "latitude_deg": 0,
                        "longitude_deg": 0})",
             "/sun/time: found \"6:30\", expected a time of day such as \"06:30\", "
             "\"06:30:15Z\" or \"06:30+02:00\""},
        Case{R"("sun": {"date": "2024-06-21", "azimuth_deg": 3})",
             "/sun/azimuth_deg: found a direction beside date, time and place, expected either "
             "the one or the other"},
        Case{R"("camera": {"up": [0, 0, 0]})",
             "/camera/up: found [0, 0, 0], expected a vector that is not null"},
        Case{R"("camera": {"position": [1, 2, 3], "target": [1, 2, 3]})",
             "/camera/target: found the camera's own position, expected another point"},
        Case{R"("biome": {"ground": {"rock_slope_deg": [40, 30]}})",
             "/biome/ground/rock_slope_deg: found [40, 30], expected the smaller one first"},
        Case{R"("terrain": {"drape": {"file": "a.png"}})",
             "/terrain/drape/file: found a picture on ground that is made from noise, expected a "
             "file of elevation data in /terrain/source, or no picture"},
        Case{R"("terrain": {"source": "a.tif", "drape": {"corners": {"north_west": [47, 9]}}})",
             "/terrain/drape/corners: found one of north_west and south_east, expected both of "
             "them"},
        Case{R"("terrain": {"source": "a.tif",
                "drape": {"corners": {"north_west": [46, 9], "south_east": [47, 10]}}})",
             "/terrain/drape/corners: found latitudes 46 and 47, expected latitudes of -90 to 90, "
             "that of north_west the greater one"}));

TEST(SceneVersion, ComesFirst) {
  EXPECT_EQ(complaint("{}"), "x.json: /version: found nothing, expected 1");
  EXPECT_EQ(complaint(R"({"version": 2, "new": 1})"), "x.json: /version: found 2, expected 1");
  EXPECT_EQ(complaint(R"({"version": "1"})"), "x.json: /version: found \"1\", expected 1");
  EXPECT_EQ(complaint("[1, 2]"), "x.json: /: found [1,2], expected an object");
}

TEST(SceneSyntax, HasLineAndColumn) {
  EXPECT_EQ(complaint("{\n  \"version\": 1,\n  \"ä\": }\n")
                .find("x.json: line 3, column 8: syntax error"),
            0u);
  EXPECT_EQ(complaint("").find("x.json: line 1, column 1: "), 0u);
  EXPECT_EQ(complaint("{\"version\": 1,}").find("x.json: line 1, column 15: "), 0u);
  EXPECT_EQ(complaint("{\"version\": NaN}").find("x.json: line 1, column 13: "), 0u);
  EXPECT_EQ(complaint("{\"version\": 1").find("x.json: line 1, column 13: "), 0u);
  EXPECT_EQ(complaint("{\"version\": 1} x").find("x.json: line 1, column 16: "), 0u);
  EXPECT_LT(complaint("{\"version\": \"" + std::string(100000, 'x')).size(), 300u);
}

TEST(SceneGuards, StopBombs) {
  const std::string deep = std::string(200000, '[');
  EXPECT_NE(
      complaint(with("\"lights\": " + deep)).find("found deeper nesting, expected at most 64"),
      std::string::npos);
  std::string many = "0";
  for (int i = 0; i < 100001; ++i) many += ",0";
  EXPECT_NE(complaint(with("\"lights\": [" + many + "]")).find("found too many values"),
            std::string::npos);
  const std::string large = with("") + std::string(17 << 20, ' ');
  EXPECT_NE(complaint(large).find("found more than 16 MiB"), std::string::npos);
  EXPECT_LT(complaint(with("\"shading\": \"" + std::string(100000, 'x') + "\"")).size(), 300u);
}

TEST(SceneOverrideErrors, AreUsageWhenMalformed) {
  for (const char* text : {"image/width=5", "/image/width", "=5", "", "/a~2b=1", "/a~=1"}) {
    const auto [kind, message] = error_of([&] { parse_override(text); });
    EXPECT_EQ(kind, ErrorKind::usage) << text;
    EXPECT_EQ(message.find("--set: found "), 0u) << message;
  }
  std::string deep;
  for (int i = 0; i < 65; ++i) deep += "/a";
  EXPECT_EQ(error_of([&] { parse_override(deep + "=1"); }).first, ErrorKind::usage);
}

TEST(SceneOverrideErrors, NameThePlace) {
  const std::string scene = with(R"("lights": [{"position": [0, 0, 0]}])");
  EXPECT_EQ(
      complaint(scene, {{"/image/widht", "5"}}).find("x.json: /image/widht: found an unknown"), 0u);
  EXPECT_EQ(complaint(scene, {{"/image/width", "wide"}}),
            "x.json: /image/width: found \"wide\", expected an integer from 1 to 32768");
  EXPECT_EQ(complaint(scene, {{"/lights/5/intensity", "1"}}),
            "x.json: /lights/5: found \"5\", expected an index from 0 to 1 (1 appends)");
  EXPECT_EQ(complaint(scene, {{"/lights/00/intensity", "1"}}),
            "x.json: /lights/00: found \"00\", expected an index from 0 to 1 (1 appends)");
  EXPECT_EQ(complaint(scene, {{"/version/x", "1"}}),
            "x.json: /version: found 1, expected an object to hold \"x\"");
  EXPECT_EQ(complaint(scene, {{"/camera/fov_y_deg", "1e999"}}),
            "x.json: /camera/fov_y_deg: found \"1e999\", expected a number from 1 to 170");
  EXPECT_NE(complaint(scene, {{"/sun/direction", R"({"a": 1, "b": 2, "c": 3})"},
                              {"/sun/azimuth_deg", "5"},
                              {"/sun/x", "5"}})
                .find("/sun/x: found an unknown key"),
            std::string::npos);
  const auto [kind, message] = error_of([&] {
    read_text(scene, "x.json", {{"/lights", std::string(100, '[') + std::string(100, ']')}});
  });
  EXPECT_EQ(kind, ErrorKind::bad_data);
  EXPECT_NE(message.find("deeper nesting"), std::string::npos);
}

TEST(SceneFileErrors, SayWhatCannotBeRead) {
  const auto [missing, text] = error_of([] { read_file("/nonexistent/scene.json"); });
  EXPECT_EQ(missing, ErrorKind::io);
  EXPECT_EQ(text, "/nonexistent/scene.json: cannot read the scene: No such file or directory");
  const auto [folder, reason] = error_of([] { read_file(AEROSTAT_SOURCE_DIR); });
  EXPECT_EQ(folder, ErrorKind::io);
  EXPECT_NE(reason.find("it is a directory"), std::string::npos);
}

TEST(SceneFileErrors, EndlessFileIsCut) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP();
  const auto [kind, message] = error_of([] { read_file("/dev/zero"); });
  EXPECT_EQ(kind, ErrorKind::bad_data);
  EXPECT_NE(message.find("found more than 16 MiB"), std::string::npos) << message;
}

}  // namespace
}  // namespace aerostat::scene

// Tests that all faults of a scene are reported together, with their places in the text.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "scene/locate.hpp"
#include "scene/scene.hpp"
#include "scene/source.hpp"

namespace aerostat::scene {
namespace {

using Lines = std::vector<std::string>;

/// Returns the messages about a scene, or nothing if it is right.
Lines lines_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  try {
    read_text(text, "x.json", overrides);
  } catch (const BadScene& bad) {
    EXPECT_EQ(bad.kind(), ErrorKind::bad_data);
    EXPECT_FALSE(bad.faults().empty());
    return bad.lines();
  }
  return {};
}

/// Returns the messages up to the value that was found, for expectations that list many words.
Lines places_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  Lines lines = lines_of(text, overrides);
  for (std::string& line : lines) line = line.substr(0, line.find(", expected"));
  return lines;
}

TEST(SceneFaults, AreToldAllAtOnce) {
  EXPECT_EQ(places_of(R"({
  "version": 1,
  "image": {"widht": 5, "height": 0},  // two in one object
  "biome": "snwo",
  "sun": {"date": "2024-06-21", "azimuth_deg": 3},
  "camera": {"up": [0, 0, 0], "fov_y_deg": "wide"},
  "colour": 1,
  "lights": [{"position": [0, 0, 0]}, {"intensity": -1}]
})"),
            (Lines{
                "x.json:3:13: /image/widht: found an unknown key",
                "x.json:3:25: /image/height: found 0",
                "x.json:4:3: /biome/kind: found \"snwo\"",
                "x.json:5:3: /sun/time: found nothing",
                "x.json:5:3: /sun/latitude_deg: found nothing",
                "x.json:5:3: /sun/longitude_deg: found nothing",
                "x.json:5:33: /sun/azimuth_deg: found a direction beside date, time and place",
                "x.json:6:14: /camera/up: found [0, 0, 0]",
                "x.json:6:31: /camera/fov_y_deg: found \"wide\"",
                "x.json:7:3: /colour: found an unknown key",
                "x.json:8:40: /lights/1/intensity: found -1",
            }));
}

TEST(SceneFaults, OfOneKindDoNotHideEachOther) {
  EXPECT_EQ(lines_of(R"({"version": 1, "image": {"spp": 0, "width": 0}})").size(), 2u);
  EXPECT_EQ(lines_of(R"({"version": 1, "image": 1, "sun": 2, "sky": 3})").size(), 3u);
  EXPECT_EQ(lines_of(R"({"version": 1, "a": 1, "b": 2, "c": 3})").size(), 3u);
  EXPECT_EQ(lines_of(R"({"version": 1, "image": {"spp": 0}, "image": {"spp": 0}})").size(), 2u);
  EXPECT_EQ(lines_of(R"({"biome": "nowhere"})").size(), 2u);
  EXPECT_EQ(lines_of(R"({"version": 1, "biome": {"kind": "snow", "ground":
                         {"rock_slope_deg": [9, 1], "snow_slope_deg": [9, 1]}}})")
                .size(),
            2u);
  // A consequence of a reported fault is not reported as another fault.
  EXPECT_EQ(lines_of(R"({"version": 1, "sun": {"date": "2024-06-21", "time": 5,
                         "latitude_deg": 1, "longitude_deg": 1}})")
                .size(),
            1u);
}

TEST(SceneFaults, SuggestTheNearestKeyForEach) {
  const Lines lines = lines_of(R"({"version": 1, "image": {"widht": 1, "heigth": 1}})");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("did you mean \"width\"?"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("did you mean \"height\"?"), std::string::npos) << lines[1];
}

TEST(SceneFaults, OfOverridesHaveNoLine) {
  EXPECT_EQ(places_of("{\"version\": 1,\n \"image\": {\"width\": 5, \"spp\": 0}}",
                      {{"/image/width", "0"}}),
            (Lines{"x.json: /image/width: found 0", "x.json:2:24: /image/spp: found 0"}));
}

TEST(SceneFaults, WithoutNumberAreCounted) {
  std::string text = R"({"version": 1)";
  for (int i = 0; i < 70; ++i) text += ", \"wrong" + std::to_string(i) + "\": 1";
  const Lines lines = lines_of(text + "}");
  ASSERT_EQ(lines.size(), 51u);
  EXPECT_EQ(lines.back(), "x.json: and 20 more faults");
}

TEST(SceneFaults, OfAFileInTheWindowHaveTheirLine) {
  try {
    SceneSource::from_text("{\n\"version\": 1, \"x\": 1, \"y\": 1}", "y.json");
    FAIL();
  } catch (const BadScene& bad) {
    ASSERT_EQ(bad.faults().size(), 2u);
    EXPECT_EQ(bad.faults()[0].line, 2);
    EXPECT_EQ(bad.faults()[0].column, 15);
  }
}

TEST(Locate, FollowsAPointer) {
  using detail::locate;
  const std::string text =
      "\xEF\xBB\xBF/* a\n*/ {\"ä\": [1, \"]\\\"\", {\"b\": {}}], // }\n"
      " \"c\\u0020d\": 1e-3, \"last\": [[], true],\n \"c d\" : null }";
  const auto at = [&text](const detail::Pointer& pointer) {
    const detail::TextPlace place = locate(text, pointer);
    return std::to_string(place.line) + ":" + std::to_string(place.column);
  };
  EXPECT_EQ(at({}), "2:4");
  EXPECT_EQ(at({"ä"}), "2:5");
  EXPECT_EQ(at({"ä", "0"}), "2:11");
  EXPECT_EQ(at({"ä", "1"}), "2:14");
  EXPECT_EQ(at({"ä", "2", "b"}), "2:22");
  EXPECT_EQ(at({"last", "1"}), "3:33");
  EXPECT_EQ(at({"c d"}), "4:2") << "the last of two counts";
  EXPECT_EQ(at({"ä", "7"}), "2:5") << "of what is missing the parent";
  EXPECT_EQ(at({"last", "0", "x"}), "3:29");
  EXPECT_EQ(at({"none", "x"}), "2:4");
}

}  // namespace
}  // namespace aerostat::scene

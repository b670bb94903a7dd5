// Tests how values go from key to key.
#include "film/keys.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "support/error_of.hpp"

namespace aerostat::film {
namespace {

std::vector<scene::KeyTrack> tracks_of(const std::string& keys) {
  return scene::read_text(R"({"version": 1, "film": {"keys": [)" + keys + "]}}", "x.json")
      .film.keys;
}

/// Returns the value of the only track at a time.
std::string value_at(const std::string& track, double time_s) {
  return changes_at(tracks_of(track), time_s).at(0).value;
}

std::string message_of(const std::string& keys) {
  return test::error_of([&] { tracks_of(keys); }).what();
}

TEST(Keys, NumbersGoEvenlyOrSmoothlyOrHold) {
  const auto track = [](const std::string& ease) {
    return R"({"value": "/image/vignette", "ease": ")" + ease +
           R"(", "keys": [{"time_s": 2, "is": 0}, {"time_s": 6, "is": 0.5}]})";
  };
  EXPECT_EQ(value_at(track("linear"), 3.0), "0.125");
  EXPECT_EQ(value_at(track("smooth"), 3.0), "0.078125");  // 0.5 (3/16 - 2/64)
  EXPECT_EQ(value_at(track("smooth"), 4.0), "0.25");
  EXPECT_EQ(value_at(track("hold"), 5.9), "0");
  for (const char* ease : {"linear", "smooth", "hold"}) {
    EXPECT_EQ(value_at(track(ease), 0.0), "0") << ease;
    EXPECT_EQ(value_at(track(ease), 6.0), "0.5") << ease;
    EXPECT_EQ(value_at(track(ease), 99.0), "0.5") << ease;
  }
}

TEST(Keys, AnglesTakeTheShorterWay) {
  const std::string track =
      R"({"value": "/balloon/heading_deg", "ease": "linear",
          "keys": [{"time_s": 0, "is": 170}, {"time_s": 4, "is": -150}]})";
  EXPECT_EQ(value_at(track, 1.0), "180");
  EXPECT_EQ(value_at(track, 2.0), "190");
  const std::string over_north =
      R"({"value": "/sun/azimuth_deg", "ease": "linear",
          "keys": [{"time_s": 0, "is": 350}, {"time_s": 4, "is": 20}]})";
  // A sun at 365 degrees would be outside of the range of azimuths.
  EXPECT_EQ(value_at(over_north, 2.0), "5");
  // The angle of view is no full circle.
  const std::string zoom =
      R"({"value": "/camera/fov_y_deg", "ease": "linear",
          "keys": [{"time_s": 0, "is": 10}, {"time_s": 2, "is": 20}]})";
  EXPECT_EQ(value_at(zoom, 1.0), "15");
}

TEST(Keys, MoveArraysIntegersWordsAndTimes) {
  EXPECT_EQ(value_at(R"({"value": "/balloon/position", "ease": "linear",
      "keys": [{"time_s": 0, "is": [0, 10, -4]}, {"time_s": 2, "is": [4, 20, 4]}]})",
                     0.5),
            "[1, 12.5, -2]");
  EXPECT_EQ(value_at(R"({"value": "/image/spp", "ease": "linear",
      "keys": [{"time_s": 0, "is": 1}, {"time_s": 2, "is": 4}]})",
                     1.0),
            "3");
  const std::string lens = R"({"value": "/camera/lens",
      "keys": [{"time_s": 0, "is": "pinhole"}, {"time_s": 2, "is": "thin_lens"}]})";
  EXPECT_EQ(value_at(lens, 1.9), "pinhole");
  EXPECT_EQ(value_at(lens, 2.0), "thin_lens");
  const std::string sun = R"({"value": "/sun/time", "ease": "linear",
      "keys": [{"time_s": 0, "is": "06:30+02:00"}, {"time_s": 10, "is": "10:30Z"}]})";
  EXPECT_EQ(value_at(sun, 0.0), "04:30:00.000Z");
  EXPECT_EQ(value_at(sun, 5.0), "07:30:00.000Z");
  EXPECT_EQ(value_at(sun, 0.001), "04:30:02.160Z");
}

TEST(Keys, ElementsOfArraysAreFoundInBothForms) {
  const auto tracks = tracks_of(R"({"value": "/balloon/position/1", "ease": "linear",
      "keys": [{"time_s": 0, "is": 5}, {"time_s": 10, "is": 25}]})");
  EXPECT_EQ(element_at(tracks, "/balloon/position", 1, 5.0), 15.0);
  EXPECT_EQ(element_at(tracks, "/balloon/position", 0, 5.0), std::nullopt);
  EXPECT_TRUE(is_moved(tracks, "/balloon/position"));
  EXPECT_TRUE(is_moved(tracks, "/balloon/position/1"));
  EXPECT_FALSE(is_moved(tracks, "/balloon/position/2"));
  EXPECT_FALSE(is_moved(tracks, "/balloon/pos"));
}

TEST(Keys, MistakesAreTold) {
  const auto track = [](const std::string& value, const std::string& is) {
    return R"({"value": ")" + value + R"(", "keys": [{"time_s": 0, "is": )" + is + "}]}";
  };
  const std::pair<std::string, std::string> mistakes[] = {
      {track("/sun/elevation", "1"), "/film/keys/0/value: found \"/sun/elevation\""},
      {track("/film/fps", "1"), "/film/keys/0/value"},
      {track("/image/width", "64"), "/film/keys/0/value"},
      {track("/terrain/source", "\"a.tif\""), "/film/keys/0/value"},
      {track("/festival/count", "1"), "/film/keys/0/value"},
      {track("/lights", "1"), "/film/keys/0/value"},
      {track("/image/vignette", "2"),
       "/film/keys/0/keys/0/is: found 2, expected a number from 0 to 0.9"},
      {track("/image/vignette", "[0]"), "found [0], expected a number"},
      {track("/image/vignette", "\"dark\""), "found \"dark\", expected a number"},
      {track("/balloon/position", "[1, 2]"), "found [1, 2], expected an array of 3 numbers"},
      {track("/camera/lens", "\"wide\""), "expected one of pinhole, thin_lens"},
      {track("/sun/time", "\"noon\""), "expected a time of day"},
      {R"({"value": "/image/vignette", "keys": []})", "/film/keys/0/keys: found no key"},
      {R"({"value": "/image/vignette", "keys": [{"time_s": 2, "is": 0}, {"time_s": 2, "is": 0}]})",
       "/film/keys/0/keys/1/time_s: found 2 after 2"},
      {track("/image/vignette", "0") + "," + track("/image/vignette", "0"), "each value once"},
  };
  for (const auto& [keys, part] : mistakes) {
    EXPECT_NE(message_of(keys).find(part), std::string::npos) << keys << "\n" << message_of(keys);
  }
}

}  // namespace
}  // namespace aerostat::film

// Tests that `aerostat check` reports on flight tracks.

#include <string>

#include <nlohmann/json.hpp>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using Track = CliTest;

std::string digits(int number, int count) {
  const std::string text = std::to_string(number);
  return std::string(static_cast<std::size_t>(count) - text.size(), '0') + text;
}

/// Returns a file of a logger that lies still for a minute and flies east for five minutes, up and
/// down again.
std::string igc() {
  std::string text = "AXXX001\r\nHFDTEDATE:021023,01\r\nHFGTYGLIDERTYPE:Cameron Z-105\r\n";
  for (int i = 0; i < 360; ++i) {
    const int flown = i < 60 ? 0 : i - 60;
    const int height = 500 + 2 * (flown < 150 ? flown : 300 - flown);
    text += "B07" + digits(45 + i / 60, 2) + digits(i % 60, 2) + "4600000N00900" +
            digits(3 * flown, 3) + "EA" + digits(height - 100, 5) + digits(height, 5) + "\r\n";
  }
  return text;
}

std::string gpx(const std::string& times) {
  return "<gpx><trk><name>Walk</name><trkseg><trkpt lat=\"46\" lon=\"9\"><ele>500</ele>" + times +
         "</trkpt><trkpt lat=\"46.01\" lon=\"9\"/></trkseg></trk></gpx>";
}

TEST_F(Track, CheckReportsOnATrackWhateverItsName) {
  for (const char* name : {"flight.igc", "flight", "flight.json"}) {
    const Outcome outcome = run({"check", write(name, igc())});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(contains(outcome.out, std::string(name) + ": IGC track 'Cameron Z-105'\n"));
    EXPECT_TRUE(contains(outcome.out, "fixes     360, one every 1 s\n"));
    EXPECT_TRUE(contains(outcome.out, "take-off  2023-10-02 07:4"));
    EXPECT_TRUE(contains(outcome.out, "gaps      none\n"));
    EXPECT_TRUE(contains(outcome.out, "heights   GNSS heights, smoothed over 20 s; not tested"));
  }
}

TEST_F(Track, CheckPrintsJson) {
  const Outcome outcome = run({"check", write("flight.igc", igc()), "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["format"], "IGC");
  EXPECT_EQ(json["fixes"], 360);
  EXPECT_EQ(json["heights"]["source"], "gnss");
  EXPECT_NEAR(json["highest_m"].get<double>(), 800.0, 7.0);
  EXPECT_NEAR(json["takeoff"]["time_s"].get<double>(), 1696232760.0, 5.0);
  EXPECT_TRUE(json["gaps"].empty());
  EXPECT_TRUE(json["notes"].is_array());
}

/// Returns elevation data around the flight: an ESRI grid in degrees with ground at 420 m, from
/// 45.9 N 8.9 E over 0.4 degrees.
std::string plain_asc() {
  std::string text =
      "ncols 40\nnrows 40\nxllcorner 8.9\nyllcorner 45.9\ncellsize 0.01\nNODATA_value -9999\n";
  for (int i = 0; i < 40 * 40; ++i) text += i % 40 == 39 ? "420\n" : "420 ";
  return text;
}

TEST_F(Track, CheckFitsHeightsToTheLandBelow) {
  const std::string track = write("flight.igc", igc()), land = write("plain.asc", plain_asc());
  write("plain.prj", "Projection GEOGRAPHIC\nDatum WGS84\nUnits DD\n");
  const Outcome outcome = run({"check", track, "--land", land, "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json["heights"]["has_ground"].get<bool>());
  EXPECT_NEAR(json["heights"]["gnss_over_ground_start_m"].get<double>(), 80.0, 2.0);
  EXPECT_NEAR(json["takeoff"]["ground_m"].get<double>(), 420.0, 0.5);
  const Outcome text = run({"check", track, "--land", land});
  EXPECT_TRUE(contains(text.out, "over the ground at the start")) << text.out;
  EXPECT_FALSE(contains(text.out, "not tested"));
}

TEST_F(Track, CheckRefusesLandThatIsNoneOrLiesNowhere) {
  const std::string track = write("flight.igc", igc());
  const Outcome missing = run({"check", track, "--land", "nowhere.tif"});
  EXPECT_EQ(missing.code, 74) << missing.err;
  EXPECT_TRUE(contains(missing.err, "nowhere.tif"));
  std::string metres = plain_asc();
  metres.replace(metres.find("cellsize 0.01"), 13, "cellsize 30.0");
  const Outcome unplaced = run({"check", track, "--land", write("metres.asc", metres)});
  EXPECT_EQ(unplaced.code, 65) << unplaced.err;
  EXPECT_TRUE(contains(unplaced.err, "does not say where on the Earth it lies"));
  const Outcome scene = run({"check", scene_path("snow"), "--land", "plain.asc"});
  EXPECT_EQ(scene.code, 64);
  EXPECT_TRUE(contains(scene.err, "is no track"));
}

TEST_F(Track, CheckSaysWhatIsMissing) {
  const Outcome outcome = run({"check", write("walk.gpx", gpx(""))});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "walk.gpx: GPX track 'Walk'\n"));
  EXPECT_TRUE(contains(outcome.out, "note      The track has no times."));
}

TEST_F(Track, CheckRefusesTracksThatCannotBeUsed) {
  const Outcome empty = run({"check", write("empty.gpx", "<gpx></gpx>")});
  EXPECT_EQ(empty.code, 65);
  EXPECT_TRUE(contains(empty.err, "empty.gpx: no fix with a usable place was found in the file"));
  const Outcome set = run({"check", write("a.igc", igc()), "--set", "/sun/elevation_deg=5"});
  EXPECT_EQ(set.code, 64);
  EXPECT_TRUE(contains(set.err, "--set: '"));
}

TEST_F(Track, CheckOfAnInventedSceneHasNoJson) {
  const Outcome outcome = run({"check", scene_path("snow"), "--json"});
  EXPECT_EQ(outcome.code, 64);
  EXPECT_TRUE(contains(outcome.err, "is no track and has no elevation data"));
}

}  // namespace
}  // namespace aerostat::test

// Tests of commands on files of heights: reports, maps and names of places.
#include <string>

#include <nlohmann/json.hpp>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

/// A hill of 40 x 40 samples in UTM zone 32.
class Land : public CliTest {
 protected:
  std::string hill() {
    std::string text = "ncols 40\nnrows 40\nxllcenter 500000\nyllcenter 5200000\ncellsize 50\n";
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 40; ++i) {
        const int off = (i - 20) * (i - 20) + (j - 20) * (j - 20);
        text += std::to_string(j == 3 && i == 4 ? -9999 : 900 - off / 2) + " ";
      }
      text += "\n";
    }
    return write("hill.asc", text);
  }

  /// Returns the arguments of a command on the hill, with more behind them.
  std::vector<std::string> on_hill(std::vector<std::string> arguments,
                                   const std::vector<std::string>& more = {}) {
    arguments.insert(arguments.end(), {hill(), "--set", "/terrain/crs=EPSG:32632"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

TEST_F(Land, CheckReportsOnAFileOfHeights) {
  const Outcome outcome = run(on_hill({"check"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "hill.asc: land from a file\n"));
  EXPECT_TRUE(contains(outcome.out, "files     hill.asc: ESRI grid (.asc), int32"));
  EXPECT_TRUE(contains(outcome.out, "40 x 40 samples"));
  EXPECT_TRUE(contains(outcome.out, "system    WGS 84 / UTM zone 32N\n"));
  EXPECT_TRUE(contains(outcome.out, "heights   500 to 900 m\n"));
  EXPECT_TRUE(contains(outcome.out, "gaps      1 of 1,600 samples have no height"));
  EXPECT_TRUE(contains(outcome.out, "sea       none\n"));
  EXPECT_TRUE(contains(outcome.out, "note      No camera is given"));
  EXPECT_TRUE(contains(outcome.err, "hill.asc: ok\n"));
}

TEST_F(Land, CheckReportsInJsonWithWhatWasChosen) {
  const Outcome outcome = run(on_hill({"check"}, {"--json"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["files"][0]["width"], 40);
  EXPECT_EQ(json["files"][0]["crs"], "WGS 84 / UTM zone 32N");
  EXPECT_NEAR(json["middle"]["longitude_deg"].get<double>(), 9.0, 0.02);
  EXPECT_EQ(json["highest_m"], 900.0);
  EXPECT_EQ(json["voids"], 1);
  EXPECT_EQ(json["has_sea"], false);
  EXPECT_TRUE(json["chosen"]["/camera/position"].is_array());
  EXPECT_TRUE(json["chosen"]["/sun/date"].is_string());
  EXPECT_TRUE(json["notes"].is_array());
}

TEST_F(Land, ABareFileBecomesAMapInItsOwnGrid) {
  const std::string map = "relief.tif";
  const Outcome outcome = run(on_hill({"render"}, {"-o", map, "--spp", "1"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "wrote " + map));
  EXPECT_EQ(read_bytes(folder_ / map).substr(0, 4), std::string("II*\0", 4));
}

TEST_F(Land, AFileOfAnUnknownFormatIsSaidToBeOne) {
  const Outcome binary = run({"render", write("saga.sdat", std::string("\x12\0\x7f\xff", 4))});
  EXPECT_EQ(binary.code, 65);
  EXPECT_TRUE(contains(binary.err, "saga.sdat: this is neither a scene, which is JSON, nor"));
  EXPECT_TRUE(contains(binary.err, "`gdal_translate saga.sdat land.tif`"));
  const Outcome list = run({"check", write("all.vrt", "<VRTDataset rasterXSize=\"5\"/>")});
  EXPECT_EQ(list.code, 65);
  EXPECT_TRUE(contains(list.err, "a VRT only names other files"));
  // What begins as JSON does is a scene, whatever its name.
  const Outcome scene =
      run({"check", write("scene.txt", "\xEF\xBB\xBF  {\"version\": 1, \"x\": 1}")});
  EXPECT_EQ(scene.code, 65);
  EXPECT_TRUE(contains(scene.err, "/x: found an unknown key"));
}

TEST_F(Land, AViewIsNoMap) {
  const Outcome outcome =
      run(on_hill({"render"}, {"-o", "relief.tif", "--set", "/camera/position=[0, 1500, 900]",
                               "--set", "/camera/target=[0, 800, 0]"}));
  EXPECT_EQ(outcome.code, 65);
  EXPECT_TRUE(contains(outcome.err, "--output: the picture is no map"));
  const Outcome invented = run({"render", scene_path("snow"), "-o", "relief.tif"});
  EXPECT_EQ(invented.code, 65);
  EXPECT_TRUE(contains(invented.err, "--output: the picture is no map"));
}

TEST_F(Land, PlacesAreNamedBesideThePicture) {
  const std::string places = write("places.csv", "name,lat,lon\nHill,46.9615,9.0131\n");
  const Outcome outcome =
      run(on_hill({"render"}, {"--labels", places, "--labels-json", "names.json", "-o", "hill.png",
                               "--spp", "1", "--width", "160", "--height", "90"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(read_bytes(folder_ / "hill.svg"), "<svg"));
  const auto json = nlohmann::json::parse(read_bytes(folder_ / "names.json"));
  EXPECT_TRUE(contains(json.dump(), "\"Hill\""));
}

}  // namespace
}  // namespace aerostat::test

#include "staging/stage.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "scene/scene.hpp"
#include "scene/sun_angles.hpp"
#include "staging/flight_path.hpp"
#include "staging/map_stage.hpp"
#include "staging/view_choice.hpp"
#include "staging/view_map.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::staging {
namespace {

namespace fs = std::filesystem;

/// A plain with one mountain in the north-east, in UTM zone 32.
class StageFile : public ::testing::Test {
 protected:
  StageFile()
      : file_(fs::temp_directory_path() /
              (std::string("aerostat-stage-") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".asc")) {
    std::ofstream out(file_);
    out << "ncols 101\nnrows 101\nxllcenter 490000\nyllcenter 5190000\ncellsize 200\n";
    for (int j = 0; j < 101; ++j) {
      for (int i = 0; i < 101; ++i) {
        out << 500.0 + 3000.0 * std::exp(-(std::pow(i - 75, 2) + std::pow(j - 25, 2)) / 200.0)
            << ' ';
      }
      out << '\n';
    }
  }
  ~StageFile() override { fs::remove(file_); }

  scene::SceneSource source(const std::vector<scene::Override>& more = {}) const {
    return scene_around(file_).with({{"/terrain/crs", "EPSG:32632"}}).with(more);
  }

  fs::path file_;
  terrain::ReliefCache reliefs_;
};

TEST_F(StageFile, ABareFileBecomesAWholeScene) {
  const Staged staged = stage(source(), reliefs_);
  const scene::Scene& scene = staged.source.scene();
  ASSERT_TRUE(scene.camera.position && scene.camera.target);
  ASSERT_TRUE(scene.terrain.place.latitude_deg);
  EXPECT_NEAR(*scene.terrain.place.latitude_deg, 46.95, 0.1);
  EXPECT_FALSE(scene.biome.water.enabled);
  EXPECT_EQ(scene.biome.kind, scene::BiomeKind::snow);
  EXPECT_NEAR(scene::detail::angles_of(scene.sun.direction).elevation_deg, 21.0, 1.0);
  EXPECT_GE(staged.notes.size(), 3u);
  // The scene is complete: staging it once more changes nothing.
  EXPECT_EQ(stage(staged.source, reliefs_).source.text(), staged.source.text());
}

TEST_F(StageFile, TheCameraLooksAtTheMountain) {
  const Staged staged = stage(source(), reliefs_);
  const scene::Scene& scene = staged.source.scene();
  const auto land = terrain::real_land(scene.terrain, reliefs_.lands);
  const ViewMap map(*land, terrain::middle_point(scene.terrain, *land), 20000.0, false);
  const dvec2 to_summit(map.summit().x, map.summit().z);
  const double azimuth = std::atan2(to_summit.x, -to_summit.y) * 180.0 / 3.14159265358979;
  const dvec3 look = *scene.camera.target - *scene.camera.position;
  const double view = std::atan2(look.x, -look.z) * 180.0 / 3.14159265358979;
  EXPECT_LT(std::abs(std::remainder(view - azimuth, 360.0)), 25.0);
}

TEST_F(StageFile, ABiomeMayBeLeftToTheLandByAWord) {
  const Staged expected = stage(source(), reliefs_);
  EXPECT_EQ(stage(source({{"/biome", "auto"}}), reliefs_).source.text(), expected.source.text());
  EXPECT_EQ(
      stage(source({{"/biome/kind", "sand"}, {"/biome/kind", "auto"}}), reliefs_).source.text(),
      expected.source.text());
  const auto from_text = scene::SceneSource::from_text(
      R"({"version": 1, "biome": {"kind": "auto", "season": "autumn"}, "terrain": {"source": ")" +
          file_.string() + R"(", "crs": "EPSG:32632"}})",
      "x.json");
  EXPECT_EQ(stage(from_text, reliefs_).source.scene().biome.kind, scene::BiomeKind::snow);
}

TEST_F(StageFile, WhatTheSceneGivesWins) {
  const Staged staged = stage(source({{"/biome/kind", "sand"},
                                      {"/sun/azimuth_deg", "200"},
                                      {"/camera/position", "[0, 100, 0]"},
                                      {"/camera/target", "[0, 100, -1000]"},
                                      {"/biome/water/enabled", "true"}}),
                              reliefs_);
  const scene::Scene& scene = staged.source.scene();
  EXPECT_EQ(scene.biome.kind, scene::BiomeKind::sand);
  EXPECT_NEAR(scene::detail::angles_of(scene.sun.direction).azimuth_deg, 200.0 - 360.0, 1e-6);
  EXPECT_EQ(*scene.camera.position, dvec3(0, 100, 0));
  EXPECT_TRUE(scene.biome.water.enabled);
}

TEST_F(StageFile, AGivenPlaceStays) {
  const Staged staged =
      stage(source({{"/terrain/place", R"({"easting": 495000, "northing": 5195000})"}}), reliefs_);
  const scene::TerrainPlace& place = staged.source.scene().terrain.place;
  EXPECT_EQ(place.easting, 495000.0);
  EXPECT_FALSE(place.latitude_deg);
}

TEST_F(StageFile, PlacesOnTheEarthBecomePositions) {
  const geo::Place middle = geo::place_of("EPSG:32632", {500000.0, 5200000.0});
  const geo::Place north = geo::place_of_local(middle, {100.0, -3000.0});
  const auto text = [](const geo::Place& place, double height) {
    return fmt::format(R"({{"latitude_deg": {:.12f}, "longitude_deg": {:.12f}, "height_m": {}}})",
                       place.latitude_deg, place.longitude_deg, height);
  };
  const Staged staged = stage(source({{"/balloon/at", text(middle, 120.0)},
                                      {"/camera/at", text(north, 30.0)},
                                      {"/camera/look_at", text(middle, 100.0)},
                                      {"/lights/0/at", text(north, 12.0)},
                                      {"/lights/1/at", text(north, 1300.0)},
                                      {"/lights/1/height_above", "sea"}}),
                              reliefs_);
  const scene::Scene& scene = staged.source.scene();
  EXPECT_NEAR(*scene.terrain.place.latitude_deg, middle.latitude_deg, 1e-7);
  EXPECT_NEAR(scene.balloon.position.y, 120.0, 1e-6);
  EXPECT_LT(glm::length(dvec2(scene.balloon.position.x, scene.balloon.position.z)), 0.02);
  EXPECT_NEAR(scene.camera.position->x, 100.0, 0.02);
  EXPECT_NEAR(scene.camera.position->z, -3000.0, 0.02);
  EXPECT_EQ(scene.camera.height_above, scene::HeightReference::ground);
  EXPECT_LT(glm::distance(scene.lights[0].position, dvec3(100.0, 12.0, -3000.0)), 0.02);
  EXPECT_EQ(scene.lights[0].height_above, scene::HeightReference::ground);
  EXPECT_LT(glm::distance(scene.lights[1].position,
                          dvec3(100.0, 1300.0 - geo::curvature_drop(3000.0), -3000.0)),
            0.05);
  EXPECT_EQ(scene.lights[1].height_above, scene::HeightReference::sea);
  EXPECT_EQ(stage(staged.source, reliefs_).source.text(), staged.source.text());
}

TEST_F(StageFile, ATrackPutsTheBalloonAndTheSunWhereTheyWere) {
  const fs::path track = file_.string() + ".gpx";
  std::ofstream(track) << R"(<gpx version="1.1"><trk><trkseg>
    <trkpt lat="46.95" lon="9.00"><ele>800</ele><time>2023-10-02T07:00:00Z</time></trkpt>
    <trkpt lat="46.96" lon="9.00"><ele>1200</ele><time>2023-10-02T07:10:00Z</time></trkpt>
    <trkpt lat="46.97" lon="9.00"><ele>1600</ele><time>2023-10-02T07:20:00Z</time></trkpt>
    </trkseg></trk></gpx>)";
  const auto staged = [&](const std::string& more) {
    return stage(
        source({{"/balloon/track", fmt::format(R"({{"file": "{}"{}}})", track.string(), more)}}),
        reliefs_);
  };
  const Staged at_time = staged(R"(, "at": "2023-10-02T07:10:00Z")");
  const scene::Scene& scene = at_time.source.scene();
  EXPECT_NEAR(*scene.terrain.place.latitude_deg, 46.96, 1e-4);
  EXPECT_NEAR(scene.balloon.position.y, 1200.0, 60.0);
  EXPECT_EQ(scene.balloon.height_above, scene::HeightReference::sea);
  EXPECT_EQ(at_time.source.value("/sun/date"), "\"2023-10-02\"");
  EXPECT_EQ(at_time.source.value("/sun/time"), "\"07:10:00Z\"");
  EXPECT_NEAR(*staged(R"(, "share": 1)").source.scene().terrain.place.latitude_deg, 46.97, 1e-4);
  EXPECT_THROW(staged(R"(, "at": "noon")"), Error);
  fs::remove(track);
}

TEST_F(StageFile, AFlightGoesOnFromWhereItsTrackBegins) {
  const fs::path file = file_.string() + ".gpx";
  std::ofstream(file) << R"(<gpx version="1.1"><trk><trkseg>
    <trkpt lat="46.95" lon="9.00"><ele>800</ele><time>2023-10-02T07:00:00Z</time></trkpt>
    <trkpt lat="46.96" lon="9.00"><ele>1200</ele><time>2023-10-02T07:10:00Z</time></trkpt>
    <trkpt lat="46.97" lon="9.00"><ele>1600</ele><time>2023-10-02T07:20:00Z</time></trkpt>
    </trkseg></trk></gpx>)";
  const auto path = [&](const std::string& more) {
    const auto staged = stage(
        source({{"/balloon/track", fmt::format(R"({{"file": "{}"{}}})", file.string(), more)}}),
        reliefs_);
    const scene::Scene& scene = staged.source.scene();
    return std::pair{FlightPath(*scene.balloon.track, scene.terrain, reliefs_),
                     scene.balloon.position};
  };
  const auto [given, still] = path(R"(, "at": "2023-10-02T07:10:00Z")");
  EXPECT_NEAR(glm::distance(given.after(0.0).position, still), 0.0, 0.1);
  // A minute later it is a tenth of the way to the last fix further north.
  const dvec3 later = given.after(60.0).position;
  EXPECT_NEAR(later.z - still.z, -0.001 * 111190.0, 8.0);
  EXPECT_NEAR(later.y - still.y, 40.0, 8.0);
  EXPECT_EQ(*given.after(60.0).time_s - *given.after(0.0).time_s, 60.0);
  EXPECT_EQ(given.after(600.0).position, given.after(1e6).position) << "it has landed";
  const auto whole = path("").first;
  EXPECT_EQ(*given.after(0.0).time_s - *whole.after(0.0).time_s, 600.0) << "from the take-off";
  fs::remove(file);
}

TEST_F(StageFile, ViewsDiffer) {
  const auto views = stage_views(source(), reliefs_, 4);
  ASSERT_GE(views.size(), 3u);
  for (std::size_t k = 1; k < views.size(); ++k) {
    EXPECT_NE(views[k].source.text(), views[0].source.text());
  }
}

TEST_F(StageFile, OtherScenesStayAsTheyAre) {
  const scene::SceneSource plain;
  EXPECT_EQ(stage(plain, reliefs_).source.text(), plain.text());
  EXPECT_TRUE(stage(plain, reliefs_).notes.empty());
}

TEST_F(StageFile, AViewThatASlopeBlocksIsWorse) {
  const scene::SceneSource given = source();
  const auto land = terrain::real_land(given.scene().terrain, reliefs_.lands);
  const ViewMap map(*land, land->middle(), 20000.0, false);
  // From the foot of the mountain it fills the view, and from afar it stands on the horizon.
  const dvec2 summit(map.summit().x, map.summit().z);
  const auto near = choose_views(map, 90.0, 1, {summit + dvec2(-900.0, 900.0)});
  const auto far = choose_views(map, 90.0, 1, {summit + dvec2(-5000.0, 5000.0)});
  ASSERT_TRUE(!near.empty() && !far.empty());
  EXPECT_GT(far[0].score, near[0].score);
}

TEST_F(StageFile, AMapShowsAllOfTheFileFromAbove) {
  const Staged staged = stage_map(source(), reliefs_);
  const scene::Scene& scene = staged.source.scene();
  EXPECT_EQ(scene.camera.lens, scene::Lens::orthographic);
  ASSERT_TRUE(scene.camera.position && scene.camera.target);
  EXPECT_EQ(scene.camera.position->x, scene.camera.target->x);
  EXPECT_EQ(scene.camera.position->z, scene.camera.target->z);
  EXPECT_GT(scene.camera.position->y, 3500.0);
  EXPECT_NEAR(scene.camera.view_height_m, 20200.0, 300.0);
  const double pixel_m = scene.camera.view_height_m / scene.image.height;
  EXPECT_NEAR(pixel_m, 160.0, 2.0);
  EXPECT_NEAR(scene.image.width, scene.image.height, 2);
  EXPECT_FALSE(scene.balloon.enabled);
  EXPECT_EQ(scene.terrain.detail, 0.0);
  EXPECT_EQ(scene.surfaces, scene::Surfaces::plain);
  EXPECT_NEAR(scene.sun.direction.x, -0.5, 1e-6);
}

TEST_F(StageFile, AMapKeepsWhatTheSceneGives) {
  const Staged part =
      stage_map(source({{"/terrain/extent_m", "4000"}, {"/biome/kind", "sand"}}), reliefs_);
  EXPECT_NEAR(part.source.scene().camera.view_height_m, 4040.0, 1.0);
  EXPECT_EQ(part.source.scene().surfaces, scene::Surfaces::full);
  const Staged view = stage_map(
      source({{"/camera/position", "[0, 100, 0]"}, {"/camera/target", "[0, 100, -1]"}}), reliefs_);
  EXPECT_EQ(view.source.scene().camera.lens, scene::Lens::pinhole);
}

TEST_F(StageFile, TooLargeAMapNamesTheSettingsThatHelp) {
  try {
    stage_map(source({{"/terrain/extent_m", "6000000"}}), reliefs_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/terrain/extent_m"), std::string::npos);
  }
}

}  // namespace
}  // namespace aerostat::staging

// Tests of the lines that show where a balloon flew.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geo/transform.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"
#include "support/temporary_folder.hpp"
#include "world/world.hpp"

namespace aerostat {
namespace {

constexpr int kFixes = 61;
constexpr double kGround_m = 400.0, kStep_m = 30.0;

/// Writes level land, and a flight of 1800 m to the east over its middle: up to 900 m above the sea
/// and down again.
scene::Scene flown_scene(const test::TemporaryFolder& folder, const std::string& line) {
  std::ofstream land(folder.path() / "land.asc");
  land << "ncols 81\nnrows 81\nxllcenter 498000\nyllcenter 5198000\ncellsize 50\n";
  for (int i = 0; i < 81 * 81; ++i) land << kGround_m << (i % 81 == 80 ? '\n' : ' ');
  land.close();
  const geo::Place middle = geo::place_of("EPSG:32632", {500000.0, 5200000.0});
  std::ofstream flight(folder.path() / "flight.gpx");
  flight << "<gpx><trk><trkseg>";
  for (int i = 0; i < kFixes; ++i) {
    const geo::Place at = geo::place_of_local(middle, {kStep_m * (i - 30), 0.0});
    const double height = kGround_m + 500.0 * std::sin(3.14159265 * i / (kFixes - 1));
    flight << fmt::format(
        "<trkpt lat=\"{:.8f}\" lon=\"{:.8f}\"><ele>{:.1f}</ele>"
        "<time>2023-10-02T07:{:02}:{:02}Z</time></trkpt>",
        at.latitude_deg, at.longitude_deg, height, i / 6, 10 * (i % 6));
  }
  flight << "</trkseg></trk></gpx>";
  flight.close();
  const std::string track =
      fmt::format(R"({{"file": "{}"{}}})", (folder.path() / "flight.gpx").string(), line);
  scene::Scene scene = scene::read_text(
      fmt::format(R"({{"version": 1, "biome": "meadow", "terrain": {{"kind": "elevation",
          "source": "{}", "crs": "EPSG:32632", "grading": 1, "detail": 0, "curved": false}},
          "balloon": {{"position": [0, 100, 500], "track": {}}}}})",
                  (folder.path() / "land.asc").string(), track),
      "x.json");
  scene.terrain.size_m = 3900.0;
  scene.terrain.cells = 80;
  scene.vegetation.enabled = false;
  scene.camera.position = {0.0, 3000.0, 0.0};
  scene.camera.target = {0.0, 0.0, -1000.0};
  return scene;
}

const world::Objects& lines_of(const world::World& world) {
  return *world::shape_of<world::Objects>(world, world::kTrackLines);
}

TEST(TrackLines, FollowTheFlightInTheAirAndOnTheGround) {
  const test::TemporaryFolder folder;
  const world::World world =
      world::build(world::resolve(flown_scene(folder, R"(, "line": {"width_m": 2})")));
  const world::Objects& lines = lines_of(world);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].id, scene::ObjectId::track);
  double west = 0.0, east = 0.0, highest = 0.0;
  int on_ground = 0, in_air = 0;
  for (const vec3& position : lines[0].mesh.positions) {
    const dvec3 p = dvec3(position) + world.scene.origin();
    west = std::min(west, p.x);
    east = std::max(east, p.x);
    highest = std::max(highest, p.y);
    EXPECT_NEAR(p.z, 0.0, 1.6);
    const double share = (p.x + 900.0) / 1800.0;
    const double flown = kGround_m + 500.0 * std::sin(3.14159265 * share);
    if (std::abs(p.y - kGround_m) < 0.6) {
      ++on_ground;
    } else if (std::abs(p.y - flown) < 25.0) {
      ++in_air;
    } else {
      FAIL() << p.x << ' ' << p.y;
    }
  }
  EXPECT_NEAR(west, -900.0, 60.0);
  EXPECT_NEAR(east, 900.0, 60.0);
  EXPECT_NEAR(highest, 900.0, 10.0);
  EXPECT_GT(on_ground, 300);
  EXPECT_GT(in_air, 2000);
}

TEST(TrackLines, AreThereOnlyIfTheSceneAsksForThem) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(lines_of(world::build(world::resolve(flown_scene(folder, "")))).empty());
  const auto in_air = R"(, "line": {"on_ground": false})";
  const world::World world = world::build(world::resolve(flown_scene(folder, in_air)));
  ASSERT_EQ(lines_of(world).size(), 1u);
  for (const vec3& position : lines_of(world)[0].mesh.positions) {
    EXPECT_GT(dvec3(position).y + world.scene.origin().y, kGround_m + 1.0);
  }
}

TEST(TrackLines, LeaveTheBalloonFree) {
  const test::TemporaryFolder folder;
  scene::Scene scene = flown_scene(folder, R"(, "line": {"on_ground": false})");
  scene.balloon.height_above = scene::HeightReference::sea;
  scene.balloon.position = {0.0, 900.0, 0.0};
  const world::World world = world::build(world::resolve(scene));
  ASSERT_EQ(lines_of(world).size(), 1u);
  const dvec3 middle = scene.balloon.position + dvec3(0.0, 0.5 * scene.balloon.diameter_m, 0.0);
  for (const vec3& position : lines_of(world)[0].mesh.positions) {
    EXPECT_GT(glm::distance(dvec3(position) + world.scene.origin(), middle),
              0.7 * scene.balloon.diameter_m);
  }
}

}  // namespace
}  // namespace aerostat

// Tests scenes in time: frames depend on their number alone, and things move as the film says.
#include "film/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "film/frame_files.hpp"
#include "film/movers.hpp"
#include "model/balloon.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"
#include "world/surface.hpp"

namespace aerostat::film {
namespace {

scene::SceneSource source(const std::string& film, const std::string& more = "") {
  return scene::SceneSource::from_text(
      R"({"version": 1, "biome": "sand", "terrain": {"cells": 32}, "film": {)" + film + "}" + more +
          "}",
      "x.json");
}

class TimelineTest : public testing::Test {
 protected:
  terrain::ReliefCache reliefs_;
};

TEST_F(TimelineTest, CountsItsFrames) {
  Timeline timeline(source(R"("duration_s": 2.5, "fps": 10)"), reliefs_);
  EXPECT_EQ(timeline.frames(), 25);
  EXPECT_EQ(timeline.time_of(1), 0.0);
  EXPECT_EQ(timeline.time_of(11), 1.0);
  EXPECT_EQ(frame_count(source(R"("duration_s": 0.001)").scene().film), 1);
}

TEST_F(TimelineTest, AnOpenShutterSeesMomentsInEvenSteps) {
  Timeline closed(source(R"("fps": 10, "shutter_moments": 4)"), reliefs_);
  EXPECT_EQ(closed.moments(), 1);
  EXPECT_EQ(closed.time_of_moment(11, 0), 1.0);
  Timeline open(source(R"("fps": 10, "shutter_angle_deg": 180, "shutter_moments": 4)"), reliefs_);
  ASSERT_EQ(open.moments(), 4);
  // The shutter is open for 0.05 s from the frame's time on.
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(open.time_of_moment(11, i), 1.0 + 0.05 * (i + 0.5) / 4.0, 1e-12) << i;
  }
}

TEST_F(TimelineTest, MarksKnowTheMomentsOfAFrame) {
  // The sun jumps between the times of two frames.
  const std::string keys = R"("fps": 10, "duration_s": 1, "keys": [{"value": "/sun/elevation_deg",
      "ease": "hold", "keys": [{"time_s": 0, "is": 20}, {"time_s": 0.13, "is": 30}]}])";
  const auto mark = [&](const std::string& more, int frame) {
    Timeline timeline(source(keys + more), reliefs_);
    return FrameMarks(timeline, FrameFormat::exr).mark_of(frame);
  };
  const std::string closed = mark("", 2), open = mark(R"(, "shutter_angle_deg": 180)", 2);
  EXPECT_NE(closed, open);
  EXPECT_NE(open, mark(R"(, "shutter_angle_deg": 90)", 2));
  EXPECT_NE(open, mark(R"(, "shutter_angle_deg": 180, "shutter_moments": 9)", 2));
  EXPECT_EQ(closed, mark(R"(, "shutter_moments": 9)", 2));
}

TEST_F(TimelineTest, FramesDependOnTheirNumberAlone) {
  const auto film = source(
      R"("wind": [{"height_m": 0, "speed_m_s": 2, "from_deg": 200}, {"height_m": 400, "speed_m_s": 9}],
         "keys": [{"value": "/balloon/position/1", "keys": [{"time_s": 0, "is": 10}, {"time_s": 9, "is": 300}]},
                  {"value": "/sun/elevation_deg", "keys": [{"time_s": 0, "is": 3}, {"time_s": 9, "is": 40}]}],
         "camera": {"mode": "chase"})",
      R"(, "festival": {"count": 3})");
  Timeline forth(film, reliefs_), back(film, reliefs_), alone(film, reliefs_);
  std::vector<std::string> texts;
  for (int frame = 1; frame <= 120; frame += 17) {
    texts.push_back(scene::write_text(forth.scene_at(frame)));
  }
  for (int i = 7; i >= 0; --i) {
    EXPECT_EQ(scene::write_text(back.scene_at(1 + 17 * i)), texts[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(scene::write_text(alone.scene_at(103)), texts[6]);
  EXPECT_NE(texts[0], texts[1]);
}

TEST_F(TimelineTest, TheFirstFrameIsTheScene) {
  const auto film = source(R"("fps": 25)");
  Timeline timeline(film, reliefs_);
  const auto still = world::resolve(film.scene(), reliefs_);
  const auto first = world::resolve(timeline.scene_at(1), reliefs_);
  EXPECT_EQ(first.eye(), still.eye());
  EXPECT_EQ(first.target(), still.target());
  EXPECT_EQ(first->balloon.position, still->balloon.position);
}

TEST_F(TimelineTest, TheWindCarriesBalloonsAndClouds) {
  Timeline timeline(
      source(R"("fps": 10, "turn_deg_s": 3, "wind": [{"speed_m_s": 5, "from_deg": 270}])",
             R"(, "balloon": {"position": [0, 900, 0], "height_above": "sea"})"),
      reliefs_);
  const scene::Scene start = timeline.scene_at(1), later = timeline.scene_at(41);
  const dvec3 way = later.balloon.position - start.balloon.position;
  EXPECT_NEAR(glm::distance(way, dvec3(20.0, 0.0, 0.0)), 0.0, 1e-9);
  EXPECT_NEAR(later.balloon.heading_deg - start.balloon.heading_deg, 12.0, 1e-9);
  EXPECT_NEAR(later.sky.cumulus.drift_m.x - start.sky.cumulus.drift_m.x, 20.0, 1e-9);
  EXPECT_NEAR(later.sky.cloud_drift_m.x - start.sky.cloud_drift_m.x, 20.0, 1e-9);
  EXPECT_EQ(later.biome.water.time_s, 4.0);
  EXPECT_NEAR(later.sky.cumulus.rise_m, 4.0, 1e-9);
  EXPECT_NEAR(later.sky.cloud_bend_m, 40.0, 1e-9);
  Timeline still(source(R"("fps": 10, "wind": [])"), reliefs_);
  EXPECT_EQ(still.scene_at(1).balloon.position, still.scene_at(90).balloon.position);
}

TEST_F(TimelineTest, BalloonsStayAboveTheGround) {
  const auto film = source(R"("duration_s": 600, "fps": 1, "wind": [{"speed_m_s": 8}])",
                           R"(, "balloon": {"position": [0, 1, 0]})");
  Timeline timeline(film, reliefs_);
  const world::Surface ground(film.scene());
  for (int frame = 1; frame <= 600; frame += 40) {
    const dvec3 at = timeline.scene_at(frame).balloon.position;
    EXPECT_GE(at.y, ground.height(at.x, at.z) - 1e-9) << frame;
  }
}

TEST_F(TimelineTest, KeysTakeABalloonOutOfTheWind) {
  Timeline timeline(source(R"("fps": 10, "keys": [{"value": "/balloon/position", "ease": "linear",
                "keys": [{"time_s": 0, "is": [0, 30, 0]}, {"time_s": 10, "is": [100, 30, 50]}]}])"),
                    reliefs_);
  const dvec3 at = timeline.scene_at(51).balloon.position;
  EXPECT_EQ(at.x, 50.0);
  EXPECT_EQ(at.z, 25.0);
}

TEST_F(TimelineTest, AFestivalDoesNotDependOnWhereTheBalloonIs) {
  // The balloon goes through the middle of the festival, where others would have no room.
  Timeline timeline(
      source(
          R"("wind": [], "keys": [{"value": "/balloon/position", "ease": "linear",
                "keys": [{"time_s": 0, "is": [-900, 50, 0]}, {"time_s": 10, "is": [900, 50, 0]}]}])",
          R"(, "festival": {"count": 12, "spread_m": [200, 200], "lowest_m": 40, "highest_m": 60})"),
      reliefs_);
  const scene::Scene start = timeline.scene_at_time(0.0), later = timeline.scene_at_time(5.0);
  ASSERT_EQ(start.balloons.size(), 12u);
  EXPECT_EQ(start.balloons, later.balloons);
}

TEST_F(TimelineTest, AFestivalTakesOffAtTimesOfItsSeed) {
  const auto film =
      source(R"("wind": [{"speed_m_s": 2}], "duration_s": 300, "launch_s": 60, "climb_m_s": 3)",
             R"(, "balloon": {"enabled": false},
           "festival": {"count": 8, "spread_m": [200, 200], "lowest_m": 40, "highest_m": 90,
                        "seed": 3})");
  Timeline timeline(film, reliefs_), again(film, reliefs_);
  const auto above = [&timeline](double time_s, std::size_t i) {
    const dvec3 at = timeline.scene_at_time(time_s).balloons[i].position;
    return at.y - timeline.ground_at(at.x, at.z);
  };
  const scene::Scene first = timeline.scene_at_time(0.0), last = timeline.scene_at_time(299.0);
  EXPECT_EQ(first.balloons, again.scene_at_time(0.0).balloons);
  std::size_t waiting = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const dvec3 start = first.balloons[i].position, end = last.balloons[i].position;
    const double launch = launch_time(3, i, 60.0);
    EXPECT_GE(launch, 0.0);
    EXPECT_LT(launch, 60.0);
    EXPECT_NEAR(above(0.999 * launch, i), 0.0, 1e-6) << i;
    waiting += timeline.scene_at_time(30.0).balloons[i].position == start ? 1 : 0;
    // All have come near to their heights above where they stood, and went with the wind.
    EXPECT_GT(end.y - start.y, 39.0) << i;
    EXPECT_NEAR(end.x - start.x, 2.0 * (299.0 - launch), 0.5);
    for (std::size_t k = 0; k < i; ++k) {
      const dvec3 off = start - first.balloons[k].position;
      EXPECT_GT(std::hypot(off.x, off.z), 30.0) << "apart on the ground";
    }
  }
  EXPECT_GT(waiting, 0u);
  EXPECT_LT(waiting, 8u);
  EXPECT_NE(launch_time(3, 0, 60.0), launch_time(4, 0, 60.0));
}

TEST(Launch, BeginsSoftlyAndEndsAtItsHeight) {
  const Launch launch{10.0, 100.0, 3.0};
  EXPECT_EQ(launch.climbed(10.0), 0.0);
  EXPECT_LT(launch.climbed(10.1), 0.02);
  EXPECT_NEAR(launch.climbed(300.0), 100.0, 0.1);
  double before = 0.0, fastest = 0.0;
  for (double time = 10.0; time < 200.0; time += 0.1) {
    const double now = launch.climbed(time);
    EXPECT_GE(now, before);
    fastest = std::max(fastest, (now - before) / 0.1);
    before = now;
    EXPECT_GE(launch.burner(time), 0.0);
    EXPECT_LE(launch.burner(time), 1.0);
  }
  EXPECT_LE(fastest, 3.0);
  EXPECT_GT(fastest, 2.0);
  EXPECT_EQ(launch.burner(1.0), 0.0);
}

TEST_F(TimelineTest, OrbitsCircleTheBalloon) {
  Timeline timeline(
      source(
          R"("fps": 10, "camera": {"mode": "orbit", "radius_m": 50, "height_m": 12, "from_deg": 90,
                                      "turn_deg_s": 45})",
          R"(, "balloon": {"position": [0, 2000, 0], "height_above": "sea"})"),
      reliefs_);
  const scene::Scene start = timeline.scene_at(1), later = timeline.scene_at(21);
  const dvec3 east = *start.camera.position - start.balloon.position;
  EXPECT_NEAR(glm::distance(east, dvec3(50.0, 12.0, 0.0)), 0.0, 1e-9);
  const dvec3 south = *later.camera.position - later.balloon.position;
  EXPECT_NEAR(glm::distance(south, dvec3(0.0, 12.0, 50.0)), 0.0, 1e-9);
  EXPECT_EQ(later.camera.target->x, later.balloon.position.x);
  EXPECT_GT(later.camera.target->y, later.balloon.position.y + 5.0);
}

TEST_F(TimelineTest, CamerasFlyAlongPaths) {
  Timeline timeline(source(R"("duration_s": 8, "fps": 10,
                "camera": {"mode": "path", "look": "ahead", "path": [
                  {"position": [0, 900, 0]}, {"position": [80, 900, 0]}, {"position": [160, 900, 0]}]})",
                           R"(, "camera": {"height_above": "sea"})"),
                    reliefs_);
  const scene::Camera camera = timeline.scene_at(41).camera;
  EXPECT_NEAR(glm::distance(*camera.position, dvec3(80.0, 900.0, 0.0)), 0.0, 1e-9);
  EXPECT_NEAR(glm::distance(*camera.target, dvec3(180.0, 900.0, 0.0)), 0.0, 1e-6);
}

TEST_F(TimelineTest, PassengersRideAlong) {
  Timeline timeline(source(R"("fps": 10, "camera": {"mode": "basket"})"), reliefs_);
  const scene::Scene later = timeline.scene_at(61);
  EXPECT_FALSE(later.camera.position);
  EXPECT_EQ(world::resolve(later, reliefs_).eye(), model::basket_eye(later.balloon));
}

TEST_F(TimelineTest, ObserversStandOnTheGround) {
  const auto film = source(R"("fps": 10, "camera": {"mode": "ground"})",
                           R"(, "camera": {"position": [120, 40, 200]})");
  Timeline timeline(film, reliefs_);
  const dvec3 eye = *timeline.scene_at(31).camera.position;
  EXPECT_EQ(eye.x, 120.0);
  EXPECT_NEAR(eye.y, world::Surface(film.scene()).height(120.0, 200.0) + 1.7, 1e-9);
}

TEST_F(TimelineTest, ThinCloudsHangInTheWorld) {
  // The camera flies and there is no wind: the clouds go back over it as far as it goes on.
  Timeline timeline(source(R"("duration_s": 10, "fps": 10, "wind": [],
                "camera": {"mode": "path", "path": [{"position": [0, 900, 0]}, {"position": [300, 900, 40]}]})",
                           R"(, "camera": {"height_above": "sea"})"),
                    reliefs_);
  const scene::Scene last = timeline.scene_at_time(10.0);
  EXPECT_NEAR(last.sky.cloud_drift_m.x, -300.0, 1e-9);
  EXPECT_NEAR(last.sky.cloud_drift_m.y, -40.0, 1e-9);
  EXPECT_EQ(last.sky.cumulus.drift_m, dvec2(0.0));
}

}  // namespace
}  // namespace aerostat::film

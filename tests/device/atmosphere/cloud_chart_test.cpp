// Tests the chart that says where there are no clouds, and how far rays may leap by it.
#include <algorithm>
#include <cmath>
#include <random>

#include "clouds.hpp"

namespace aerostat::test {
namespace {

bool is_cloudy(const pack::CloudChart& chart, int x, int z) {
  const auto cell = static_cast<std::size_t>(z * AERO_CHART_SIDE + x);
  return ((chart.words[cell / 4].cells >> (8 * (cell % 4))) & 255u) == 0u;
}

std::size_t cloudy_cells(const pack::CloudChart& chart) {
  std::size_t count = 0;
  for (int z = 0; z < AERO_CHART_SIDE; ++z) {
    for (int x = 0; x < AERO_CHART_SIDE; ++x) count += is_cloudy(chart, x, z) ? 1 : 0;
  }
  return count;
}

TEST(CloudChart, TellsMostClearAirFromClouds) {
  constexpr double kCells = double{AERO_CHART_SIDE} * AERO_CHART_SIDE;
  const double few = static_cast<double>(cloudy_cells(*broken_clouds(0.05).cloud_chart));
  EXPECT_GT(few / kCells, 0.06);
  EXPECT_LT(few / kCells, 0.25);
  for (const double cover : {0.7, 0.0}) {
    const pack::PackedScene scene = broken_clouds(cover);
    EXPECT_EQ(scene.cloud_chart, nullptr) << "hardly any air is clear, or all of it: " << cover;
    EXPECT_EQ(scene.numbers.sky.cumulus.chart.side, 0u);
  }
}

TEST(CloudChart, LiesTheSameWhateverTheEye) {
  scene::Scene scene = scene::defaults(scene::BiomeKind::tropical, scene::View::outside);
  const auto charted = [&scene] { return *pack::pack_scene(resolved(scene)).cloud_chart; };
  const pack::CloudChart here = charted();
  scene.camera.position->x += 3.0;
  EXPECT_EQ(charted().place.x0, here.place.x0);
  scene.camera.position->x += 40.0 * static_cast<double>(here.place.cell);
  const pack::CloudChart there = charted();
  const auto moved =
      static_cast<int>(std::lround((there.place.x0 - here.place.x0) / here.place.cell));
  ASSERT_TRUE(moved == 32 || moved == 64) << moved;
  for (int z = 0; z < AERO_CHART_SIDE; ++z) {
    for (int x = 0; x < AERO_CHART_SIDE - moved; ++x) {
      ASSERT_EQ(is_cloudy(there, x, z), is_cloudy(here, x + moved, z)) << x << ' ' << z;
    }
  }
}

class CloudLeaps : public LaneTest {};

// A ray leaps over cells that the chart calls clear, and ends before it enters another.
TEST_P(CloudLeaps, EndBeforeAnyCellThatMayBeCloudy) {
  constexpr std::size_t kRays = 4096;
  const Probe probe{"cloud_chart.cl", GetParam()};
  const pack::PackedScene scene = broken_clouds(0.05);
  const pack::CloudChart& chart = *scene.cloud_chart;
  const auto cell = chart.place.cell;
  std::mt19937 random(61);
  std::uniform_real_distribution<float> place(1.0f, AERO_CHART_SIDE - 1.0f), part(-1.0f, 1.0f);
  std::vector<vec3> points, directions;
  for (std::size_t i = 0; i < kRays; ++i) {
    const float x = chart.place.x0 + cell * place(random), u = part(random), v = part(random);
    points.emplace_back(x, 0.0f, chart.place.z0 + cell * place(random));
    directions.push_back(glm::normalize(vec3(u, part(random), v)));
  }
  const auto ways = output<float>(kRays);
  const UploadedScene on_device(scene);
  probe.run("probe_clear_way", kRays, on_device.numbers, on_device.sky_table, on_device.cloud_chart,
            input(planes(points)), input(planes(directions)), ways);
  const auto found = ways.read();
  std::size_t leaps = 0;
  for (std::size_t i = 0; i < kRays; ++i) {
    leaps += found[i] > cell ? 1 : 0;
    // Coordinates of 25 km are rounded to some millimetres.
    const float end = found[i] - 0.05f;
    for (int k = 0; end > 0.0f && k <= 64; ++k) {
      const float t = end * static_cast<float>(k) / 64.0f;
      const float x = points[i].x + t * directions[i].x, z = points[i].z + t * directions[i].z;
      const int column = static_cast<int>(std::floor((x - chart.place.x0) / cell));
      const int row = static_cast<int>(std::floor((z - chart.place.z0) / cell));
      if (std::min(column, row) < 0 || std::max(column, row) >= AERO_CHART_SIDE) continue;
      ASSERT_FALSE(is_cloudy(chart, column, row)) << "ray " << i << " at " << t << " m";
    }
  }
  EXPECT_GT(leaps, kRays / 2);
}

AEROSTAT_AT_EVERY_WIDTH(CloudLeaps);

}  // namespace
}  // namespace aerostat::test

// Tests that the ground on which the host places plants is the ground that the device shades.
#include <algorithm>
#include <random>

#include "scatter/surface.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

/// Returns a grid of uneven cells with random heights and normals.
mesh::GridMesh random_ground(std::mt19937& random) {
  std::uniform_real_distribution<float> width(0.5f, 4.0f), height(-2.0f, 2.0f), tilt(-1.0f, 1.0f);
  std::vector<float> lines[2] = {{-25.0f}, {-20.0f}};
  for (auto& along : lines) {
    for (int i = 0; i < 20; ++i) along.push_back(along.back() + width(random));
  }
  mesh::GridMesh ground(lines[0], lines[1]);
  for (std::uint32_t j = 0; j <= ground.rows(); ++j) {
    for (std::uint32_t i = 0; i <= ground.columns(); ++i) {
      const float x = tilt(random), z = tilt(random);
      ground.set(i, j, height(random), glm::normalize(vec3(x, 1.0f, z)));
    }
  }
  return ground;
}

class GroundSurface : public LaneTest {
 protected:
  /// Returns the points of a grid at hits as the device interpolates them.
  std::vector<scatter::SurfacePoint> shaded(const mesh::GridMesh& ground,
                                            const std::vector<Hit>& hits) const {
    const std::size_t count = whole_packets(hits.size());
    std::vector<float> tuv(3 * count);
    std::vector<std::uint32_t> slots(2 * count, kNoTriangle);
    for (std::size_t i = 0; i < count; ++i) {
      const Hit& hit = hits[std::min(i, hits.size() - 1)];
      tuv[i] = hit.t;
      tuv[count + i] = hit.u;
      tuv[2 * count + i] = hit.v;
      slots[i] = hit.slot;
    }
    const std::vector<float> words(ground.words().begin(), ground.words().end());
    const auto attributes = output<float>(9 * count), planes = output<float>(3 * count);
    const auto owners = output<std::uint32_t>(2 * count);
    const Probe probe{"surface.cl", GetParam()};
    probe.run("probe_interpolation", count, input(std::vector<AeroInstance>()), input(words),
              input(std::vector<AeroFace>()), input(std::vector<AeroVertex>()), input(tuv),
              input(slots), attributes, planes, owners);
    const auto values = attributes.read();
    std::vector<scatter::SurfacePoint> points(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const auto vector = [&, i](std::size_t plane) {
        return vec3(values[plane * count + i], values[(plane + 1) * count + i],
                    values[(plane + 2) * count + i]);
      };
      points[i] = {vector(0), glm::normalize(vector(3))};
    }
    return points;
  }
};

TEST_P(GroundSurface, OfPlantsHasTheHeightsAndNormalsThatAreShaded) {
  std::mt19937 random(61);
  const mesh::GridMesh ground = random_ground(random);
  const scatter::Surface surface(ground);
  std::uniform_real_distribution<float> along_x(ground.x(0), ground.x(ground.columns()));
  std::uniform_real_distribution<float> along_z(ground.z(0), ground.z(ground.rows()));
  std::vector<Ray> rays;
  for (int i = 0; i < 1024; ++i) {
    const float x = along_x(random);
    rays.push_back({{x, 10.0f, along_z(random)}, {0.0f, -1.0f, 0.0f}});
  }
  const std::vector<Hit> hits = TracedMesh(ground).trace(rays, GetParam());
  const auto points = shaded(ground, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(hits[i].met()) << i;
    const scatter::SurfacePoint point = surface.at(rays[i].origin.x, rays[i].origin.z);
    // Places of up to 60 are rounded to 4e-6, and slopes are up to 8.
    EXPECT_LT(glm::distance(point.position, points[i].position), 1e-4f) << i;
    EXPECT_LT(glm::distance(point.normal, points[i].normal), 1e-4f) << i;
  }
}

AEROSTAT_AT_EVERY_WIDTH(GroundSurface);

}  // namespace
}  // namespace aerostat::test

// Tests the light that droplets scatter against light that is followed by brute force.
#include <cmath>
#include <numbers>

#include "droplet_light.hpp"
#include "probe.hpp"

namespace aerostat::test {
namespace {

constexpr double kPi64 = std::numbers::pi;
constexpr double kDiameter = 16.0;  // in micrometres, of the droplets of the kernels

class DropletLight : public LaneTest {
 protected:
  const Probe probe{"droplets.cl", GetParam()};
};

// All light that a lobe deflects goes somewhere.
TEST_P(DropletLight, LobesGiveAwayAllOfTheLight) {
  constexpr int kCosines = 4096;
  std::vector<float> cosines;
  for (int i = 0; i < kCosines; ++i) {
    cosines.push_back(2.0f * (static_cast<float>(i) + 0.5f) / kCosines - 1.0f);
  }
  for (const float asymmetry : {-0.2f, 0.0f, 0.421f, 0.8f}) {
    const auto phase = output<float>(kCosines);
    probe.run("probe_droplet_phase", kCosines, input(cosines), asymmetry, phase);
    double sum = 0.0;
    for (const float share : phase.read()) {
      sum += static_cast<double>(share) * 4.0 * kPi64 / kCosines;
    }
    EXPECT_NEAR(sum, 1.0, 1e-3) << asymmetry;
  }
}

TEST_P(DropletLight, LobesAreThoseOfDropletsOf16Micrometres) {
  const Droplets droplets(kDiameter);
  std::vector<float> cosines;
  for (int i = 0; i < 512; ++i) {
    cosines.push_back(std::cos(static_cast<float>(kPi64) * static_cast<float>(i) / 511.0f));
  }
  const auto share = output<float>(cosines.size());
  probe.run("probe_droplet_lobes", cosines.size(), input(cosines), share);
  const auto found = share.read();
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    const double expected = droplets.phase(double{cosines[i]});
    EXPECT_NEAR(found[i], expected, 5e-3 * expected) << cosines[i];
  }
}

/// Points of a homogeneous cloud along rays from an eye, as the kernel takes them, and what each of
/// them counts for the mean radiance of its ring.
struct SeenPoints {
  std::vector<float> to_sun, behind, seen, cosines;
  std::vector<double> weights;
  std::vector<int> rings;

  /// Adds the points that a ray sees from where it enters the cloud. `to_eye` is against the ray.
  void add_ray(const HomogeneousCloud& cloud, const dvec3& entry, const dvec3& to_eye,
               const dvec3& sun, int ring, double weight) {
    constexpr int kPoints = 12;
    const double length = cloud.way_out(entry, -to_eye), hidden = -std::expm1(-length);
    for (int i = 0; i < kPoints; ++i) {
      const double way = -std::log1p(-hidden * (i + 0.5) / kPoints);
      const dvec3 p = entry - way * to_eye;
      to_sun.push_back(static_cast<float>(cloud.way_out(p, sun)));
      behind.push_back(static_cast<float>(cloud.way_out(p, -sun)));
      seen.push_back(static_cast<float>(length));
      cosines.push_back(static_cast<float>(-glm::dot(to_eye, sun)));
      weights.push_back(weight * hidden / kPoints);
      rings.push_back(ring);
    }
  }
};

/// Returns the points by which the mean radiance of a cloud is integrated, ring by ring.
SeenPoints seen_points(const HomogeneousCloud& cloud, const dvec3& sun) {
  constexpr int kParts = 8;
  SeenPoints points;
  for (int ring = 0; ring < kRings; ++ring) {
    const double cosine = 2.0 * (ring + 0.5) / kRings - 1.0,
                 sine = std::sqrt(1.0 - cosine * cosine);
    for (int i = 0; i < kParts; ++i) {
      const double turn = kPi64 * (i + 0.5) / kParts;
      if (!cloud.sphere) {
        const dvec3 to_eye(sine * std::cos(turn), cosine, sine * std::sin(turn));
        const dvec3 entry(0.0, cosine > 0.0 ? 0.0 : -cloud.size, 0.0);
        points.add_ray(cloud, entry, to_eye, sun, ring, 1.0 / kParts);
        continue;
      }
      const dvec3 to_eye(sine, -cosine, 0.0);
      const auto across = axes_across(to_eye);
      for (int j = 0; j < kParts; ++j) {
        const double r = std::sqrt((j + 0.5) / kParts);
        const dvec3 entry = r * std::cos(2.0 * turn) * across[0] +
                            r * std::sin(2.0 * turn) * across[1] + std::sqrt(1.0 - r * r) * to_eye;
        points.add_ray(cloud, cloud.size * entry, to_eye, sun, ring, 1.0 / (kParts * kParts));
      }
    }
  }
  return points;
}

/// Returns whether a ring of directions contains the narrow peak of the phase function around the
/// direction of sunlight. The few points of a ring are too coarse to integrate the peak.
bool holds_peak(const HomogeneousCloud& cloud, const dvec3& sun, std::size_t ring) {
  const double cosine = 2.0 * (static_cast<double>(ring) + 0.5) / kRings - 1.0;
  return std::abs(cosine - (cloud.sphere ? 1.0 : -sun.y)) < 1.5 / kRings;
}

// The closed form is a fit, and the bounds say how good it is. Spheres and slabs differ at the same
// depths, because light enters and leaves a sphere by its sides.
TEST_P(DropletLight, IsNearLightFollowedThroughSpheresAndSlabs) {
  struct Case {
    HomogeneousCloud cloud;
    double sun_deg;  // angle with the upright
    int photons;
    double least, most;  // bounds of the ratio of all light
  };
  const Case cases[] = {
      {{true, 0.25}, 0.0, 100000, 0.85, 1.15}, {{true, 2.0}, 0.0, 40000, 0.85, 1.15},
      {{true, 5.0}, 0.0, 30000, 0.85, 1.15},   {{true, 12.0}, 0.0, 12000, 0.85, 1.15},
      {{false, 2.0}, 50.0, 40000, 0.7, 1.4},   {{false, 8.0}, 10.0, 20000, 0.7, 1.4},
      {{false, 8.0}, 50.0, 20000, 0.7, 1.4},   {{false, 8.0}, 75.0, 20000, 0.7, 1.4},
      {{false, 25.0}, 50.0, 8000, 0.7, 1.4}};
  const Droplets droplets(kDiameter);
  double squares = 0.0;
  int count = 0;
  for (const Case& c : cases) {
    SCOPED_TRACE((c.cloud.sphere ? "sphere " : "slab ") + std::to_string(c.cloud.size) +
                 ", sun at " + std::to_string(c.sun_deg));
    const double sun_rad = c.sun_deg * kPi64 / 180.0;
    const dvec3 sun(std::sin(sun_rad), std::cos(sun_rad), 0.0);
    const RingLight followed = scattered_light(c.cloud, droplets, sun, c.photons, 5);
    const SeenPoints points = seen_points(c.cloud, sun);
    const std::size_t size = whole_packets(points.seen.size());
    // This is what air::Light gives to separate heaps and to closed decks.
    const float level = c.cloud.sphere ? 1.0f : static_cast<float>(1.8 * sun.y);
    const auto light = output<float>(size);
    probe.run("probe_droplet_light", size, input(padded(points.to_sun)),
              input(padded(points.behind)), input(padded(points.seen)),
              input(padded(points.cosines)), level, light);
    const auto found = light.read();
    RingLight seen{};
    for (std::size_t i = 0; i < points.seen.size(); ++i) {
      seen[static_cast<std::size_t>(points.rings[i])] += points.weights[i] * double{found[i]};
    }
    double all_seen = 0.0, all_followed = 0.0;
    for (std::size_t ring = 0; ring < kRings; ++ring) {
      if (holds_peak(c.cloud, sun, ring)) continue;
      const double error = std::log(seen[ring] / followed[ring]);
      EXPECT_LT(std::abs(error), std::log(3.5)) << "ring " << ring;
      squares += error * error;
      ++count;
      all_seen += seen[ring];
      all_followed += followed[ring];
    }
    EXPECT_GT(all_seen / all_followed, c.least);
    EXPECT_LT(all_seen / all_followed, c.most);
  }
  EXPECT_LT(std::sqrt(squares / count), std::log(1.6));
}

AEROSTAT_AT_EVERY_WIDTH(DropletLight);

}  // namespace
}  // namespace aerostat::test

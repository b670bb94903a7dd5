// Tests the path integrator against an independent path tracer on the exported triangles: plain
// surfaces under a sky of one radiance and a sun. It shares no code with the kernels: it traces by
// the oracle in double precision, takes random numbers from the standard library, and looks for the
// sun by points of its disc alone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <random>

#include "oracle.hpp"
#include "pictures.hpp"

namespace aerostat::test {
namespace {

constexpr dvec3 kSky{0.4, 0.5, 0.8};
constexpr int kSamples = 256;

/// Returns a scene in plain light.
scene::Scene plain_scene(const char* name, int bounces) {
  scene::Scene scene = small_scene(name, {32, 24, kSamples, 48});
  scene.surfaces = scene::Surfaces::plain;
  scene.light = scene::Integrator::path;
  scene.bounces = bounces;
  scene.shading = scene::Shading::flat;
  scene.image.filter = scene::Filter::box;
  scene.image.adaptive_threshold = 0.0;
  scene.sky.radiance = vec3(kSky);
  scene.sun.irradiance = 3.0;
  scene.sun.soft_shadows = true;
  scene.sun.diameter_deg = 5.0;
  return scene;
}

/// Follows paths of light through exported triangles.
class PathTracer {
 public:
  PathTracer(const scene::Scene& scene, const ExportedWorld& world)
      : world_(world), oracle_(world), camera_(scene), bounces_(scene.bounces) {
    sun_ = glm::normalize(scene.sun.direction);
    sun_irradiance_ = dvec3(scene.sun.color) * scene.sun.irradiance;
    sun_cosine_ = std::cos(glm::radians(0.5 * scene.sun.diameter_deg));
  }

  /// Returns the radiance of one sample of pixel (x, y).
  dvec3 sample(int x, int y) {
    dvec3 origin = camera_.origin(x, y);
    dvec3 direction = camera_.direction_through({x + number(), y + number()});
    dvec3 radiance(0.0), carried(1.0);
    for (int bounce = 0;; ++bounce) {
      const Oracle::Answer hit = oracle_.nearest(origin, direction);
      if (std::isinf(hit.distance)) return radiance + carried * kSky;
      if (bounce > bounces_) return radiance;
      const dvec3 point = origin + hit.distance * direction;
      const dvec3 normal = normal_of(hit.triangle, direction);
      carried *= albedo_at(hit.triangle, point);
      origin = point + normal * (1e-4 + 1e-6 * glm::length(point));
      radiance += carried * sunlight(origin, normal);
      direction = scattered(normal);
    }
  }

 private:
  double number() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  dvec3 corner(std::size_t triangle, int i) const {
    return dvec3(world_.positions[world_.triangles[triangle][i]]);
  }

  dvec3 normal_of(std::size_t triangle, const dvec3& direction) const {
    const dvec3 a = corner(triangle, 0);
    const dvec3 normal =
        glm::normalize(glm::cross(corner(triangle, 1) - a, corner(triangle, 2) - a));
    return glm::dot(normal, direction) > 0.0 ? -normal : normal;
  }

  /// Returns the colour of the vertices, weighted by the areas opposite to them.
  dvec3 albedo_at(std::size_t triangle, const dvec3& point) const {
    dvec3 sum(0.0);
    double total = 0.0;
    for (int i = 0; i < 3; ++i) {
      const dvec3 b = corner(triangle, (i + 1) % 3) - point,
                  c = corner(triangle, (i + 2) % 3) - point;
      const double area = glm::length(glm::cross(b, c));
      sum += area * dvec3(world_.colors[world_.triangles[triangle][i]]);
      total += area;
    }
    return sum / total;
  }

  /// Returns a unit direction around an axis, with the given cosine.
  dvec3 around(const dvec3& axis, double cosine) {
    const dvec3 other = std::abs(axis.x) < 0.5 ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 1.0, 0.0);
    const dvec3 a = glm::normalize(glm::cross(axis, other)), b = glm::cross(axis, a);
    const double turn = 2.0 * std::numbers::pi * number();
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return cosine * axis + sine * (std::cos(turn) * a + std::sin(turn) * b);
  }

  dvec3 scattered(const dvec3& normal) { return around(normal, std::sqrt(1.0 - number())); }

  /// Returns the sunlight that a white surface reflects. The disc has the same radiance everywhere.
  dvec3 sunlight(const dvec3& origin, const dvec3& normal) {
    const dvec3 to_sun = around(sun_, 1.0 - number() * (1.0 - sun_cosine_));
    const double cosine = glm::dot(normal, to_sun);
    if (cosine <= 0.0 || !std::isinf(oracle_.nearest(origin, to_sun).distance)) return dvec3(0.0);
    // The radiance of the disc is E / (pi sin^2), and its solid angle is 2 pi (1 - cos).
    const double share = 2.0 / (1.0 + sun_cosine_);
    return sun_irradiance_ * (share * cosine / std::numbers::pi);
  }

  const ExportedWorld& world_;
  Oracle oracle_;
  DumpedCamera camera_;
  int bounces_;
  dvec3 sun_, sun_irradiance_;
  double sun_cosine_ = 1.0;
  std::mt19937_64 random_{20261130};
};

/// The sum over pixels of an object.
struct Region {
  int pixels = 0;
  dvec3 found{0.0}, expected{0.0};
  /// The sum of the variances of the expected means of the pixels.
  double variance = 0.0;
};

std::map<std::uint32_t, Region> compare(const scene::Scene& scene) {
  const image::Film film = shared_session().render(resolved(scene));
  const ExportedWorld world = exported_world(scene);
  PathTracer tracer(scene, world);
  std::map<std::uint32_t, Region> regions;
  for (int y = Oracle::stride() / 2; y < film.height; y += Oracle::stride()) {
    for (int x = Oracle::stride() / 2; x < film.width; x += Oracle::stride()) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                     static_cast<std::size_t>(x);
      Region& region = regions[film.object_id[i]];
      dvec3 sum(0.0);
      double squares = 0.0;
      for (int sample = 0; sample < kSamples; ++sample) {
        const dvec3 radiance = tracer.sample(x, y);
        sum += radiance;
        squares += radiance.y * radiance.y;
      }
      const dvec3 mean = sum / double{kSamples};
      ++region.pixels;
      region.found += dvec3(film.radiance[i]);
      region.expected += mean;
      region.variance += (squares / kSamples - mean.y * mean.y) / kSamples;
    }
  }
  return regions;
}

/// Expects that the regions agree within four standard deviations of the noise, and half a percent.
void expect_agreement(const char* name, int bounces) {
  for (const auto& [object, region] : compare(plain_scene(name, bounces))) {
    const double noise = 4.0 * std::sqrt(2.0 * region.variance) / region.expected.y;
    const dvec3 ratio = region.found / region.expected;
    std::printf("%s, %d bounces, %s: %d pixels, ratio %.4f %.4f %.4f, noise %.4f\n", name, bounces,
                scene::object_name(static_cast<scene::ObjectId>(object)).c_str(), region.pixels,
                ratio.x, ratio.y, ratio.z, noise);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 0.005 + noise) << object;
  }
}

TEST(Outside, APathTracerOnTheExportedLandAndBalloonAgrees) {
  expect_agreement("snow", 0);
  expect_agreement("snow", 3);
}

TEST(Outside, APathTracerOnTheExportedBasketAndSeaAgrees) {
  expect_agreement("tropical-basket", 3);
}

}  // namespace
}  // namespace aerostat::test

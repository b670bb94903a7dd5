#include "land/picture_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <tbb/parallel_for.h>

#include "land/drape.hpp"
#include "land/sun_shade.hpp"

namespace aerostat::land {
namespace {

// All were chosen by eye.
constexpr int kFitNodes = 256;    // along a side of the grid on which a sun is looked for
constexpr int kLiftNodes = 1024;  // along a side of the grid of a level that is lifted, at most
constexpr double kLeastCorrelation = 0.3;  // below it, no sun is taken to be found
constexpr double kUsualSky = 0.3;          // what shade gets while a sun is looked for
constexpr double kLeastSky = 0.03, kMostSky = 0.97;
constexpr std::size_t kFewestPoints = 400;
constexpr float kOpaque = 0.99f, kDarkest = 0.002f;  // of points that count
const vec3 kLuminance(0.2126f, 0.7152f, 0.0722f);    // of linear sRGB (ITU-R BT.709)

/// The correlation of pairs (x, y), and the slope of the straight line that fits them best.
struct Regression {
  double correlation = 0.0, slope = 0.0;
};

template <class X, class Y>
Regression regression(std::size_t count, const X& x_of, const Y& y_of) {
  double x_sum = 0.0, y_sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    x_sum += x_of(k);
    y_sum += y_of(k);
  }
  const double x_mean = x_sum / static_cast<double>(count);
  const double y_mean = y_sum / static_cast<double>(count);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = x_of(k) - x_mean, y = y_of(k) - y_mean;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  if (!(xx > 1e-12 && yy > 1e-12)) return {};
  return {xy / std::sqrt(xx * yy), xy / xx};
}

/// Returns light with that of the sky: the sun's light counts for what the sky leaves.
double with_sky(double sky, float sun) {
  return sky + (1.0 - sky) * static_cast<double>(sun);
}

/// What colours are multiplied by, for each amount of sunlight.
class LiftFactors {
 public:
  LiftFactors(const PictureLight& light, double strength) : factors_(kSteps + 1) {
    for (int k = 0; k <= kSteps; ++k) {
      const float sun = kMostSun * static_cast<float>(k) / kSteps;
      for (int c = 0; c < 3; ++c) {
        factors_[static_cast<std::size_t>(k)][c] =
            static_cast<float>(std::pow(with_sky(light.sky[c], sun), -strength));
      }
    }
  }

  const vec3& at(float sun) const {
    const float step = std::clamp(sun / kMostSun, 0.0f, 1.0f) * kSteps;
    return factors_[static_cast<std::size_t>(std::lround(step))];
  }

 private:
  static constexpr int kSteps = 4096;
  static constexpr float kMostSun = 8.0f;  // of a low sun on a slope that faces it

  std::vector<vec3> factors_;
};

/// The points of a picture at which light is looked for.
class LightFinder {
 public:
  LightFinder(const NestedLevels& picture, const LocalLand& land, double cell_m)
      : relief_(land, picture.middle, width_of(picture), kFitNodes, cell_m) {
    const int level = level_of(picture);
    for (int j = 0; j < kFitNodes; ++j)
      for (int i = 0; i < kFitNodes; ++i) {
        const dvec2 away = (dvec2(i, j) - 0.5 * (kFitNodes - 1)) * relief_.step_m;
        const vec4 colour = level_at(picture, level, away, colour_of_texel);
        if (colour.w < kOpaque || glm::dot(vec3(colour), kLuminance) < kDarkest) continue;
        nodes_.push_back(static_cast<std::size_t>(j) * kFitNodes + static_cast<std::size_t>(i));
        colours_.emplace_back(colour);
      }
  }

  bool has_points() const { return nodes_.size() >= kFewestPoints; }

  std::optional<PictureLight> run() const {
    if (!has_points()) return std::nullopt;
    PictureLight best;
    best.correlation = -1.0;
    const auto look = [&](double azimuth_deg, double elevation_deg) {
      if (elevation_deg < 5.0 || elevation_deg > 85.0) return;
      const double correlation = correlation_with(SunShade(relief_, azimuth_deg, elevation_deg));
      if (correlation <= best.correlation) return;
      best.correlation = correlation;
      best.azimuth_deg = std::remainder(azimuth_deg, 360.0);
      best.elevation_deg = elevation_deg;
    };
    for (int azimuth = 0; azimuth < 360; azimuth += 20)
      for (int elevation = 15; elevation <= 75; elevation += 15) look(azimuth, elevation);
    for (const double step : {10.0, 5.0, 2.5, 1.25}) {
      const PictureLight from = best;
      for (int a = -1; a <= 1; ++a)
        for (int e = -1; e <= 1; ++e) {
          if (a != 0 || e != 0) look(from.azimuth_deg + a * step, from.elevation_deg + e * step);
        }
    }
    if (best.correlation < kLeastCorrelation) return std::nullopt;
    if (best.azimuth_deg < 0.0) best.azimuth_deg += 360.0;
    const SunShade sun(relief_, best.azimuth_deg, best.elevation_deg);
    for (int c = 0; c < 3; ++c) best.sky[c] = static_cast<float>(sky_of(sun, c));
    return best;
  }

  /// Returns the correlation with the light of a sun, with a usual sky.
  double correlation_with(const SunShade& sun) const {
    return regression(
               nodes_.size(),
               [&](std::size_t k) { return std::log(with_sky(kUsualSky, sun.nodes()[nodes_[k]])); },
               [&](std::size_t k) { return std::log(glm::dot(colours_[k], kLuminance)); })
        .correlation;
  }

  const ReliefGrid& relief() const { return relief_; }

 private:
  /// Returns the coarsest level that is opaque over a quarter or more, or else the most opaque one.
  static int level_of(const NestedLevels& picture) {
    int best = 0;
    double most = -1.0;
    for (int level = picture.levels - 1; level >= 0; --level) {
      const auto side = static_cast<std::size_t>(picture.side);
      const std::uint32_t* texels =
          picture.texels.data() + static_cast<std::size_t>(level) * side * side;
      const auto opaque = std::count_if(texels, texels + side * side, [](std::uint32_t texel) {
        return colour_of_texel(texel).w > kOpaque;
      });
      const double share = static_cast<double>(opaque) / static_cast<double>(side * side);
      if (share >= 0.25) return level;
      if (share > most) best = level;
      most = std::max(most, share);
    }
    return best;
  }

  static double width_of(const NestedLevels& picture) {
    return picture.side * std::ldexp(picture.texel_m, level_of(picture));
  }

  /// Returns the sky's share with which light and colour go together one by one, so that dividing
  /// by the light leaves no more of it.
  double sky_of(const SunShade& sun, int channel) const {
    const auto slope_with = [&](double sky) {
      return regression(
                 nodes_.size(),
                 [&](std::size_t k) { return std::log(with_sky(sky, sun.nodes()[nodes_[k]])); },
                 [&](std::size_t k) { return std::log(std::max(colours_[k][channel], kDarkest)); })
          .slope;
    };
    double low = kLeastSky, high = kMostSky;
    for (int k = 0; k < 20; ++k) {
      const double middle = 0.5 * (low + high);
      // The more comes from the sky, the less light differs, and the steeper is the line.
      (slope_with(middle) < 1.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  ReliefGrid relief_;
  std::vector<std::size_t> nodes_;
  std::vector<vec3> colours_;
};

}  // namespace

std::optional<PictureLight> find_light(const NestedLevels& picture, const LocalLand& land,
                                       double cell_m) {
  return LightFinder(picture, land, cell_m).run();
}

void lift_light(NestedLevels& picture, const LocalLand& land, double cell_m,
                const PictureLight& light, double strength) {
  const auto side = static_cast<std::size_t>(picture.side);
  const LiftFactors factors(light, strength);
  for (int level = 0; level < picture.levels; ++level) {
    const double texel_m = std::ldexp(picture.texel_m, level);
    const int nodes = std::min(picture.side, kLiftNodes);
    const ReliefGrid relief(land, picture.middle, picture.side * texel_m, nodes, cell_m);
    const SunShade sun(relief, light.azimuth_deg, light.elevation_deg);
    std::uint32_t* texels = picture.texels.data() + static_cast<std::size_t>(level) * side * side;
    tbb::parallel_for(std::size_t{0}, side, [&](std::size_t j) {
      for (std::size_t i = 0; i < side; ++i) {
        std::uint32_t& texel = texels[j * side + i];
        const vec4 colour = colour_of_texel(texel);
        if (!(colour.w > 0.0f)) continue;
        const dvec2 away(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
        const float on = sun.at(picture.middle + (away - 0.5 * picture.side) * texel_m);
        // A colour counts with its opacity.
        const vec3 lifted = glm::min(vec3(colour) * factors.at(on), vec3(colour.w));
        texel = packed_texel(vec4(lifted, colour.w));
      }
    });
  }
}

double light_left(const NestedLevels& picture, const LocalLand& land, double cell_m,
                  const PictureLight& light) {
  const LightFinder finder(picture, land, cell_m);
  if (!finder.has_points()) return 0.0;
  return finder.correlation_with(SunShade(finder.relief(), light.azimuth_deg, light.elevation_deg));
}

}  // namespace aerostat::land

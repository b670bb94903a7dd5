// Tests whole, developed pictures of thick haze and of the hours after sunset.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/tone.hpp"
#include "image/write.hpp"
#include "pictures.hpp"
#include "render/development.hpp"

namespace aerostat::test {
namespace {

scene::Scene unlit_snow() {
  scene::Scene scene = small_scene("snow", {96, 54, 1, 128});
  scene.balloon.burner = 0.0;
  return scene;
}

/// A picture with the automatic exposure and white balance of its quality.
struct Shown {
  image::Film film;
  image::Pixels pixels;

  explicit Shown(const scene::Scene& scene) : film(shared_session().render(resolved(scene))) {
    pixels = image::develop(film, render::development_of(scene.image, film));
  }

  /// Returns the mean of all pixels or of those of the sky, encoded from 0 to 255.
  dvec3 mean(bool sky_alone) const {
    dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
      if (sky_alone && film.object_id[i] != 0) continue;
      sum += dvec3(pixels.rgb[3 * i], pixels.rgb[3 * i + 1], pixels.rgb[3 * i + 2]);
      count += 1.0;
    }
    return sum / count;
  }
};

scene::Scene snow_under(double sun_deg) {
  scene::Scene scene = unlit_snow();
  const double e = sun_deg * std::numbers::pi / 180.0;
  scene.sun.direction = {0.3 * std::cos(e), std::sin(e), -std::sqrt(0.91) * std::cos(e)};
  return scene;
}

TEST(Dusk, IsShownDarkAndBlueAndNightDarker) {
  const Shown day(snow_under(5.0));
  double before = image::luminance(day.mean(false));
  EXPECT_GT(before, 80.0);
  for (const double sun_deg : {-6.0, -8.0, -10.0, -14.0, -20.0}) {
    const Shown dusk(snow_under(sun_deg));
    const dvec3 sky = dusk.mean(true), all = dusk.mean(false);
    const double now = image::luminance(all);
    EXPECT_LT(now, before + 0.5) << sun_deg;
    before = now;
    EXPECT_LE(sky.y, std::max(sky.x, sky.z) + 1.0) << sun_deg << ": no green";
    if (sun_deg > -11.0) {
      EXPECT_GT(sky.z, 1.2 * sky.x) << sun_deg << ": blue";
    }
    if (sun_deg <= -10.0) {
      EXPECT_LT(now, 0.35 * image::luminance(day.mean(false))) << sun_deg;
    }
    EXPECT_GT(now, 1.0) << sun_deg << ": not black";
  }
}

TEST(ThickHaze, IsShownGreyAndHidesWhatIsFar) {
  for (const double visibility_m : {50.0, 200.0, 500.0}) {
    scene::Scene scene = unlit_snow();
    scene.image.filter = scene::Filter::box;
    scene.haze.visibility_m = visibility_m;
    scene::set_haze_droplets(scene.haze, visibility_m);
    const Shown haze(scene);
    const dvec3 mean = haze.mean(true);
    EXPECT_GT(image::luminance(mean), 90.0) << visibility_m;
    EXPECT_LT(std::max({mean.x, mean.y, mean.z}), 1.15 * std::min({mean.x, mean.y, mean.z}))
        << visibility_m;
    // Clouds and far mountains would be edges, so neighbours there are left out.
    const auto width = static_cast<std::size_t>(haze.film.width);
    for (std::size_t i = 1; i < haze.film.radiance.size(); ++i) {
      if (i % width == 0) continue;
      const auto is_far = [&](std::size_t k) { return haze.film.distance_m[k] > 3000.0f; };
      if (!is_far(i) || !is_far(i - 1)) continue;
      const int step = std::abs(haze.pixels.rgb[3 * i + 1] - haze.pixels.rgb[3 * i - 2]);
      ASSERT_LE(step, 3) << visibility_m << " at " << i % width << ", " << i / width;
    }
  }
}

}  // namespace
}  // namespace aerostat::test

#pragma once

#include "pictures.hpp"

/// Provides a world whose pictures are known in closed form: a level plane of one colour at y = 0,
/// seen from straight above. Light, air, balloon and gloss are off until a test turns them on.
namespace aerostat::test {

inline constexpr dvec3 kAlbedo{0.5, 0.25, 0.125};
inline constexpr double kEyeHeight = 25.0;

/// Returns the plane seen from (0, kEyeHeight, 0) with -z up in the picture, 64 x 48 pixels with
/// one sample each.
scene::Scene flat_land();

/// Returns the flat land under an air of molecules only and a sun at the zenith.
scene::Scene flat_land_under_a_sky();

/// Returns the irradiance of the plane by the sky, divided by pi. `sunlight` returns that of a
/// plane that faces the sun.
dvec3 sky_light(const scene::Scene& scene);
dvec3 sunlight(const scene::Scene& scene);

/// The share of light that the few metres of air before the eye scatter towards it.
inline constexpr double kAirBefore = 4e-3;

/// Returns the point of the plane that is seen through the middle of pixel (x, y).
dvec3 point_under(const scene::Scene& scene, int x, int y);

/// Renders `scene` and calls `check(x, y, point, radiance)` for every pixel. Stops at the first
/// pixel that fails.
template <typename Check>
void for_pixels(const scene::Scene& scene, Check check) {
  const image::Film film = shared_session().render(resolved(scene));
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      SCOPED_TRACE("pixel " + std::to_string(x) + ", " + std::to_string(y));
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                     static_cast<std::size_t>(x);
      check(point_under(scene, x, y), dvec3(film.radiance[i]));
      if (testing::Test::HasFailure()) return;
    }
  }
}

/// Expects a radiance within the relative error `relative` and the rounding of single precision
/// near 0.
void expect_radiance(const dvec3& expected, const dvec3& found, double relative = 2e-5);

}  // namespace aerostat::test

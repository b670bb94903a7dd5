#pragma once

#include <optional>
#include <utility>

#include "air/sky.hpp"
#include "core/last_made.hpp"
#include "scene/resolved_scene.hpp"

namespace aerostat::air {

/// Keeps the scattering of the last air and sun, and by moonlight that of the moon as well. It does
/// not depend on the eye, and takes three times as long to compute as the sky that an eye sees.
struct ScatteringCache {
  using Last = LastMade<std::pair<Atmosphere, dvec3>, Scattering>;
  Last key, afterglow;
};

/// The light of the air over a landscape for a renderer. It assumes one sun and heights below
/// some kilometres, and uses closed forms in the height and the sky of one eye. All light is per
/// irradiance of the sun outside the air. By moonlight (scene::key_light), the moon is the sun of
/// all this. What the real sun, far below the horizon, still gives to the sky is its afterglow. It
/// lights no landscape directly, so that it only adds to `around`, to `ambient` and to the sky.
struct Light {
  explicit Light(const scene::ResolvedScene& scene);

  /// Takes the scattering from a cache, or computes it and leaves it there.
  Light(const scene::ResolvedScene& scene, ScatteringCache& cache);

  Atmosphere atmosphere;
  /// The optical depth towards the sun at height h is
  ///   depth_molecules exp(-h / molecules_height)
  ///   + depth_haze exp(-h / haze_height) + depth_ozone
  dvec3 depth_molecules{0.0}, depth_haze{0.0}, depth_ozone{0.0};
  /// The optical depth of haze that replaces depth_haze for the light that the air scatters.
  dvec3 scattered_depth_haze{0.0};
  /// The heights between which the sun's disc appears. None of the disc is seen from below the
  /// first height, and all of it from above the second.
  double sun_heights[2] = {0.0, 0.0};
  /// Parabolas that approximate Scattering::around at the heights of landscapes. The even part is
  /// even[0] + even[1] x + even[2] x^2, but at least around_least. The slant has the same form. x
  /// goes from 0 to around_top and is the height in metres. If thick_haze is true, x is instead
  /// the share 1 - exp(-h / haze_height) by which the haze is thinner than at the sea.
  std::array<dvec3, 3> around{}, around_slant{};
  dvec3 around_least{0.0};
  double around_top = kAroundTop;
  bool thick_haze = false;
  SkyTable sky;
  std::array<dvec3, 9> ambient{};  // as the clouds leave it at the height of the eye
  /// Irradiance / pi of a plane that faces up above the clouds, and of one that faces down.
  dvec3 above_clouds{0.0}, below_clouds{0.0};
  /// Shares of the sun's and of the other light that a closed deck of clouds leaves to the air
  /// below its bases, at the height deck_base. Both are 1 where clouds stand apart.
  double deck_base = 0.0, deck_sun = 1.0, deck_around = 1.0;
  /// The light that diffuses in clouds, relative to that of separate heaps. A heap takes the light
  /// of the sun by its sides, and a closed deck only as much as level ground does.
  double deck_level = 1.0;
  /// The sky of the real sun by moonlight, per irradiance of the real sun.
  std::optional<SkyTable> afterglow;
  /// The optical depth from the eye straight up, without fog.
  dvec3 depth_above{0.0};

  static constexpr double kAroundTop = 9000.0;

 private:
  Light(double eye_height, const CloudDeck& deck, const Scattering& air);
  void take_clouds(const CloudDeck& deck, const Scattering& air, double eye_height);
  void take_around(const Scattering& air, double eye_height);
  void add_afterglow(const Scattering& air, const CloudDeck& deck, double eye_height,
                     const dvec3& sun_over_moon);
};

}  // namespace aerostat::air

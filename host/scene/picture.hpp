#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/math.hpp"
#include "scene/geo_point.hpp"
#include "scene/height_reference.hpp"

/// The camera of a scene and the settings of its picture.
namespace aerostat::scene {

enum class View { outside, basket };
/// The projection that turns points of the picture into rays. A panorama shows all directions:
/// 360 degrees of azimuth across the picture and 180 degrees of height down it.
enum class Lens { pinhole, thin_lens, panorama, orthographic };
enum class Shading { flat, gouraud, phong };
/// What surfaces look like: with all of their textures, gloss and bumps, or of one colour that
/// reflects light evenly, so that pictures can be compared with those of other renderers.
enum class Surfaces { full, plain };
enum class Integrator { local, path };
inline constexpr std::size_t kIntegratorCount = 2;
enum class Filter { box, tent, gaussian };
/// The amount of work for a picture. It sets samples, the adaptive threshold, soft shadows and
/// ambient occlusion together.
enum class Quality { draft, standard, final };

struct Camera {
  View view = View::outside;
  /// The eye, and a point in the middle of the picture. Without them, world::resolve puts the eye
  /// into the basket and lets it look straight ahead, so that a resolved scene has both.
  std::optional<dvec3> position, target;
  std::optional<GeoPoint> at, look_at;                  // in place of position and target
  HeightReference height_above = HeightReference::sea;  // holds for position and target
  dvec3 up{0.0, 1.0, 0.0};
  Lens lens = Lens::pinhole;
  double fov_y_deg = 45.0;  // vertical field of view of pinhole and thin lens
  double f_number = 2.8;    // f-number of a thin lens before a sensor 24 mm high
  /// The diameter of a thin lens. Without it, the aperture follows from f_number and fov_y_deg.
  std::optional<double> aperture_m;
  /// The depth of the plane that a thin lens shows sharp. Without it, the target is sharp.
  std::optional<double> focus_m;
  double view_height_m = 60.0;  // height that an orthographic picture shows
};

struct Image {
  int width = 1280;
  int height = 720;
  int spp = 4;
  std::uint32_t seed = 1;
  double adaptive_threshold = 0.0;  // noise at which a pixel has enough samples; 0: all get spp
  Filter filter = Filter::gaussian;
  /// The exposure in stops. Without it, the exposure follows from the picture.
  std::optional<double> exposure_ev;
  /// The colour temperature that is shown as white. Without it, the white goes half of the way to
  /// the daylight's colour.
  std::optional<double> white_balance_k;
  double vignette = 0.0;  // share of the light that is lost in the corners
  double glare = 0.25;    // strength of the glare around what is far brighter than white
};

}  // namespace aerostat::scene

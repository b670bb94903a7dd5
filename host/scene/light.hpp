#pragma once

#include <cstdint>
#include <optional>

#include "core/math.hpp"
#include "scene/geo_point.hpp"
#include "scene/height_reference.hpp"

/// The light of a scene and the air that it goes through.
namespace aerostat::scene {

/// The sun. `direction` is a unit vector towards the sun. In its place, files may give
/// azimuth_deg and elevation_deg, or date, time, latitude_deg and longitude_deg.
struct Sun {
  dvec3 direction{0.0, 1.0, 0.0};
  vec3 color{1.0f};            // colour outside the air; its largest component is 1
  double irradiance = 5.0;     // irradiance outside the air, on a plane that faces the sun
  double diameter_deg = 0.53;  // angular diameter of the disc that the eye and shadows see
  bool shadows = true;
  bool soft_shadows = true;  // shadows are cast by the sun's disc, not by its centre
};

/// The moon. It lights the land when the sun is well down, and its phase follows from where both
/// stand. A sun that is given by date and place gives the moon and the stars as well.
struct Moon {
  bool enabled = false;
  double azimuth_deg = 120.0;
  double elevation_deg = 35.0;
  double distance_km = 384400.0;  // from the eye; it sets size and brightness
};

/// The stars. They turn about the pole by sidereal time.
struct Stars {
  bool enabled = true;
  double latitude_deg = 46.0;
  double sidereal_deg = 0.0;  // local sidereal time: the right ascension that is due south
  double year = 2000.0;       // of the precession
  double milky_way = 1.0;     // brightness of the Milky Way relative to the real one
};

/// Sets of defaults of sun, moon, air, clouds and film for a time of day or a weather.
enum class Mood { none, dawn, noon, golden, dusk, night, storm, mist };

struct PointLight {
  dvec3 position{0.0};
  vec3 color{1.0f};
  double intensity = 100.0;  // irradiance times the square of the distance
  bool shadows = true;
  HeightReference height_above = HeightReference::sea;
  std::optional<GeoPoint> at{};  // in place of position
};

/// Heaped fair-weather clouds over flat bases. Their shadows fall on the land.
struct Cumulus {
  double cover = 0.0;          // share of the sky straight above, 0 to 1
  double base_m = 1400.0;      // height of the bases above the sea
  double thickness_m = 500.0;  // height from the bases to high tops
  double size_m = 700.0;       // width of a cloud
  std::uint32_t seed = 1;
  dvec2 drift_m{0.0, 0.0};  // how far the wind has carried the clouds, along x and z
  double rise_m = 0.0;      // how far their bulges have risen through them
};

/// The clouds and the light of the sky, apart from sun and air.
struct Sky {
  /// The radiance of the sky in all directions, also below the horizon. If it is given, there are
  /// neither air, haze and fog nor clouds.
  std::optional<vec3> radiance;
  double cloud_cover = 0.4;        // share of the sky that thin high cloud covers, 0 to 1
  double cloud_height_m = 7000.0;  // height of the thin cloud above the eye
  dvec2 cloud_drift_m{0.0, 0.0};   // how far the wind has carried it, along x and z
  double cloud_bend_m = 0.0;       // how far what bends its streaks has gone ahead
  bool ambient_occlusion = true;   // near surfaces block light of the sky
  double occlusion_m = 300.0;      // reach of the occlusion, which falls with distance
  bool bounced_light = true;  // near surfaces also send sunlight in place of the light they block
  Cumulus cumulus;
};

/// The gases of the air, and the land below as far as it lights the air.
struct Air {
  double density = 1.0;      // density of the molecules relative to the Earth's, 0 = none
  double ozone_du = 300.0;   // column of ozone in Dobson units
  vec3 ground_albedo{0.2f};  // albedo of the land around, whose light the air sends back
};

/// Droplets and dust, which thin out with height. Haze and molecules together dim contrast to 2 %
/// over the visibility at sea level (extinction = 3.912 / visibility).
struct Haze {
  double visibility_m = 60000.0;
  double scale_height_m = 1500.0;
  double angstrom = 1.2;    // extinction varies as wavelength to the power -angstrom; 0 is grey
  double asymmetry = 0.76;  // mean cosine of the scattering angle
  vec3 albedo{0.96f};       // share of the extinction that is scattering
};

/// Fog that fills the valleys. It is even up to its top and thins out above.
struct Fog {
  bool enabled = false;
  double visibility_m = 500.0;
  double top_m = 200.0;         // mean height of the top above the sea
  double softness_m = 30.0;     // height of the zone in which fog thins out
  double billow_m = 60.0;       // amplitude of the waves of the top
  double billow_width_m = 900;  // wavelength of the waves of the top

  bool operator==(const Fog&) const = default;
};

}  // namespace aerostat::scene

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/math.hpp"

/// The scene description holds all values of a scene file, with every default filled in. Names,
/// units and nesting are those of the JSON, so that reading and writing lose nothing. Lengths are
/// in metres, angles in degrees with `_deg` in the name, and colours in linear Rec. 709.
namespace aerostat::scene {

enum class BiomeKind { snow, tropical, sand };
enum class TerrainKind { mountains, island, dunes };
enum class FractalKind { fbm, ridged };
/// The level that the y of a position counts from: the sea (absolute), the ground under it, or,
/// for cameras only, the floor of the balloon's basket.
enum class HeightReference { sea, ground, balloon };
enum class View { outside, basket };
/// The projection that turns points of the picture into rays. A panorama shows all directions:
/// 360 degrees of azimuth across the picture and 180 degrees of height down it.
enum class Lens { pinhole, thin_lens, panorama, orthographic };
enum class Shading { flat, gouraud, phong };
enum class Integrator { local, path };
inline constexpr std::size_t kIntegratorCount = 2;
enum class Filter { box, tent, gaussian };
/// The amount of work for a picture. It sets samples, the adaptive threshold, soft shadows and
/// ambient occlusion together.
enum class Quality { draft, standard, final };
enum class Pattern { stripes, chevrons, spiral, rainbow, checker };
/// Sets of fabrics that go together. palettes.hpp gives their colours.
enum class Palette { ember, lagoon, spectrum, glacier, orchard, plum, regatta, meadow };

/// Several octaves of Perlin noise. The first octave has the wavelength Terrain::feature_m.
struct Fractal {
  FractalKind kind = FractalKind::ridged;
  int octaves = 12;
  double lacunarity = 2.0;    // frequency ratio of successive octaves
  double gain = 0.5;          // amplitude ratio of successive octaves
  double ridge_offset = 1.0;  // ridged only: (offset - |n|)^2

  bool operator==(const Fractal&) const = default;
};

/// Wind-blown sand, used by TerrainKind::dunes.
struct Dunes {
  double wind_deg = 250.0;      // azimuth that the wind blows towards
  double wavelength_m = 400.0;  // distance of crests along the wind
  double height_m = 45.0;       // height of the largest dunes from trough to crest

  bool operator==(const Dunes&) const = default;
};

/// The ground, a square of cells x cells quads around `center`, whose spacing grows outwards.
struct Terrain {
  TerrainKind kind = TerrainKind::mountains;
  std::uint32_t seed = 1;
  int cells = 1024;                // cells along a side
  double size_m = 40000.0;         // side of the square
  dvec2 center{0.0, 0.0};          // x and z of the finest cells, in metres
  double grading = 6.0;            // cell size at the rim divided by that at the centre, >= 1
  double height_m = 2400.0;        // rough height from the lowest valleys to the highest peaks
  double base_m = 0.0;             // added to every height
  double feature_m = 9000.0;       // wavelength of the first octave
  double warp_m = 900.0;           // amplitude of the domain distortion
  double warp_feature_m = 7000.0;  // wavelength of the domain distortion
  double sharpness = 1.0;          // > 1 widens valleys, < 1 widens heights
  double erosion = 0.7;            // strength of gullies, channels and scree, 0 (none) to 1
  Fractal fractal;
  Dunes dunes;

  bool operator==(const Terrain&) const = default;
};

/// The colours of the ground by height, slope and noise. One rule set serves all biomes.
struct Ground {
  vec3 cover_a{0.1f}, cover_b{0.1f};        // two tones of what grows or lies on gentle ground
  vec3 rock_a{0.1f}, rock_b{0.1f};          // two tones of bare rock
  double rock_slope_deg[2] = {30.0, 45.0};  // slopes where rock begins and where it is complete
  vec3 snow{0.85f};
  double snow_line_m = 1e6;                 // mean height above which snow lies
  double snow_fuzz_m = 250.0;               // height of the zone in which snow thins out
  double snow_slope_deg[2] = {35.0, 52.0};  // full snow below the first, no snow above the second
  vec3 beach{0.35f};
  double beach_top_m = -1e6;  // beach sand lies up to this height above the sea
  double pattern_m = 120.0;   // largest wavelength of colour and relief detail
  double relief = 0.9;        // strength of the detail in the normal, 0 = none
  double ripple_m = 0.0;      // wavelength of wind ripples, 0 = none
  double strata_m = 0.0;      // thickness of the largest beds of rock, 0 = none
  double softness = 0.0;      // evenness of the brightness of snow or sand over slopes, 0 to 1
  double sparkle = 0.0;       // strength of the glitter of grains, 0 = none
  vec3 forest{0.03f, 0.05f, 0.03f};
  double forest_top_m = 0.0;  // trees grow below this height
  double forest_share = 0.0;  // share of the ground that trees cover, 0 to 1
  double canopy_m = 7.0;      // width of a tree's crown

  bool operator==(const Ground&) const = default;
};

/// The sea, a plane at `level_m` that exists if `enabled` is true.
struct Water {
  bool enabled = false;
  double level_m = 0.0;
  vec3 absorption_per_m{0.35f, 0.06f, 0.015f};  // absorption of the Beer-Lambert law
  vec3 scatter{0.01f, 0.09f, 0.12f};            // colour of deep water
  vec3 bed{0.55f, 0.5f, 0.38f};                 // albedo of the sand under the sea
  double wave_m = 14.0;                         // wavelength of the largest waves
  double wave_slope = 0.06;                     // root mean square slope of the waves

  bool operator==(const Water&) const = default;
};

struct Biome {
  BiomeKind kind = BiomeKind::snow;
  Ground ground;
  Water water;

  bool operator==(const Biome&) const = default;
};

/// Plants and stones that stand on the ground, placed by the biome's rules.
struct Vegetation {
  bool enabled = true;
  double density = 1.0;     // 1: woods as dense as those painted on the ground, 0: none
  double size = 1.0;        // factor on all heights
  double reach_m = 6000.0;  // distance from the camera within which single trees stand
  std::uint32_t seed = 1;

  bool operator==(const Vegetation&) const = default;
};

struct Balloon {
  bool enabled = true;
  dvec3 position{0.0, 0.0, 0.0};  // centre of the basket's floor
  HeightReference height_above = HeightReference::ground;
  double diameter_m = 18.8;
  double heading_deg = 0.0;
  int gores = 24;
  double burner = 1.0;  // strength of the burners, 0 (no flame) to 1
  Pattern pattern = Pattern::stripes;
  Palette palette = Palette::ember;
  std::vector<vec3> colors;  // at least one; the pattern repeats them; default: the palette's

  bool operator==(const Balloon&) const = default;
};

struct Camera {
  View view = View::outside;
  /// The eye, and a point in the middle of the picture. Without them, world::resolve puts the eye
  /// into the basket and lets it look straight ahead, so that a resolved scene has both.
  std::optional<dvec3> position, target;
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

/// The sun. `direction` is a unit vector towards the sun. In its place, files may give
/// azimuth_deg and elevation_deg, or date, time, latitude_deg and longitude_deg.
struct Sun {
  dvec3 direction{0.0, 1.0, 0.0};
  vec3 color{1.0f};         // colour outside the air; its largest component is 1
  double irradiance = 5.0;  // irradiance outside the air, on a plane that faces the sun
  bool shadows = true;
  bool soft_shadows = true;  // shadows are cast by the sun's disc, not by its centre
};

struct PointLight {
  dvec3 position{0.0};
  vec3 color{1.0f};
  double intensity = 100.0;  // irradiance times the square of the distance
  bool shadows = true;
};

/// Heaped fair-weather clouds over flat bases. Their shadows fall on the land.
struct Cumulus {
  double cover = 0.0;          // share of the sky straight above, 0 to 1
  double base_m = 1400.0;      // height of the bases above the sea
  double thickness_m = 500.0;  // height from the bases to high tops
  double size_m = 700.0;       // width of a cloud
  std::uint32_t seed = 1;
};

/// The clouds and the light of the sky, apart from sun and air.
struct Sky {
  double cloud_cover = 0.4;        // share of the sky that thin high cloud covers, 0 to 1
  double cloud_height_m = 7000.0;  // height of the thin cloud above the eye
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

/// The objects of a scene. The value of the enum is the `id` channel of an EXR picture, in which 0
/// is the sky. The manual lists the values.
enum class ObjectId : std::uint32_t {
  sky = 0,
  terrain,
  water,
  envelope,
  skirt,
  basket,
  rim,
  frame,
  cables,
  floor,
  flame,
  plant,
  stone,
  count
};
inline constexpr std::size_t kObjectCount = static_cast<std::size_t>(ObjectId::count);

/// The materials that objects are made of. The value of the enum is an index into Scene::materials.
enum class MaterialId : std::uint32_t {
  terrain,
  water,
  envelope,
  skirt,
  basket,
  rim,
  frame,
  cables,
  floor,
  flame,
  plant,
  stone,
  count
};
inline constexpr std::size_t kMaterialCount = static_cast<std::size_t>(MaterialId::count);

/// The kinds of materials. A kind says how the colour, the bumps and the gloss of a point are
/// found.
enum class MaterialKind { plain, ground, water, envelope, skirt, suede };

/// Phong coefficients. Most materials multiply the colours of vertices by `albedo`. Terrain and
/// water take their colours from Ground and Water.
struct Material {
  vec3 albedo{1.0f};
  double ambient = 1.0;
  double diffuse = 1.0;
  double specular = 0.0;
  double shininess = 32.0;
  double translucency = 0.0;  // share of the light on the far side that shines through
  vec3 emission{0.0f};        // radiance, multiplied by the vertex colour
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
};

struct Scene {
  Biome biome;
  Terrain terrain;
  Vegetation vegetation;
  Balloon balloon;
  std::vector<Balloon> balloons;  // further balloons
  Camera camera;
  Sun sun;
  std::vector<PointLight> lights;
  Sky sky;
  Air air;
  Haze haze;
  Fog fog;
  std::array<Material, kMaterialCount> materials;  // indexed by MaterialId
  Shading shading = Shading::phong;
  Integrator light = Integrator::local;
  int bounces = 6;  // of paths between surfaces
  Quality quality = Quality::standard;
  Image image;

  Material& material(MaterialId id) { return materials[static_cast<std::size_t>(id)]; }
  const Material& material(MaterialId id) const { return materials[static_cast<std::size_t>(id)]; }
};

/// Returns the name of an object in exported meshes, such as "envelope".
std::string object_name(ObjectId id);

/// Returns the JSON key of a material, such as "envelope".
std::string material_name(MaterialId id);

/// Returns the kind of a material.
MaterialKind material_kind(MaterialId id);

/// Tells whether the burners of the balloon light a material. Their light has no shadows, so it is
/// kept to the balloon.
bool lit_by_burners(MaterialId id);

}  // namespace aerostat::scene

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/earth.hpp"
#include "core/land_cover.hpp"
#include "core/math.hpp"
#include "scene/up_axis.hpp"

/// The land of a scene: its heights, its colours, the sea and what grows on it.
namespace aerostat::scene {

enum class BiomeKind { snow, tropical, sand, meadow };
/// The word that scene files may have for a kind of biome that they leave open.
inline constexpr const char* kLeftOutBiome = "auto";
/// The time of the year in a meadow, which sets the colours of leaves and grass.
enum class Season { spring, summer, autumn };
/// The shape of the ground. `elevation` is that of the files of ElevationSource.
enum class TerrainKind { mountains, island, dunes, elevation };
enum class FractalKind { fbm, ridged };

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

/// The unit of the heights in a file. `automatic` goes by what the file says.
enum class HeightUnit { automatic, metre, decimetre, centimetre, foot, us_survey_foot };
/// The way in which the colours of an image tile hold heights.
enum class TileEncoding { automatic, terrarium, terrain_rgb };
/// What lies where the files have no heights over a large area: land like that around, or sea.
enum class Voids { land, sea };
/// What becomes of level areas of the heights: lakes and rivers, or dry land.
enum class InlandWater { automatic, none };
enum class SampleType { automatic, uint8, int8, uint16, int16, uint32, int32, float32, float64 };

/// The point of the files that lies at the terrain's centre: a latitude and longitude on WGS 84, or
/// coordinates of the files' own system. Either both of a pair are given or none.
struct TerrainPlace {
  std::optional<double> latitude_deg, longitude_deg;
  std::optional<double> easting, northing;

  bool operator==(const TerrainPlace&) const = default;
};

/// The layout of a file that holds nothing but samples. A width and height of 0 mean that the file
/// is square.
struct RawSamples {
  int width = 0, height = 0;
  SampleType type = SampleType::automatic;
  bool big_endian = false;
  int header_bytes = 0;

  bool operator==(const RawSamples&) const = default;
};

/// The places of two corners of a picture, as [latitude, longitude] in degrees on WGS 84. Either
/// both are given or none.
struct DrapeCorners {
  std::optional<dvec2> north_west, south_east;

  bool operator==(const DrapeCorners&) const = default;
};

/// A picture that lies over the ground of elevation data, such as an orthophoto.
struct Drape {
  std::string file;           // empty: none
  double blend = 1.0;         // how much it counts beside the ground's own colours, 0 to 1
  std::string crs;            // coordinate reference system; empty: as the file says
  DrapeCorners corners;       // for pictures that do not say where they lie
  double lift_shadows = 0.0;  // by how much its own light and shade are taken out, 0 to 1

  bool operator==(const Drape&) const = default;
};

/// The class of a code of land cover.
struct CoverCode {
  int code = 0;
  CoverClass is = CoverClass::meadow;

  bool operator==(const CoverCode&) const = default;
};

/// A raster of land cover, which says what grows and lies on the ground of elevation data.
struct LandCover {
  std::string source;  // file; empty: none
  CoverScheme scheme = CoverScheme::automatic;
  std::string crs;                 // coordinate reference system; empty: as the file says
  std::vector<CoverCode> classes;  // of codes that the scheme does not know

  bool operator==(const LandCover&) const = default;
};

/// Elevation data, and what a scene says of it in place of the files.
struct ElevationSource {
  std::vector<std::string> source;  // files and folders; empty: the ground is made from noise
  std::string crs;                  // coordinate reference system; empty: as the files say
  HeightUnit unit = HeightUnit::automatic;
  std::optional<double> nodata;  // the value of samples without a height
  std::optional<dvec2>
      image_heights_m;           // the heights of the least and the greatest value of images
  std::optional<double> cell_m;  // distance of samples, for files that do not give a place
  TileEncoding encoding = TileEncoding::automatic;
  std::string variable;  // of files that hold several; empty: by its name
  RawSamples raw;
  TerrainPlace place;
  std::optional<double> extent_m;  // side of the square of the files around `place` that counts
  Voids voids = Voids::land;
  InlandWater inland_water = InlandWater::automatic;
  bool curved = true;   // the ground falls away with the curvature of the Earth
  double detail = 1.0;  // strength of the relief that is added below the files' resolution
  Drape drape;
  LandCover cover;

  bool operator==(const ElevationSource&) const = default;
};

/// The ground, a square of cells x cells quads around `center`, whose spacing grows outwards.
struct Terrain : ElevationSource {
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

/// Returns by what number times the square of the distance from its centre, in metres, the ground
/// falls away. It is 0 for ground that is not curved.
inline double ground_fall(const Terrain& terrain) {
  return terrain.kind == TerrainKind::elevation && terrain.curved ? kEarthFall_per_m : 0.0;
}

/// Returns the terrain without the picture on it, which its shape does not depend on.
inline Terrain without_drape(Terrain terrain) {
  terrain.drape = {};
  return terrain;
}

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
  double forest_top_m = 0.0;       // trees grow below this height
  double forest_share = 0.0;       // share of the ground that trees cover, 0 to 1
  double canopy_m = 7.0;           // width of a tree's crown
  vec3 field{0.3f, 0.24f, 0.09f};  // ripe corn and stubble
  double field_m = 0.0;            // width of fields on gentle ground, 0 = none

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
  double time_s = 0.0;                          // time at which the waves are seen

  bool operator==(const Water&) const = default;
};

struct Biome {
  BiomeKind kind = BiomeKind::snow;
  Season season = Season::summer;
  Ground ground;
  Water water;

  bool operator==(const Biome&) const = default;
};

/// A circle in plan in which nothing grows.
struct Clearing {
  dvec2 center{0.0};  // x and z
  double radius_m = 10.0;

  bool operator==(const Clearing&) const = default;
};

/// The most clearings of a scene.
inline constexpr int kMostClearings = 4096;

/// Where plants of a species from a file grow.
enum class PlantPlace {
  woods,    // in place of trees of the woods
  open,     // outside of the woods
  anywhere  // on dry land
};

/// The most species from files.
inline constexpr int kMostSpecies = 16;

/// A species of plants whose shape is a model from a file.
struct PlantSpecies {
  std::string file;
  UpAxis up = UpAxis::y;
  PlantPlace grows = PlantPlace::woods;
  std::optional<dvec2> height_m{};     // least and greatest of the plants; default: the file's own
  double share = 0.5;                  // of the trees of the woods
  double per_hectare = 20.0;           // plants elsewhere
  dvec2 slope_deg{0.0, 45.0};          // of the ground
  dvec2 heights_m{-12000.0, 12000.0};  // of the ground above the sea
  std::vector<CoverClass> cover{};     // the land cover on which they grow; empty: on any
  double tint = 0.15;                  // how much their brightness differs

  bool operator==(const PlantSpecies&) const = default;
};

/// Plants and stones that stand on the ground, placed by the biome's rules.
struct Vegetation {
  bool enabled = true;
  double density = 1.0;     // 1: woods as dense as those painted on the ground, 0: none
  double size = 1.0;        // factor on all heights
  double reach_m = 6000.0;  // distance from the camera within which single trees stand
  std::uint32_t seed = 1;
  std::vector<Clearing> clearings;
  bool usual = true;                       // the species of the biome grow, too
  std::vector<PlantSpecies> species = {};  // from files

  bool operator==(const Vegetation&) const = default;
};

}  // namespace aerostat::scene

#pragma once

#include "scene/field.hpp"
#include "scene/scene.hpp"

/// The ground, the sea and what grows on the ground.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Fractal> =
    table("Octaves of Perlin noise.",
          field("kind", &Fractal::kind,
                word("How the octaves are summed.").control(EditGroup::shape, "Noise")),
          field("octaves", &Fractal::octaves,
                number(1, 20, "Number of octaves, {from} to {to}.")
                    .slider(EditGroup::shape, "Octaves", 1, 20)),
          field("lacunarity", &Fractal::lacunarity,
                number(1, 4, "Frequency ratio of successive octaves, {from} to {to}.")
                    .slider(EditGroup::shape, "Lacunarity", 1.5, 3, 2)),
          field("gain", &Fractal::gain,
                number(0, 8, "Amplitude ratio of successive octaves, {from} to {to}.")
                    .slider(EditGroup::land, "Roughness", 0.2, 0.8, 2)),
          field("ridge_offset", &Fractal::ridge_offset,
                number(0, 4, "Ridged noise only: offset in (offset - |n|)^2, {from} to {to}.")
                    .slider(EditGroup::shape, "Offset of ridges", 0.5, 2, 2)));

template <>
inline constexpr auto kTable<Dunes> =
    table("Wind-blown sand, for terrain of kind dunes.",
          field("wind_deg", &Dunes::wind_deg,
                number(-360, 360, "Azimuth in degrees that the wind blows towards, {from} to {to}.")
                    .slider(EditGroup::dunes, "Wind blows to", -180, 360)),
          field("wavelength_m", &Dunes::wavelength_m,
                number(1, 100000, "Crest to crest along the wind, in metres, {from} to {to}.")
                    .slider(EditGroup::dunes, "Crest to crest", 50, 2000, 0, Scale::logarithmic)),
          field("height_m", &Dunes::height_m,
                number(0, 5000, "Trough to crest of the largest dunes, in metres, {from} to {to}.")
                    .slider(EditGroup::dunes, "Height", 0, 200)));

template <>
inline constexpr auto kTable<Terrain> = table(
    "The ground: a square of cells x cells quads around center, whose spacing grows outwards. "
    "Defaults come with the biome.",
    field("kind", &Terrain::kind, word("Overall shape.").control(EditGroup::shape, "Kind")),
    field("seed", &Terrain::seed,
          number(0, 4294967295, "Seed of the noise, {from} to {to}; another number, another land.")
              .dice(EditGroup::land, "Seed")),
    field("cells", &Terrain::cells,
          number(2, 4096, "Quads per side, {from} to {to}.")
              .slider(EditGroup::land, "Cells a side", 64, 4096, 0, Scale::logarithmic)),
    field("size_m", &Terrain::size_m,
          number(10, 1000000, "Side of the square in metres, {from} to {to}.")
              .slider(EditGroup::land, "Size", 2000, 200000, 0, Scale::logarithmic)),
    field("center", &Terrain::center,
          number(-1000000, 1000000,
                 "[x, z] in metres of the finest cells. Relief, ground patterns, plants, waves and "
                 "clouds go with it.")
              .slider(EditGroup::shape, "Middle, east", -5000, 5000)
              .slider(EditGroup::shape, "Middle, south", -5000, 5000)),
    field("grading", &Terrain::grading,
          number(1, 1000, "Cell size at the rim over that at the centre, {from} (even) to {to}.")
              .slider(EditGroup::shape, "Finer in the middle", 1, 20, 1, Scale::logarithmic)),
    field("height_m", &Terrain::height_m,
          number(0, 20000,
                 "Roughly from the lowest valleys to the highest peaks, in metres, {from} to {to}.")
              .slider(EditGroup::land, "Height", 0, 6000)),
    field("base_m", &Terrain::base_m,
          number(-100000, 100000, "Added to every height, in metres, {from} to {to}.")
              .slider(EditGroup::shape, "Raised by", -500, 2000)),
    field("feature_m", &Terrain::feature_m,
          number(1, 1000000, "Wavelength of the first octave in metres, {from} to {to}.")
              .slider(EditGroup::shape, "Width of ranges", 500, 40000, 0, Scale::logarithmic)),
    field("warp_m", &Terrain::warp_m,
          number(0, 100000, "Amplitude of the domain distortion in metres, {from} (none) to {to}.")
              .slider(EditGroup::shape, "Bends", 0, 5000)),
    field("warp_feature_m", &Terrain::warp_feature_m,
          number(1, 1000000, "Wavelength of the domain distortion in metres, {from} to {to}.")
              .slider(EditGroup::shape, "Width of bends", 500, 40000, 0, Scale::logarithmic)),
    field("sharpness", &Terrain::sharpness,
          number(0.1, 10,
                 "Exponent of the heights, {from} to {to}: above 1 widens valleys, below 1 widens "
                 "heights.")
              .slider(EditGroup::land, "Sharpness", 0.4, 3, 2)),
    field("erosion", &Terrain::erosion,
          number(
              0, 1,
              "Strength of what water and frost have done to the ground at the scale of its cells, "
              "{from} (nothing) to {to}: gullies, channels, and scree at the angle of repose.")
              .slider(EditGroup::land, "Erosion", 0, 1, 2)),
    field("fractal", &Terrain::fractal), field("dunes", &Terrain::dunes));

template <>
inline constexpr auto kTable<Ground> = table(
    "How the ground is coloured, by height, slope and noise. Every default comes with the biome.",
    field("cover_a", &Ground::cover_a,
          color("Albedo of the first tone of what grows or lies on gentle ground.")
              .control(EditGroup::ground, "Cover")),
    field("cover_b", &Ground::cover_b,
          color("Albedo of its second tone; noise mixes the two.")
              .control(EditGroup::ground, "Cover, second tone")),
    field("rock_a", &Ground::rock_a,
          color("Albedo of the first tone of bare rock.").control(EditGroup::ground, "Rock")),
    field("rock_b", &Ground::rock_b,
          color("Albedo of its second tone.").control(EditGroup::ground, "Rock, second tone")),
    field("rock_slope_deg", &Ground::rock_slope_deg,
          number(0, 90,
                 "Slopes in degrees from which rock begins and beyond which it is complete, {from} "
                 "to {to}, the smaller one first.")
              .slider(EditGroup::ground, "Rock begins at", 0, 90)
              .slider(EditGroup::ground, "All rock from", 0, 90)),
    field("snow", &Ground::snow,
          color("Albedo of snow; keep it below 0.95, or it clips.")
              .control(EditGroup::ground, "Snow")),
    field("snow_line_m", &Ground::snow_line_m,
          number(-1000000, 1000000,
                 "Mean height in metres above which snow lies, {from} to {to}; {to} means no snow.")
              .slider(EditGroup::snow_and_water, "Snow line", -1000, 4000)),
    field("snow_fuzz_m", &Ground::snow_fuzz_m,
          number(0, 100000,
                 "Height in metres of the zone in which the snow thins out, {from} to {to}.")
              .slider(EditGroup::ground, "Snow thins out over", 0, 1000)),
    field("snow_slope_deg", &Ground::snow_slope_deg,
          number(0, 90,
                 "Slopes in degrees up to which snow is full and beyond which none holds, {from} "
                 "to {to}, the smaller one first.")
              .slider(EditGroup::ground, "Full snow up to", 0, 90)
              .slider(EditGroup::ground, "No snow from", 0, 90)),
    field("beach", &Ground::beach,
          color("Albedo of dry sand at the shore.").control(EditGroup::ground, "Beach")),
    field("beach_top_m", &Ground::beach_top_m,
          number(-1000000, 1000000,
                 "Sand lies up to this height above the sea, in metres, {from} to {to}; {from} "
                 "means no beach.")
              .slider(EditGroup::ground, "Beach up to", -50, 50, 1)
              .none("no beach")),
    field("pattern_m", &Ground::pattern_m,
          number(0, 100000,
                 "Largest wavelength of the detail in colour and relief, in metres, above {from} "
                 "to {to}.")
              .above()
              .slider(EditGroup::ground, "Width of patterns", 5, 500, 0, Scale::logarithmic)),
    field("relief", &Ground::relief,
          number(0, 10, "Strength of the detail in the normal, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Relief in detail", 0, 2, 2)),
    field("ripple_m", &Ground::ripple_m,
          number(0, 1000, "Wavelength of wind ripples in metres, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Ripples", 0, 5, 2)),
    field("strata_m", &Ground::strata_m,
          number(0, 10000,
                 "Thickness of the largest beds of rock in metres, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Beds of rock", 0, 200, 1)),
    field("softness", &Ground::softness,
          number(0, 1,
                 "How evenly bright snow or sand is at every slope to the sun, as grains send "
                 "light back: {from} (Lambert) to {to}.")
              .slider(EditGroup::ground, "Softness", 0, 1, 2)),
    field("sparkle", &Ground::sparkle,
          number(0, 10, "Strength of the glitter of grains of snow or sand, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Sparkle", 0, 2, 2)),
    field("forest", &Ground::forest,
          color("Albedo of trees.").control(EditGroup::ground, "Forest")),
    field("forest_top_m", &Ground::forest_top_m,
          number(-100000, 100000, "Height in metres up to which trees grow, {from} to {to}.")
              .slider(EditGroup::ground, "Forest up to", 0, 3000)),
    field("forest_share", &Ground::forest_share,
          number(0, 1,
                 "Share of the ground that trees cover below that height, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Share of forest", 0, 1, 2)),
    field("canopy_m", &Ground::canopy_m,
          number(0.1, 1000, "Width of a tree's crown in metres, {from} to {to}.")
              .slider(EditGroup::ground, "Width of crowns", 1, 30, 1)));

template <>
inline constexpr auto kTable<Water> =
    table("The sea: a plane at level_m.",
          field("enabled", &Water::enabled,
                truth("Whether there is a sea.").control(EditGroup::snow_and_water, "Sea")),
          field("level_m", &Water::level_m,
                number(-1000000, 1000000, "Height of the plane in metres, {from} to {to}.")
                    .slider(EditGroup::snow_and_water, "Sea level", -200, 1000)),
          field("absorption_per_m", &Water::absorption_per_m,
                number(0, 100,
                       "Absorption per metre of water by Beer and Lambert, for [red, green, blue], "
                       "{from} to {to}.")
                    .boxes(EditGroup::sea, "Absorption, 1/m", 3)),
          field("scatter", &Water::scatter,
                color("Colour of deep water.").control(EditGroup::sea, "Deep water")),
          field("bed", &Water::bed,
                color("Albedo of the sand under the water.").control(EditGroup::sea, "Sea bed")),
          field("wave_m", &Water::wave_m,
                number(0, 10000, "Wavelength of the largest waves in metres, above {from} to {to}.")
                    .above()
                    .slider(EditGroup::sea, "Longest waves", 1, 200, 1, Scale::logarithmic)),
          field("wave_slope", &Water::wave_slope,
                number(0, 1, "Root mean square slope of the waves, {from} (a mirror) to {to}.")
                    .slider(EditGroup::sea, "Slope of waves", 0, 0.3, 3)));

template <>
inline constexpr auto kTable<Biome> = table(
    "The biome with changes to its ground and sea.",
    field(
        "kind", &Biome::kind,
        word("The switch that brings terrain shape, colours, light, sky, air and balloon colours.")
            .control(EditGroup::land, "Biome")),
    field("ground", &Biome::ground), field("water", &Biome::water));

template <>
inline constexpr auto kTable<Vegetation> = table(
    "Plants and stones that stand on the ground; what grows where comes with the biome.",
    field("enabled", &Vegetation::enabled,
          truth("Whether anything stands on the ground.").control(EditGroup::plants, "Plants")),
    field("density", &Vegetation::density,
          number(0, 4, "Plants per area against the biome's usual number, {from} (none) to {to}.")
              .slider(EditGroup::plants, "Density", 0, 2, 2)),
    field("size", &Vegetation::size,
          number(0.1, 10, "Factor on the height of every plant and stone, {from} to {to}.")
              .slider(EditGroup::plants, "Size of plants", 0.3, 3, 2)),
    field("reach_m", &Vegetation::reach_m,
          number(10, 12000,
                 "How far from the camera single trees stand, in metres, {from} to {to}; beyond it "
                 "woods are painted on the ground. Smaller growth reaches less far in proportion.")
              .slider(EditGroup::plants, "Single trees up to", 500, 12000, 0, Scale::logarithmic)),
    field("seed", &Vegetation::seed,
          number(0, 4294967295, "Another number, other plants, {from} to {to}.")
              .slider(EditGroup::plants, "Seed of plants", 1, 1000)));

}  // namespace aerostat::scene::detail

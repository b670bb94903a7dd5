#pragma once

#include "scene/cover_fields.hpp"
#include "scene/field.hpp"
#include "scene/land.hpp"
#include "scene/vegetation_fields.hpp"

/// The ground, the sea and what grows on the ground.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Fractal> =
    table("Sum of octaves of Perlin noise.",
          field("kind", &Fractal::kind,
                word("Method by which the octaves are summed.").control(EditGroup::shape, "Noise")),
          field("octaves", &Fractal::octaves,
                number(1, 20, "Number of octaves, {from} to {to}.")
                    .slider(EditGroup::shape, "Octaves", 1, 20)),
          field("lacunarity", &Fractal::lacunarity,
                number(1, 4, "Ratio of the frequencies of successive octaves, {from} to {to}.")
                    .slider(EditGroup::shape, "Lacunarity", 1.5, 3, 2)),
          field("gain", &Fractal::gain,
                number(0, 8, "Ratio of the amplitudes of successive octaves, {from} to {to}.")
                    .slider(EditGroup::land, "Roughness", 0.2, 0.8, 2)),
          field("ridge_offset", &Fractal::ridge_offset,
                number(0, 4,
                       "Offset of ridged noise in (offset - |n|)^2, {from} to {to}. Other kinds of "
                       "noise ignore it.")
                    .slider(EditGroup::shape, "Ridge offset", 0.5, 2, 2)));

template <>
inline constexpr auto kTable<Dunes> = table(
    "Dunes of wind-blown sand. Only terrain of the kind dunes has them.",
    field("wind_deg", &Dunes::wind_deg,
          number(-360, 360,
                 "Azimuth in degrees towards which the wind blows, {from} to {to}. On land of any "
                 "kind, ripples of sand and drifts of snow follow it.")
              .slider(EditGroup::dunes, "Wind blows towards", -180, 360)),
    field("wavelength_m", &Dunes::wavelength_m,
          number(1, 100000,
                 "Distance from crest to crest along the wind in metres, {from} to {to}.")
              .slider(EditGroup::dunes, "Crest to crest", 50, 2000, 0, Scale::logarithmic)),
    field("height_m", &Dunes::height_m,
          number(0, 5000,
                 "Height of the largest dunes from trough to crest in metres, {from} to {to}.")
              .slider(EditGroup::dunes, "Height", 0, 200)));

template <>
inline constexpr auto kTable<TerrainPlace> = table(
    "Point of the source that lies at center. It is a latitude and longitude, or an easting and "
    "northing in the source's own coordinates. If it is left out, the middle of the source counts.",
    field("latitude_deg", &TerrainPlace::latitude_deg,
          number(-90, 90, "Latitude in degrees, {from} to {to} (north).")),
    field("longitude_deg", &TerrainPlace::longitude_deg,
          number(-360, 360, "Longitude in degrees, {from} to {to}; east is positive.")),
    field(
        "easting", &TerrainPlace::easting,
        number(-1e9, 1e9,
               "First coordinate, from west to east, in the units of the source, {from} to {to}.")),
    field("northing", &TerrainPlace::northing,
          number(-1e9, 1e9,
                 "Second coordinate, from south to north, in the units of the source, {from} to "
                 "{to}.")));

template <>
inline constexpr auto kTable<RawSamples> = table(
    "Layout of a file that holds nothing but samples, such as .r16 and .raw.",
    field("width", &RawSamples::width,
          number(0, 1048576, "Samples in a row, {from} (a square file) to {to}.")),
    field("height", &RawSamples::height,
          number(0, 1048576, "Rows, {from} (a square file) to {to}.")),
    field("type", &RawSamples::type,
          word("Type of a sample. auto (the default) goes by the name of the file: uint16 for .r16 "
               "and .raw, float32 for .r32.")),
    field("big_endian", &RawSamples::big_endian,
          truth("Whether the first byte of a sample is its most significant one.")),
    field("header_bytes", &RawSamples::header_bytes,
          number(0, 1e9, "Bytes before the first sample, {from} to {to}.")));

template <>
inline constexpr auto kTable<DrapeCorners> = table(
    "Places of two corners of the picture, for one that does not say where it lies. Its rows run "
    "from west to east and its columns from north to south.",
    field("north_west", &DrapeCorners::north_west,
          number(-360, 360,
                 "Outer corner of the first pixel of the first row, [latitude, longitude] in "
                 "degrees on WGS 84.")),
    field("south_east", &DrapeCorners::south_east,
          number(-360, 360,
                 "Outer corner of the last pixel of the last row, [latitude, longitude] in degrees "
                 "on WGS 84.")));

template <>
inline constexpr auto kTable<Drape> = table(
    "Picture that lies over the ground of a source, such as an orthophoto. Where it is transparent "
    "and outside of it, the ground has its own colours.",
    field("file", &Drape::file,
          text("Name of the picture, relative to the folder of the scene file: GeoTIFF, PNG or "
               "JPEG. An empty name means that there is none.")),
    field("blend", &Drape::blend,
          number(0, 1,
                 "Share of the picture in the colour of the ground, {from} (the ground's own "
                 "colours) to {to} (the picture alone).")
              .slider(EditGroup::ground, "Picture on the ground", 0, 1, 2)),
    field("crs", &Drape::crs,
          text("Coordinate reference system of the picture, such as EPSG:3857, which wins over "
               "what the file says.")),
    field("corners", &Drape::corners),
    field("lift_shadows", &Drape::lift_shadows,
          number(0, 1,
                 "By how much the light and shade of the sun that shone when the picture was taken "
                 "are taken out of it, {from} (not at all, the default) to {to}. The sun is found "
                 "from the shape of the land.")
              .slider(EditGroup::ground, "Shadows of the picture lifted", 0, 1, 2)));

template <>
inline constexpr auto kTable<Terrain> = table(
    "The ground: a square of cells x cells quads around center. The quads grow outwards. Defaults "
    "come with the biome, or from the elevation data of source.",
    field("kind", &Terrain::kind,
          word("Overall shape of the ground. elevation is that of source and needs it; it is the "
               "default with a source.")
              .control(EditGroup::shape, "Kind")),
    field(
        "source", &Terrain::source,
        texts(
            4096,
            "Files of elevation data, or folders of them, at most {to}, relative to the folder of "
            "the scene file. A single name needs no list. Where files overlap, the first wins.",
            "Name of a file or of a folder.")),
    field("crs", &Terrain::crs,
          text("Coordinate reference system of the source, such as EPSG:2056, which wins over what "
               "the files say.")),
    field(
        "unit", &Terrain::unit,
        word(
            "Unit of the heights in the source. auto (the default) goes by what the files say, and "
            "takes metres if they say nothing. ft is the international foot, us-ft that of US "
            "surveys.")),
    field("nodata", &Terrain::nodata,
          number(-1e9, 1e9,
                 "Value of samples of the source that have no height, {from} to {to}. Samples that "
                 "are no numbers, or below -1e30, never have one.")),
    field(
        "image_heights_m", &Terrain::image_heights_m,
        number(-100000, 100000,
               "Heights in metres of black and of white, for images and other sources that do not "
               "give them.")),
    field(
        "cell_m", &Terrain::cell_m,
        number(0, 1000000,
               "Distance of neighbouring samples in metres, {from} (excluded) to {to}, for sources "
               "that do not say where they lie.")
            .above()),
    field("encoding", &Terrain::encoding,
          word("How the colours of image tiles hold heights. auto (the default) finds out.")),
    field("variable", &Terrain::variable,
          text("Name of the variable that holds heights, for files with several.")),
    field("raw", &Terrain::raw), field("place", &Terrain::place),
    field(
        "extent_m", &Terrain::extent_m,
        number(10, 1000000,
               "Side of the square around place in metres, {from} to {to}, from which the view is "
               "chosen. If it is left out, all of the source counts.")),
    field(
        "voids", &Terrain::voids,
        word("What lies where the source has no heights over a large area. land (the default) goes "
             "on like the land around it, and sea is water.")),
    field("inland_water", &Terrain::inland_water,
          word("What becomes of level areas of a source. auto (the default) makes lakes and rivers "
               "of them, and none leaves them dry.")
              .control(EditGroup::snow_and_water, "Lakes and rivers")),
    field(
        "curved", &Terrain::curved,
        truth(
            "Whether the ground of a source falls away with the curvature of the Earth, less what "
            "refraction gives back.")
            .control(EditGroup::shape, "Curvature of the Earth")),
    field(
        "detail", &Terrain::detail,
        number(
            0, 4,
            "Strength of the relief that is added where the mesh is finer than the source, {from} "
            "(the source alone) to {to}.")
            .slider(EditGroup::shape, "Added detail", 0, 2, 2)),
    field("drape", &Terrain::drape), field("cover", &Terrain::cover),
    field("seed", &Terrain::seed,
          number(0, 4294967295,
                 "Seed of the noise, {from} to {to}. Each seed gives another landscape.")
              .dice(EditGroup::land, "Seed")),
    field("cells", &Terrain::cells,
          number(2, 4096, "Number of quads per side, {from} to {to}.")
              .slider(EditGroup::land, "Cells per side", 64, 4096, 0, Scale::logarithmic)),
    field("size_m", &Terrain::size_m,
          number(10, 1000000, "Length of a side of the square in metres, {from} to {to}.")
              .slider(EditGroup::land, "Size", 2000, 200000, 0, Scale::logarithmic)),
    field("center", &Terrain::center,
          number(-1000000, 1000000,
                 "Position of the smallest cells, [x, z] in metres. Relief, ground patterns, "
                 "plants, waves and clouds move with it.")
              .slider(EditGroup::shape, "Middle, east", -5000, 5000)
              .slider(EditGroup::shape, "Middle, south", -5000, 5000)),
    field("grading", &Terrain::grading,
          number(1, 1000,
                 "Size of a cell at the rim divided by that of a cell at the centre, {from} (all "
                 "cells have the same size) to {to}.")
              .slider(EditGroup::shape, "Finer in the middle", 1, 20, 1, Scale::logarithmic)),
    field("height_m", &Terrain::height_m,
          number(0, 20000,
                 "Approximate height from the lowest valleys to the highest peaks in metres, "
                 "{from} to {to}.")
              .slider(EditGroup::land, "Height", 0, 6000)),
    field("base_m", &Terrain::base_m,
          number(-100000, 100000,
                 "Height in metres that is added to the whole ground, {from} to {to}.")
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
                 "Exponent of the heights, {from} to {to}. Values above 1 widen the valleys, and "
                 "values below 1 widen the high ground.")
              .slider(EditGroup::land, "Sharpness", 0.4, 3, 2)),
    field("erosion", &Terrain::erosion,
          number(0, 1,
                 "Strength of erosion by water and frost at the scale of the cells, {from} (none) "
                 "to {to}. It makes gullies, channels, and scree at the angle of repose.")
              .slider(EditGroup::land, "Erosion", 0, 1, 2)),
    field("fractal", &Terrain::fractal), field("dunes", &Terrain::dunes));

template <>
inline constexpr auto kTable<Ground> = table(
    "Colours of the ground, which depend on height, slope and noise. All defaults come with the "
    "biome.",
    field("cover_a", &Ground::cover_a,
          color("First tone of what covers gentle slopes, such as grass or sand, as an albedo.")
              .control(EditGroup::ground, "Cover")),
    field(
        "cover_b", &Ground::cover_b,
        color("Second tone of what covers gentle slopes, as an albedo. Noise mixes the two tones.")
            .control(EditGroup::ground, "Cover, second tone")),
    field("rock_a", &Ground::rock_a,
          color("First tone of bare rock, as an albedo.").control(EditGroup::ground, "Rock")),
    field("rock_b", &Ground::rock_b,
          color("Second tone of bare rock, as an albedo. Noise mixes the two tones.")
              .control(EditGroup::ground, "Rock, second tone")),
    field("rock_slope_deg", &Ground::rock_slope_deg,
          number(0, 90,
                 "Two slopes in degrees, {from} to {to}, the smaller one first. Rock begins to "
                 "show at the first slope, and ground steeper than the second is all rock.")
              .slider(EditGroup::ground, "Rock begins at", 0, 90)
              .slider(EditGroup::ground, "All rock from", 0, 90)),
    field("snow", &Ground::snow,
          color("Albedo of snow. Snow with an albedo above 0.95 clips to white in the picture.")
              .control(EditGroup::ground, "Snow")),
    field("snow_line_m", &Ground::snow_line_m,
          number(-1000000, 1000000,
                 "Mean height in metres above which snow lies, {from} to {to}. The value {to} "
                 "means that there is no snow.")
              .slider(EditGroup::snow_and_water, "Snow line", -1000, 4000)),
    field("snow_fuzz_m", &Ground::snow_fuzz_m,
          number(0, 100000,
                 "Height in metres of the zone in which the snow thins out, {from} to {to}.")
              .slider(EditGroup::ground, "Snow thins out over", 0, 1000)),
    field("snow_slope_deg", &Ground::snow_slope_deg,
          number(0, 90,
                 "Two slopes in degrees, {from} to {to}, the smaller one first. Snow covers all "
                 "ground up to the first slope, and none stays on ground steeper than the second.")
              .slider(EditGroup::ground, "Full snow up to", 0, 90)
              .slider(EditGroup::ground, "No snow from", 0, 90)),
    field("beach", &Ground::beach,
          color("Albedo of dry sand at the shore.").control(EditGroup::ground, "Beach")),
    field("beach_top_m", &Ground::beach_top_m,
          number(-1000000, 1000000,
                 "Height above the sea up to which sand lies, in metres, {from} to {to}. The value "
                 "{from} means that there is no beach.")
              .slider(EditGroup::ground, "Beach up to", -50, 50, 1)
              .none("no beach")),
    field("pattern_m", &Ground::pattern_m,
          number(0, 100000,
                 "Largest wavelength of the detail in colour and relief in metres, {from} "
                 "(excluded) to {to}.")
              .above()
              .slider(EditGroup::ground, "Width of patterns", 5, 500, 0, Scale::logarithmic)),
    field("relief", &Ground::relief,
          number(0, 10, "Strength of the detail in the surface normal, {from} (none) to {to}.")
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
                 "Roughness by which grains of snow or sand reflect light back, {from} (Lambert's "
                 "cosine) to {to}. The higher it is, the less the brightness depends on the angle "
                 "to the sun.")
              .slider(EditGroup::ground, "Softness", 0, 1, 2)),
    field("sparkle", &Ground::sparkle,
          number(0, 10,
                 "Strength of the glitter of single grains of snow or sand, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Sparkle", 0, 2, 2)),
    field("forest", &Ground::forest,
          color("Albedo of trees.").control(EditGroup::ground, "Forest")),
    field("forest_top_m", &Ground::forest_top_m,
          number(-100000, 100000, "Height in metres up to which trees grow, {from} to {to}.")
              .slider(EditGroup::ground, "Forest up to", 0, 3000)),
    field("forest_share", &Ground::forest_share,
          number(0, 1,
                 "Share of the ground below forest_top_m that trees cover, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Share of forest", 0, 1, 2)),
    field("canopy_m", &Ground::canopy_m,
          number(0.1, 1000, "Width of the crown of a tree in metres, {from} to {to}.")
              .slider(EditGroup::ground, "Width of crowns", 1, 30, 1)),
    field("field", &Ground::field,
          color("Albedo of ripe corn and stubble on fields.").control(EditGroup::ground, "Fields")),
    field("field_m", &Ground::field_m,
          number(0, 10000, "Width of the fields on gentle ground in metres, {from} (none) to {to}.")
              .slider(EditGroup::ground, "Width of fields", 0, 400)));

template <>
inline constexpr auto kTable<Water> = table(
    "The sea: a plane at the height level_m.",
    field("enabled", &Water::enabled,
          truth("Whether there is a sea.").control(EditGroup::snow_and_water, "Sea")),
    field("level_m", &Water::level_m,
          number(-1000000, 1000000, "Height of the plane in metres, {from} to {to}.")
              .slider(EditGroup::snow_and_water, "Sea level", -200, 1000)),
    field("absorption_per_m", &Water::absorption_per_m,
          number(0, 100,
                 "Absorption per metre of water by the law of Beer and Lambert, for [red, green, "
                 "blue], {from} to {to}.")
              .boxes(EditGroup::sea, "Absorption, 1/m", 3)),
    field("scatter", &Water::scatter,
          color("Colour of deep water.").control(EditGroup::sea, "Deep water")),
    field("bed", &Water::bed,
          color("Albedo of the sand under the water.").control(EditGroup::sea, "Sea bed")),
    field("wave_m", &Water::wave_m,
          number(0, 10000, "Wavelength of the largest waves in metres, {from} (excluded) to {to}.")
              .above()
              .slider(EditGroup::sea, "Longest waves", 1, 200, 1, Scale::logarithmic)),
    field("wave_slope", &Water::wave_slope,
          number(0, 1, "Root mean square of the slope of the waves, {from} (a mirror) to {to}.")
              .slider(EditGroup::sea, "Slope of waves", 0, 0.3, 3)),
    field("time_s", &Water::time_s,
          number(0, 1e6,
                 "Time in seconds at which the waves are seen, {from} to {to}. A film lets it "
                 "pass.")));

template <>
inline constexpr auto kTable<Biome> =
    table("The biome with changes to its ground and sea.",
          field("kind", &Biome::kind,
                word("Kind of landscape, which sets the defaults of terrain, colours, light, sky, "
                     "air and balloons. auto is the same as leaving it out: on a source of "
                     "elevation data the kind is chosen by latitude, height and season, and "
                     "elsewhere it is snow.")
                    .or_left_out(kLeftOutBiome)
                    .control(EditGroup::land, "Biome")),
          field("season", &Biome::season,
                word("Season of a meadow, which sets the defaults of grass, fields and leaves: "
                     "spring, summer (the default) or autumn, in which larches and birches are "
                     "golden. Other biomes have none.")
                    .control(EditGroup::land, "Season")),
          field("ground", &Biome::ground), field("water", &Biome::water));

}  // namespace aerostat::scene::detail

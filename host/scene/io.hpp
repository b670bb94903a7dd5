#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/bad_scene.hpp"
#include "scene/land.hpp"
#include "scene/light.hpp"
#include "scene/picture.hpp"

namespace aerostat::scene {

struct Scene;

/// One option "--set /json/pointer=value". The value is taken as JSON if it is valid JSON, else
/// as a string.
struct Override {
  std::string pointer;
  std::string value;
};

/// Splits "pointer=value" at the first '='. Throws Error{usage} if there is no '=' or if the
/// pointer does not begin with '/'.
Override parse_override(const std::string& text);

/// Where the files may lie that a scene file names. Scenes of strangers should not name files
/// outside of their folder, because these would then be read.
enum class NamedFiles { anywhere, below_the_scene };

/// Reads a scene file (JSON with comments), applies the overrides to it, checks it against the
/// schema and fills in the defaults of its biome and view. Positions stay as given.
/// world::resolve works out heights above ground. Throws Error{io} if the file cannot be read,
/// Error{bad_data} with line and column if it is not JSON, and BadScene with all faults if it is
/// not a scene. With NamedFiles::below_the_scene, a name in the file that is absolute or leads out
/// of the folder of the scene by ".." is a fault. Names in overrides may be any.
Scene read_file(const std::filesystem::path& path, const std::vector<Override>& overrides = {},
                NamedFiles files = NamedFiles::anywhere);

/// Reads a scene from a text, with the same steps and errors as read_file after the file is read.
/// `name` stands for the file in messages.
Scene read_text(const std::string& text, const std::string& name,
                const std::vector<Override>& overrides = {});

/// Returns the scene as JSON with every field, indented by two spaces and ended by a line end.
/// Reading the text gives the same scene, and writing that scene gives the same text.
std::string write_text(const Scene& scene);

/// Returns the defaults of a biome seen from outside or from the basket, at standard quality. A
/// mood changes those of sun, moon, air, clouds and film.
Scene defaults(BiomeKind biome, View view, Mood mood = Mood::none);

/// Sets the ground to that of elevation data, with the defaults that are its own.
void set_elevation(Scene& scene);

/// Sets the season of a meadow and the colours that follow from it. Other biomes keep theirs.
void set_season(Scene& scene, Season season);

/// Sets the scene's quality and the values that follow from it: samples per pixel, the adaptive
/// threshold, soft shadows of the sun and ambient occlusion.
void set_quality(Scene& scene, Quality quality);

/// Sets the droplets that usual haze has at a visibility. Below 6 km, droplets are swollen with
/// water, down to the size of fog droplets. `angstrom` is then limited to the value q of I. I.
/// Kim et al. (Proc. SPIE 4214, 2001), where V is the visibility in kilometres:
///   q = 0.16 V + 0.34  for 1 < V < 6
///   q = V - 0.5        for 0.5 < V <= 1
///   q = 0              for V <= 0.5
/// The absorbing matter does not grow with the droplets, so that 1 - `albedo` falls in proportion
/// to the visibility. `haze.visibility_m` stays as it is.
void set_haze_droplets(Haze& haze, double visibility_m);

}  // namespace aerostat::scene

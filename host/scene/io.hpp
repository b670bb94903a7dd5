#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/bad_scene.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {

/// One "--set /json/pointer=value": the value is JSON, or else taken as a string.
struct Override {
  std::string pointer;
  std::string value;
};

/// "pointer=value" in two. Throws Error{usage} if there is no '=' or the pointer has no leading
/// '/'.
Override parse_override(const std::string& text);

/// Reads a scene file (JSON with comments), applies the overrides to it, checks it against the
/// schema and fills in the defaults of its biome and view. Positions stay as given (see
/// world::resolve for heights above ground). Throws Error{io} if it cannot be read, Error{bad_data}
/// with line and column if it is no JSON, BadScene with all that is wrong if it is no scene.
Scene read_file(const std::filesystem::path& path, const std::vector<Override>& overrides = {});

/// The same from text; `name` stands for the file in messages.
Scene read_text(const std::string& text, const std::string& name,
                const std::vector<Override>& overrides = {});

/// The scene as JSON with every field, two-space indent, a line end at the end. Reading it back
/// gives the same scene; writing that gives the same text.
std::string write_text(const Scene& scene);

/// The defaults of a biome seen from outside or from the basket, at standard quality.
Scene defaults(BiomeKind biome, View view);

/// Sets the scene's quality and what follows from it: samples per pixel, soft shadows of the sun
/// and ambient occlusion.
void set_quality(Scene& scene, Quality quality);

/// What usual haze is made of at a visibility: below 6 km its droplets are swollen with water, down
/// to those of fog. `angstrom` is then at most what I. I. Kim et al. found (Proc. SPIE 4214, 2001):
/// 0.16 km^-1 V + 0.34 to 1 km, V - 0.5 km to 500 m, 0 below; and as what absorbs becomes no more,
/// 1 - `albedo` falls with the visibility. The visibility of `haze` itself stays as it is.
void set_haze_droplets(Haze& haze, double visibility_m);

}  // namespace aerostat::scene

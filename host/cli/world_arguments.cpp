#include "cli/world_arguments.hpp"

#include <cstdint>

#include <CLI/CLI.hpp>

#include "cli/validators.hpp"
#include "scene/balloon.hpp"

namespace aerostat::cli {
namespace {

constexpr std::int64_t kMostTriangles = 0x7fffffff;

}  // namespace

void add_export_options(CLI::App* command, ExportOptions& options) {
  command
      ->add_option(
          "-o,--output", options.output,
          "x.ply (binary; normals, colours, object ids of faces), x.obj and beside it x.mtl "
          "with the materials, x.glb, x.gltf and beside it x.bin (glTF 2.0; materials with "
          "textures, instances that share meshes), or - for standard output")
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--format", options.format,
          "File format, ply, obj, glb or gltf; by default the one that the name ends in, ply "
          "for -o -")
      ->check(one_of({"ply", "obj", "glb", "gltf"}))
      ->type_name("F");
  command
      ->add_option("--plants", options.plants,
                   "none (by default), seen (those that a picture can show or whose shade it can "
                   "show) or all within /vegetation/reach_m")
      ->check(one_of({"none", "seen", "all"}))
      ->type_name("WHICH");
  command
      ->add_option("--most-triangles", options.most_triangles,
                   "Write nothing if the world has more triangles; by default 20000000, for which "
                   "some 4 GiB of memory are needed")
      ->transform(in_range(1, kMostTriangles))
      ->type_name("N");
}

void add_artwork_options(CLI::App* command, ArtworkOptions& options) {
  command
      ->add_option("SCENE", options.input.scene,
                   "Scene whose balloon is unrolled; by default a balloon with all defaults")
      ->type_name("");
  command
      ->add_flag("--template", options.is_template,
                 "Draw the unrolled gores with their seams and heights, to draw on")
      ->required();
  command
      ->add_option("--balloon", options.balloon,
                   "Which balloon of the scene, 0 (/balloon, by default) to 32 (the last one of "
                   "/balloons)")
      ->transform(in_range(0, scene::kMostFurtherBalloons))
      ->type_name("N");
  command->add_option("-o,--output", options.output, "An .svg file, or - for standard output")
      ->required()
      ->type_name("FILE");
}

}  // namespace aerostat::cli

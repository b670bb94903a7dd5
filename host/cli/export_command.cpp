#include <memory>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/parse.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "mesh/export.hpp"
#include "scene/local_frame.hpp"
#include "world/exported.hpp"
#include "world/world.hpp"

namespace aerostat::cli {
namespace {

/// The triangles of a world, and the models that some of them are of.
struct WorldTriangles {
  world::Objects objects;
  std::shared_ptr<const world::SceneModels> models;
};

/// Returns the triangles of the world that pictures of the scene show. Throws Error{exhausted} if
/// there are more than the options allow.
WorldTriangles triangles_of(const scene::ResolvedScene& scene, const ExportOptions& options,
                            world::ReliefCache& reliefs) {
  const auto where =
      options.plants == "all" ? scatter::Where::everywhere : scatter::Where::in_sight;
  const auto placed = options.plants == "none" ? world::Placed::left_out : world::Placed::included;
  const world::World world = world::build(scene, {.where = where, .reliefs = &reliefs});
  const std::uint64_t count = world::count_triangles(world, placed);
  if (count > options.most_triangles) {
    throw Error(ErrorKind::exhausted,
                fmt::format("the world has {} triangles, and at most {} may be written; "
                            "--most-triangles allows more, and --plants none leaves out plants",
                            count, options.most_triangles));
  }
  return {world::as_triangles(world, placed), world.models};
}

void write_obj(const std::filesystem::path& output, const ExportOptions& options,
               std::span<const mesh::ExportObject> objects, const dvec3& origin) {
  if (is_standard(options.output) || is_special_file(output)) {
    write_file(output, mesh::obj_bytes(objects, origin));
    return;
  }
  std::filesystem::path library = output;
  library = output_file(library.replace_extension(".mtl"), options.input, false);
  write_file(library, mesh::mtl_bytes(objects));
  write_file(output, mesh::obj_bytes(objects, origin, library.filename().string()));
}

}  // namespace

int export_world(const ExportOptions& options) {
  const MeshFormat format = mesh_format(options.output, options.format);
  const std::filesystem::path output =
      output_file(options.output, options.input, format == MeshFormat::ply);
  world::ReliefCache reliefs;
  const scene::ResolvedScene loaded = load_scene(options.input, reliefs);
  const scene::ResolvedScene scene = loaded.counted_from(scene::origin_for_export(loaded));
  WorldTriangles triangles = triangles_of(scene, options, reliefs);
  const std::vector<mesh::ExportObject> objects =
      world::exported_objects(triangles.objects, *scene, *triangles.models);
  if (format == MeshFormat::ply) {
    write_file(output, mesh::ply_bytes(objects, scene.origin()));
  } else {
    write_obj(output, options, objects, scene.origin());
  }
  return 0;
}

}  // namespace aerostat::cli

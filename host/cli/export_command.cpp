#include "cli/commands.hpp"
#include "cli/parse.hpp"
#include "cli/scene_input.hpp"
#include "core/file.hpp"
#include "mesh/export.hpp"
#include "scene/local_frame.hpp"
#include "world/world.hpp"

namespace aerostat::cli {

int export_world(const ExportOptions& options) {
  const MeshFormat format = mesh_format(options.output, options.format);
  const std::filesystem::path output =
      output_file(options.output, options.input, format == MeshFormat::ply);
  world::ReliefCache reliefs;
  const scene::ResolvedScene loaded = load_scene(options.input, reliefs);
  const scene::ResolvedScene scene = loaded.counted_from(scene::origin_for_export(loaded));
  const world::World world = world::build(scene, {.reliefs = &reliefs});
  const world::Objects triangles = world::as_triangles(
      world, options.plants ? world::Placed::included : world::Placed::left_out);
  std::vector<mesh::ExportObject> objects;
  for (const world::Object& object : triangles) {
    objects.push_back(
        {static_cast<std::uint32_t>(object.id), scene::object_name(object.id), &object.mesh});
  }
  const auto file = format == MeshFormat::ply ? mesh::ply_bytes(objects, scene.origin())
                                              : mesh::obj_bytes(objects, scene.origin());
  write_file(output, file);
  return 0;
}

}  // namespace aerostat::cli

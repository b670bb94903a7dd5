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
  scene::Scene scene = load_scene(options.input);
  scene.origin = scene::origin_for_export(scene);
  const world::Objects world = world::as_triangles(
      world::build(scene), options.plants ? world::Placed::included : world::Placed::left_out);
  std::vector<mesh::ExportObject> objects;
  for (const world::Object& object : world) {
    objects.push_back(
        {static_cast<std::uint32_t>(object.id), scene::object_name(object.id), &object.mesh});
  }
  const auto file = format == MeshFormat::ply ? mesh::ply_bytes(objects, scene.origin)
                                              : mesh::obj_bytes(objects, scene.origin);
  write_file(output, file);
  return 0;
}

}  // namespace aerostat::cli

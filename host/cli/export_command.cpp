#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "asset/write_gltf.hpp"
#include "cli/commands.hpp"
#include "cli/parse.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "mesh/export.hpp"
#include "render/cloths.hpp"
#include "scene/local_frame.hpp"
#include "world/exported.hpp"
#include "world/exported_model.hpp"
#include "world/world.hpp"

namespace aerostat::cli {
namespace {

/// Which of the instances of a world are written.
world::Placed placed_of(const ExportOptions& options) {
  return options.plants == "none" ? world::Placed::left_out : world::Placed::included;
}

/// Returns the world that pictures of the scene show.
world::World world_of(const scene::ResolvedScene& scene, const ExportOptions& options,
                      world::ReliefCache& reliefs) {
  const auto where =
      options.plants == "all" ? scatter::Where::everywhere : scatter::Where::in_sight;
  return world::build(scene, {.where = where, .reliefs = &reliefs});
}

/// Throws Error{exhausted} if there are more triangles than the options allow.
void require_few(std::uint64_t count, const ExportOptions& options) {
  if (count <= options.most_triangles) return;
  throw Error(ErrorKind::exhausted,
              fmt::format("the world has {} triangles, and at most {} may be written; "
                          "--most-triangles allows more, and --plants none leaves out plants",
                          count, options.most_triangles));
}

bool is_stream(const std::filesystem::path& output, const ExportOptions& options) {
  return is_standard(options.output) || is_special_file(output);
}

/// Writes a file beside another one, before that one, which refers to it.
void write_beside(const std::filesystem::path& beside, const ExportOptions& options,
                  std::span<const std::uint8_t> bytes) {
  write_file(output_file(beside, options.input, false), bytes);
}

void write_obj(const std::filesystem::path& output, const ExportOptions& options,
               std::span<const mesh::ExportObject> objects, const dvec3& origin) {
  if (is_stream(output, options)) {
    write_file(output, mesh::obj_bytes(objects, origin));
    return;
  }
  std::filesystem::path library = output;
  library.replace_extension(".mtl");
  write_beside(library, options, mesh::mtl_bytes(objects));
  write_file(output, mesh::obj_bytes(objects, origin, library.filename().string()));
}

/// Writes PLY or OBJ, in which all triangles stand where they are.
void write_triangles(const std::filesystem::path& output, const ExportOptions& options,
                     MeshFormat format, const world::World& world) {
  require_few(world::count_triangles(world, placed_of(options)), options);
  world::Objects triangles = world::as_triangles(world, placed_of(options));
  const scene::ResolvedScene& scene = world.scene;
  const std::vector<mesh::ExportObject> objects =
      world::exported_objects(triangles, *scene, *world.models);
  if (format == MeshFormat::ply) {
    write_file(output, mesh::ply_bytes(objects, scene.origin()));
  } else {
    write_obj(output, options, objects, scene.origin());
  }
}

/// Writes glTF, in which instances share their meshes.
void write_gltf(const std::filesystem::path& output, const ExportOptions& options,
                MeshFormat format, const world::World& world) {
  require_few(world::count_model_triangles(world, placed_of(options)), options);
  const std::vector<asset::Texture> cloths = render::cloths_of(*world.scene);
  const asset::Model model = world::exported_model(world, placed_of(options), cloths);
  if (format == MeshFormat::glb) {
    write_file(output, asset::glb_bytes(model));
    return;
  }
  std::filesystem::path binary = output;
  binary.replace_extension(".bin");
  const asset::GltfParts parts = asset::gltf_parts(model, binary.filename().string());
  write_beside(binary, options, parts.binary);
  write_file(output, {reinterpret_cast<const std::uint8_t*>(parts.json.data()), parts.json.size()});
}

}  // namespace

int export_world(const ExportOptions& options) {
  const MeshFormat format = mesh_format(options.output, options.format);
  const bool is_binary = format == MeshFormat::ply || format == MeshFormat::glb;
  const std::filesystem::path output = output_file(options.output, options.input, is_binary);
  if (format == MeshFormat::gltf && is_stream(output, options)) {
    throw Error(ErrorKind::usage,
                "--format: gltf has two files, and standard output takes one; expected glb");
  }
  world::ReliefCache reliefs;
  const scene::ResolvedScene loaded = load_scene(options.input, reliefs);
  const scene::ResolvedScene scene = loaded.counted_from(scene::origin_for_export(loaded));
  const world::World world = world_of(scene, options, reliefs);
  const bool is_gltf = format == MeshFormat::glb || format == MeshFormat::gltf;
  (is_gltf ? write_gltf : write_triangles)(output, options, format, world);
  return 0;
}

}  // namespace aerostat::cli

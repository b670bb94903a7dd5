#include "pack/pack_geometry.hpp"

#include <utility>
#include <variant>

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include "bvh/grid.hpp"
#include "core/copy.hpp"
#include "core/error.hpp"
#include "material.h"
#include "pack/pack_instances.hpp"

namespace aerostat::pack {
namespace {

/// The object of a triangle, and the numbers of its balloon and its material (see AeroFace).
struct Owner {
  std::uint32_t object, material;
};

Owner owner_of(const world::Object& object, std::uint32_t first_file_material) {
  const auto balloon = static_cast<std::uint32_t>(object.balloon);
  const std::uint32_t material =
      object.file_material ? AERO_FIXED_MATERIALS + first_file_material + *object.file_material
                           : static_cast<std::uint32_t>(object.material);
  return {static_cast<std::uint32_t>(object.id), material | balloon << AERO_FACE_BALLOON_SHIFT};
}

/// Several meshes as one, with the owner of each triangle.
struct Soup {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
  std::vector<Owner> owners;
};

Soup merge(const world::Objects& objects, std::uint32_t first_file_material) {
  Soup soup;
  for (const world::Object& object : objects) {
    const auto& mesh = object.mesh;
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& triangle : mesh.triangles) soup.triangles.push_back(triangle + base);
    soup.owners.resize(soup.triangles.size(), owner_of(object, first_file_material));
  }
  return soup;
}

void add_vertices(const mesh::TriangleMesh& mesh, Array<AeroVertex>& vertices) {
  const std::size_t base = vertices.size();
  vertices.resize(base + mesh.positions.size());
  tbb::parallel_for(std::size_t{0}, mesh.positions.size(), [&](std::size_t i) {
    AeroVertex& vertex = vertices[base + i];
    copy(vertex.position, mesh.positions[i]);
    copy(vertex.normal, mesh.normals[i]);
    copy(vertex.color, mesh.colors.empty() ? vec3(1.0f) : mesh.colors[i]);
    const vec2 uv = mesh.uvs.empty() ? vec2(0.0f) : mesh.uvs[i];
    vertex.uv[0] = uv.x;
    vertex.uv[1] = uv.y;
  });
}

/// The triangles and faces of a soup, in the order of its tree's leaves.
void add_triangles(const Soup& soup, const std::vector<std::uint32_t>& order,
                   PackedArrays& arrays) {
  arrays.triangles.resize(order.size());
  arrays.faces.resize(order.size());
  tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t slot) {
    const uvec3 triangle = soup.triangles[order[slot]];
    AeroTriangle& out = arrays.triangles[slot];
    copy(out.v0, soup.positions[triangle.x]);
    copy(out.v1, soup.positions[triangle.y]);
    copy(out.v2, soup.positions[triangle.z]);
    const Owner& owner = soup.owners[order[slot]];
    arrays.faces[slot] = {{triangle.x, triangle.y, triangle.z}, owner.object, owner.material};
  });
}

Room room_of(const world::Objects& objects) {
  Room room;
  for (const world::Object& object : objects) {
    room += {object.mesh.triangles.size(), object.mesh.positions.size()};
  }
  return room;
}

/// Packs what a shape is.
struct ShapePacker {
  const Room& more;

  Packed operator()(const world::Objects& objects) const { return pack_objects(objects, more); }

  Packed operator()(const world::HeightGrid& grid) const {
    Packed packed;
    packed.group.trees.push_back(bvh::build_grid(*grid.mesh));
    packed.group.grid = grid.mesh;
    return packed;
  }

  Packed operator()(const world::Instances& instances) const {
    return pack_instances(instances, more);
  }
};

}  // namespace

Packed pack_objects(const world::Objects& objects, const Room& more,
                    std::uint32_t first_file_material) {
  Packed packed;
  if (objects.empty()) return packed;
  Room room = more;
  room += room_of(objects);
  reserve(packed.arrays, room);
  for (const world::Object& object : objects) {
    mesh::check(object.mesh, scene::object_name(object.id).c_str());
    add_vertices(object.mesh, packed.arrays.vertices);
  }
  const Soup soup = merge(objects, first_file_material);
  bvh::Bvh tree = bvh::build(soup.positions, soup.triangles);
  add_triangles(soup, tree.order, packed.arrays);
  tree.order = {};
  packed.group.trees.push_back(std::move(tree));
  packed.group.room = room_of(packed.arrays);
  return packed;
}

Room room_of(const PackedArrays& arrays) {
  return {arrays.triangles.size(), arrays.vertices.size()};
}

void reserve(PackedArrays& arrays, const Room& room) {
  arrays.triangles.reserve(room.triangles);
  arrays.faces.reserve(room.triangles);
  arrays.vertices.reserve(room.vertices);
}

Packed pack_shape(const world::Shape& shape, const Room& more) {
  return std::visit(ShapePacker{more}, shape);
}

void append(PackedArrays& whole, const PackedArrays& part) {
  const auto first_vertex = static_cast<std::uint32_t>(whole.vertices.size());
  whole.triangles.insert(whole.triangles.end(), part.triangles.begin(), part.triangles.end());
  whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (AeroFace face : part.faces) {
    for (auto& vertex : face.vertex) vertex += first_vertex;
    whole.faces.push_back(face);
  }
}

bvh::JoinedBvh join_trees(const std::vector<std::shared_ptr<const PackedGroup>>& groups) {
  std::vector<bvh::Part> parts;
  std::uint32_t instances = 0;
  int grids = 0;
  for (const auto& group : groups) {
    for (const bvh::Bvh& tree : group->trees) parts.push_back({&tree, false, 0, instances});
    for (const bvh::Bvh& model : group->models) parts.push_back({&model, true});
    instances += static_cast<std::uint32_t>(group->instances.size());
    grids += group->grid != nullptr ? 1 : 0;
  }
  if (grids > 1) {
    throw Error(
        ErrorKind::internal,
        fmt::format("packing the world: {} groups have a height grid, at most 1 can", grids));
  }
  return bvh::join(parts);
}

std::vector<AeroInstance> join_instances(
    const std::vector<std::shared_ptr<const PackedGroup>>& groups, const bvh::JoinedBvh& tree) {
  std::vector<AeroInstance> instances;
  std::size_t count = 0, first_model = 0;
  for (const auto& group : groups) count += group->instances.size();
  instances.reserve(count);
  for (const auto& group : groups) {
    for (AeroInstance instance : group->instances) {
      instance.root = tree.model_roots[first_model + instance.root];
      instances.push_back(instance);
    }
    first_model += group->models.size();
  }
  return instances;
}

}  // namespace aerostat::pack

#include "pack/pack_geometry.hpp"

#include <algorithm>

#include <oneapi/tbb/parallel_for.h>

#include "bvh/grid.hpp"

namespace aerostat::pack {
namespace {

using Objects = std::vector<const world::Object*>;

/// Several meshes as one, with the object of each triangle.
struct Soup {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
  std::vector<std::uint32_t> objects;
};

Soup merge(const Objects& objects) {
  Soup soup;
  for (const world::Object* object : objects) {
    const auto& mesh = object->mesh;
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& triangle : mesh.triangles) soup.triangles.push_back(triangle + base);
    soup.objects.resize(soup.triangles.size(), static_cast<std::uint32_t>(object->id));
  }
  return soup;
}

void copy(float (&to)[3], const vec3& from) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

void add_vertices(const mesh::TriangleMesh& mesh, Array<AeroVertex>& vertices) {
  const std::size_t base = vertices.size();
  vertices.resize(base + mesh.positions.size());
  tbb::parallel_for(std::size_t{0}, mesh.positions.size(), [&](std::size_t i) {
    AeroVertex& vertex = vertices[base + i];
    copy(vertex.position, mesh.positions[i]);
    copy(vertex.normal, mesh.normals[i]);
    copy(vertex.color, mesh.colors.empty() ? vec3(1.0f) : mesh.colors[i]);
  });
}

/// Adds a tree and what its leaves hold; object_of(triangle) tells what a triangle belongs to.
template <typename ObjectOf>
void add_tree(bvh::Bvh tree, std::span<const vec3> positions, std::span<const uvec3> triangles,
              std::uint32_t first_vertex, const ObjectOf& object_of, PackedGroup& group) {
  const auto& order = tree.order;
  auto& arrays = group.arrays;
  const std::size_t base = arrays.triangles.size();
  arrays.triangles.resize(base + order.size());
  arrays.faces.resize(base + order.size());
  tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t slot) {
    const uvec3 triangle = triangles[order[slot]];
    AeroTriangle& out = arrays.triangles[base + slot];
    copy(out.v0, positions[triangle.x]);
    copy(out.v1, positions[triangle.y]);
    copy(out.v2, positions[triangle.z]);
    const uvec3 vertex = triangle + first_vertex;
    arrays.faces[base + slot] = {{vertex.x, vertex.y, vertex.z}, object_of(order[slot])};
  });
  tree.order = {};
  group.trees.push_back(std::move(tree));
}

void add_grid(const world::Object& object, PackedGroup& group) {
  const auto& mesh = object.mesh;
  const auto first_vertex = static_cast<std::uint32_t>(group.arrays.vertices.size());
  add_vertices(mesh, group.arrays.vertices);
  add_tree(
      bvh::build_grid(mesh.positions, mesh.triangles, object.grid_cells, object.grid_cells),
      mesh.positions, mesh.triangles, first_vertex,
      [id = static_cast<std::uint32_t>(object.id)](std::uint32_t) { return id; }, group);
}

void add_soup(const Objects& objects, PackedGroup& group) {
  if (objects.empty()) return;
  const Soup soup = merge(objects);
  const auto first_vertex = static_cast<std::uint32_t>(group.arrays.vertices.size());
  for (const world::Object* object : objects) add_vertices(object->mesh, group.arrays.vertices);
  add_tree(
      bvh::build(soup.positions, soup.triangles), soup.positions, soup.triangles, first_vertex,
      [&soup](std::uint32_t triangle) { return soup.objects[triangle]; }, group);
}

void reserve(const std::vector<world::Object>& objects, const PackedArrays& room,
             PackedArrays& arrays) {
  std::size_t triangles = room.triangles.size(), vertices = room.vertices.size();
  for (const auto& object : objects) {
    triangles += object.mesh.triangles.size();
    vertices += object.mesh.positions.size();
  }
  arrays.triangles.reserve(triangles);
  arrays.faces.reserve(triangles);
  arrays.vertices.reserve(vertices);
}

}  // namespace

PackedGroup pack_group(const std::vector<world::Object>& objects, const PackedArrays& room) {
  PackedGroup group;
  reserve(objects, room, group.arrays);
  Objects others;
  for (const auto& object : objects) {
    mesh::check(object.mesh, scene::object_name(object.id).c_str());
    if (object.grid_cells > 0) {
      add_grid(object, group);
    } else {
      others.push_back(&object);
    }
  }
  add_soup(others, group);
  return group;
}

void append(PackedArrays& whole, const PackedArrays& part) {
  const auto first_vertex = static_cast<std::uint32_t>(whole.vertices.size());
  whole.triangles.insert(whole.triangles.end(), part.triangles.begin(), part.triangles.end());
  whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
  whole.faces.reserve(whole.faces.size() + part.faces.size());
  for (AeroFace face : part.faces) {
    for (auto& vertex : face.vertex) vertex += first_vertex;
    whole.faces.push_back(face);
  }
}

bvh::Bvh join_trees(const std::vector<const PackedGroup*>& groups) {
  std::vector<const bvh::Bvh*> trees;
  for (const PackedGroup* group : groups) {
    if (group == nullptr) continue;
    for (const bvh::Bvh& tree : group->trees) trees.push_back(&tree);
  }
  return bvh::join(trees, std::vector<std::uint32_t>(trees.size(), 0));
}

}  // namespace aerostat::pack

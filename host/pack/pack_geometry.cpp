#include "pack/pack_geometry.hpp"

#include <algorithm>

#include <oneapi/tbb/parallel_for.h>

#include "bvh/grid.hpp"
#include "mesh/grid_mesh.hpp"
#include "pack/copy.hpp"
#include "pack/pack_plants.hpp"

namespace aerostat::pack {
namespace {

/// What a triangle belongs to and is made of.
struct Owner {
  std::uint32_t object, material;
};

/// Several meshes as one, with the owner of each triangle.
struct Soup {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
  std::vector<Owner> owners;
};

Soup merge(const world::Objects& objects) {
  Soup soup;
  for (const world::Object& object : objects) {
    const auto& mesh = object.mesh;
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& triangle : mesh.triangles) soup.triangles.push_back(triangle + base);
    soup.owners.resize(soup.triangles.size(), {static_cast<std::uint32_t>(object.id),
                                               static_cast<std::uint32_t>(object.material)});
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

/// Adds the tree of a soup and what its leaves hold.
void add_tree(bvh::Bvh tree, const Soup& soup, PackedGroup& group) {
  const auto& order = tree.order;
  auto& arrays = group.arrays;
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
  tree.order = {};
  group.trees.push_back(std::move(tree));
}

void add_objects(const world::Objects& objects, PackedGroup& group) {
  if (objects.empty()) return;
  for (const world::Object& object : objects) {
    mesh::check(object.mesh, scene::object_name(object.id).c_str());
    add_vertices(object.mesh, group.arrays.vertices);
  }
  const Soup soup = merge(objects);
  add_tree(bvh::build(soup.positions, soup.triangles), soup, group);
}

void reserve(const world::Objects& objects, const Room& room, PackedArrays& arrays) {
  std::size_t triangles = room.triangles, vertices = room.vertices;
  for (const auto& object : objects) {
    triangles += object.mesh.triangles.size();
    vertices += object.mesh.positions.size();
  }
  arrays.triangles.reserve(triangles);
  arrays.faces.reserve(triangles);
  arrays.vertices.reserve(vertices);
}

}  // namespace

PackedGroup pack_objects(const world::Objects& objects) {
  PackedGroup group;
  add_objects(objects, group);
  return group;
}

PackedGroup pack_land(const world::Land& land, const Room& room) {
  PackedGroup group;
  group.trees.push_back(bvh::build_grid(*land.ground));
  reserve(land.objects, room, group.arrays);
  add_objects(land.objects, group);
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

bvh::JoinedBvh join_trees(const std::vector<const PackedGroup*>& groups,
                          const PackedPlants* plants) {
  std::vector<const bvh::Bvh*> trees, models;
  for (const PackedGroup* group : groups) {
    if (group == nullptr) continue;
    for (const bvh::Bvh& tree : group->trees) trees.push_back(&tree);
  }
  if (plants != nullptr) {
    trees.push_back(&plants->tree);
    for (const bvh::Bvh& model : plants->models) models.push_back(&model);
  }
  return bvh::join(trees, std::vector<std::uint32_t>(trees.size(), 0), models);
}

}  // namespace aerostat::pack

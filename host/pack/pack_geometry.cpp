#include "pack/pack_geometry.hpp"

#include <oneapi/tbb/parallel_for.h>

namespace aerostat::pack {
namespace {

/// The meshes of a group as one, with the object of each triangle.
struct Soup {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
  std::vector<std::uint32_t> objects;
};

Soup merge(const std::vector<world::Object>& objects) {
  Soup soup;
  for (const auto& object : objects) {
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), object.mesh.positions.begin(),
                          object.mesh.positions.end());
    soup.triangles.reserve(soup.triangles.size() + object.mesh.triangles.size());
    for (const auto& triangle : object.mesh.triangles) soup.triangles.push_back(triangle + base);
    soup.objects.resize(soup.triangles.size(), static_cast<std::uint32_t>(object.id));
  }
  return soup;
}

void copy(float (&to)[3], const vec3& from) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

std::vector<AeroVertex> pack_vertices(const std::vector<world::Object>& objects) {
  std::size_t count = 0;
  for (const auto& object : objects) count += object.mesh.positions.size();
  std::vector<AeroVertex> vertices(count);
  std::size_t base = 0;
  for (const auto& object : objects) {
    const auto& mesh = object.mesh;
    tbb::parallel_for(std::size_t{0}, mesh.positions.size(), [&](std::size_t i) {
      AeroVertex& vertex = vertices[base + i];
      copy(vertex.position, mesh.positions[i]);
      copy(vertex.normal, mesh.normals[i]);
      copy(vertex.color, mesh.colors.empty() ? vec3(1.0f) : mesh.colors[i]);
    });
    base += mesh.positions.size();
  }
  return vertices;
}

}  // namespace

std::uint64_t PackedGroup::bytes() const {
  return tree.nodes.size() * sizeof(AeroBvhNode) + triangles.size() * sizeof(AeroTriangle) +
         faces.size() * sizeof(AeroFace) + vertices.size() * sizeof(AeroVertex);
}

PackedGroup pack_group(const std::vector<world::Object>& objects) {
  for (const auto& object : objects) {
    mesh::check(object.mesh, scene::object_name(object.id).c_str());
  }
  const Soup soup = merge(objects);
  PackedGroup group;
  group.tree = bvh::build(soup.positions, soup.triangles);
  const auto& order = group.tree.order;
  group.triangles.resize(order.size());
  group.faces.resize(order.size());
  tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t slot) {
    const uvec3 triangle = soup.triangles[order[slot]];
    copy(group.triangles[slot].v0, soup.positions[triangle.x]);
    copy(group.triangles[slot].v1, soup.positions[triangle.y]);
    copy(group.triangles[slot].v2, soup.positions[triangle.z]);
    group.faces[slot] = {{triangle.x, triangle.y, triangle.z}, soup.objects[order[slot]]};
  });
  group.vertices = pack_vertices(objects);
  return group;
}

PackedGeometry join_groups(const std::vector<const PackedGroup*>& groups) {
  PackedGeometry all;
  std::vector<const bvh::Bvh*> trees;
  std::vector<std::uint32_t> first_triangle;
  for (const PackedGroup* group : groups) {
    if (group == nullptr || group->triangles.empty()) continue;
    trees.push_back(&group->tree);
    first_triangle.push_back(static_cast<std::uint32_t>(all.triangles.size()));
    const auto base = static_cast<std::uint32_t>(all.vertices.size());
    all.triangles.insert(all.triangles.end(), group->triangles.begin(), group->triangles.end());
    all.vertices.insert(all.vertices.end(), group->vertices.begin(), group->vertices.end());
    all.faces.reserve(all.triangles.size());
    for (AeroFace face : group->faces) {
      for (auto& vertex : face.vertex) vertex += base;
      all.faces.push_back(face);
    }
  }
  bvh::Bvh joined = bvh::join(trees, first_triangle);
  all.nodes = std::move(joined.nodes);
  all.tree = joined.stats;
  return all;
}

}  // namespace aerostat::pack

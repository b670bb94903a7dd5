#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

/// These functions write meshes in file formats of other programs. They return the bytes of a
/// file and do not touch the disk.
namespace aerostat::mesh {

/// One object of an exported world. The mesh must outlive the call.
struct ExportObject {
  std::uint32_t id = 0;
  std::string name;  // has no white space
  const TriangleMesh* mesh = nullptr;
  std::string material = {};  // has no white space; empty: the object has no material
  vec3 color{1.0f};           // a factor on the colours of the mesh, linear Rec. 709
};

/// Returns the bytes of a binary little-endian PLY file.
///
/// Vertices have `x y z nx ny nz` (float). If any object has another colour than white, they also
/// have the colour twice: as `red green blue` (uchar, sRGB-encoded), which programs show, and as
/// `r g b` (float, linear Rec. 709), which is exact. Faces have `vertex_indices` (uchar count, int)
/// and `object_id` (uint). Objects follow each other in the given order, and so do their vertices
/// and triangles. Positions count from `origin`. If that is not null, a comment of the file names
/// it, because single precision could not hold the sums.
///
/// Throws Error{internal} on an inconsistent mesh (see check) or on more than 2^31 - 1 vertices.
std::vector<std::uint8_t> ply_bytes(std::span<const ExportObject> objects,
                                    const dvec3& origin = dvec3(0.0));

/// Returns the bytes of a Wavefront OBJ file. Each object has an `o` line with its name and, if it
/// has a material, a `usemtl` line. Its `v` and `vn` lines have decimals that read back as the same
/// floats. If any object has another colour than white, `v` lines go on with three numbers, the
/// linear colour, which many programs read. Its `f a//a b//b c//c` lines have indices that count
/// through the whole file. If `library` is not empty, an `mtllib` line names it. Positions count
/// from `origin`, which a comment names if it is not null. Throws the errors of ply_bytes.
std::vector<std::uint8_t> obj_bytes(std::span<const ExportObject> objects,
                                    const dvec3& origin = dvec3(0.0),
                                    const std::string& library = {});

/// Returns the bytes of the material library (MTL) for an OBJ file. Each material has a `Kd` line
/// with the mean colour, by area, of the objects that have it.
std::vector<std::uint8_t> mtl_bytes(std::span<const ExportObject> objects);

/// Returns whether an object has another colour than white.
bool is_colored(const ExportObject& object);

/// Returns the colour of a vertex of an object.
vec3 vertex_color(const ExportObject& object, std::size_t vertex);

/// Returns the text of the comment about the origin: "origin X Y Z" with the shortest decimals
/// that read back as the same doubles. Returns an empty text for a null vector.
std::string origin_text(const dvec3& origin);

}  // namespace aerostat::mesh

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

/// Meshes as files for other programs. The functions return a file's bytes and touch no disk.
namespace aerostat::mesh {

/// One object of an exported world. The mesh must outlive the call.
struct ExportObject {
  std::uint32_t id = 0;
  std::string name;  // no white space
  const TriangleMesh* mesh = nullptr;
};

/// `origin` is what positions count from; if it is not null, a comment of the file says so: single
/// precision would not hold their sum.
///
/// Binary little-endian PLY: vertices with `x y z nx ny nz` (float) and, if any object has colours,
/// `red green blue` (uchar, sRGB-encoded, white where an object has none); faces with
/// `vertex_indices` (uchar count, int) and `object_id` (uint). Objects follow each other in the
/// given order, so do their vertices and triangles. Throws Error{internal} on an inconsistent mesh
/// (see check) or more than 2^31 - 1 vertices.
std::vector<std::uint8_t> ply_bytes(std::span<const ExportObject> objects,
                                    const dvec3& origin = dvec3(0.0));

/// Wavefront OBJ: per object an `o` line with its name, `v` and `vn` lines whose decimals read back
/// as the same floats, `f a//a b//b c//c` lines with indices counted through the whole file.
/// Colours are left out, the format has none. Throws as ply_bytes does.
std::vector<std::uint8_t> obj_bytes(std::span<const ExportObject> objects,
                                    const dvec3& origin = dvec3(0.0));

/// What the comment says: "origin X Y Z", shortest decimals that read back as the same doubles;
/// empty for a null vector.
std::string origin_text(const dvec3& origin);

}  // namespace aerostat::mesh

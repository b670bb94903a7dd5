#pragma once

#include <array>
#include <vector>

#include "core/math.hpp"

namespace aerostat::model {

/// A corner of a piece of fabric before it is cut along the pattern.
struct CutVertex {
  vec3 position{0.0f};
  vec3 normal{0.0f};
  /// The texture coordinates, as in mesh::TriangleMesh::uvs.
  vec2 uv{0.0f};
  double phase = 0.0;
};

/// A convex piece whose phases lie between `band` and `band` + 1. It is wound like the triangle
/// that it was cut from.
struct CutPiece {
  int band = 0;
  std::vector<CutVertex> corners;
};

/// Rounds a phase to a multiple of 2^-20, so that whole turns can be added exactly. A phase within
/// half a percent of a whole number becomes that number, so that no cut leaves a sliver.
double quantized_phase(double phase);

/// Returns whether one band holds all three phases, and stores this band.
bool lies_in_one_band(const std::array<CutVertex, 3>& triangle, int& band);

/// Cuts a triangle where its phase passes whole numbers. The phase is taken as linear. Two
/// triangles that share an edge cut it at exactly the same points.
std::vector<CutPiece> cut_by_phase(const std::array<CutVertex, 3>& triangle);

}  // namespace aerostat::model

#pragma once

#include <array>
#include <vector>

#include "core/math.hpp"

namespace aerostat::model {

/// A corner of a piece of fabric before it is cut along the pattern.
struct CutVertex {
  vec3 position{0.0f};
  vec3 normal{0.0f};
  vec2 place{0.0f};  // mesh::TriangleMesh::places
  double phase = 0.0;
};

/// A convex piece, wound as the triangle it comes from, whose phases lie between `band` and
/// `band` + 1.
struct CutPiece {
  int band = 0;
  std::vector<CutVertex> corners;
};

/// A phase rounded to a multiple of 2^-20, so that whole turns can be added exactly; one that is
/// within half a percent of a whole number becomes that number, so that no cut leaves a sliver.
double quantized_phase(double phase);

/// The one band that holds all three phases, if there is one.
bool lies_in_one_band(const std::array<CutVertex, 3>& triangle, int& band);

/// Cuts a triangle where its phase, taken as linear, passes whole numbers. Two triangles that share
/// an edge cut it at the same points, to the last bit.
std::vector<CutPiece> cut_by_phase(const std::array<CutVertex, 3>& triangle);

}  // namespace aerostat::model

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace aerostat::asset {

/// The most corners of one polygon. Time grows with the square of it.
inline constexpr std::size_t kMostCorners = 4096;

/// Cuts a polygon, which need be neither convex nor flat, into triangles with its winding, by
/// cutting off ears. It sees the polygon from the side from which it has the greatest area. Appends
/// n - 2 triples of indices into `corners`. Holes are understood if they are joined to the outline
/// by a pair of edges.
void triangulate(std::span<const glm::dvec3> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace aerostat::asset

#include <fmt/format.h>

#include "asset/reading.hpp"
#include "asset/words.hpp"

namespace aerostat::asset {
namespace {

/// Adds `more` to `taken`, or throws Error{bad_data} if the sum is greater than `most`. `what` is
/// the plural of what is counted, for the message.
void take(std::uint64_t& taken, std::uint64_t more, std::uint64_t most, const char* what) {
  if (more <= most && taken <= most - more) {
    taken += more;
    return;
  }
  const std::string found = more > most - taken && taken > 0
                                ? fmt::format("{} {} and then {} more", taken, what, more)
                                : fmt::format("{} {}", more, what);
  refuse(fmt::format("found {}, and at most {} are read of a model", found, most));
}

}  // namespace

void Budget::take_vertices(std::uint64_t count) {
  take(vertices_, count, limits_.vertices, "vertices");
}

void Budget::take_triangles(std::uint64_t count) {
  take(triangles_, count, limits_.triangles, "triangles");
}

void Budget::take_placements(std::uint64_t count) {
  take(placements_, count, limits_.placements, "placements of meshes");
}

void Budget::take_materials(std::uint64_t count) {
  take(materials_, count, limits_.materials, "materials");
}

void Budget::take_nodes(std::uint64_t count) {
  take(nodes_, count, limits_.nodes, "nodes");
}

void Budget::take_texture(std::uint64_t width, std::uint64_t height) {
  const std::uint64_t side = limits_.texture_side;
  if (width > side || height > side) {
    refuse(fmt::format("found a texture of {} x {} pixels, and at most {} a side are read", width,
                       height, side));
  }
  take(texture_bytes_, 4 * width * height, limits_.texture_bytes, "bytes of textures");
}

}  // namespace aerostat::asset

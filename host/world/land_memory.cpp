#include "world/land_memory.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/scene.hpp"

namespace aerostat::world {
namespace {

/// The memory for each cell of the land. 289 MiB were measured for 4096 x 4096 cells, and 97 MiB
/// for 2048 x 2048.
constexpr std::uint64_t kBytesPerCell = 18;

}  // namespace

void require_memory_for_land(const scene::Scene& scene, const MemoryLeft& left) {
  const auto cells = static_cast<std::uint64_t>(scene.terrain.cells);
  const std::uint64_t needed = cells * cells * kBytesPerCell;
  if (needed <= left.bytes) return;
  throw Error(
      ErrorKind::exhausted,
      fmt::format("not enough memory for a ground of {} x {} cells: some {} MiB are needed, "
                  "{} leaves {} MiB; a smaller /terrain/cells needs less",
                  cells, cells, needed >> 20, left.bound, left.bytes >> 20));
}

}  // namespace aerostat::world

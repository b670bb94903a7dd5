#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pack/pack_scene.hpp"
#include "render/film_buffer.hpp"
#include "render/geometry.hpp"
#include "scene/resolved_scene.hpp"

/// What a render needs on each device, before anything of it is allocated.
namespace aerostat::render {

struct MemoryItem {
  std::string what;  // such as "land"
  std::uint64_t bytes = 0;
  std::string remedy;  // what makes it smaller
};

struct MemoryNeed {
  /// The items, the largest first. None of them is empty.
  std::vector<MemoryItem> items;

  std::uint64_t bytes() const;
};

/// Sums what a device holds: the groups of the world with their trees, the pictures on it, the
/// tables of sky and clouds, and a film of `film_pixels` pixels. The buffers of launches, which are
/// made smaller where memory is short, are not among them.
MemoryNeed memory_need(const HostGeometry& geometry, const pack::PackedScene& scene,
                       std::size_t film_pixels, Layers layers);

/// Builds the world of a scene and sums what a render of `options` needs for it.
MemoryNeed memory_need(const scene::ResolvedScene& scene, const Options& options);

/// Throws Error{exhausted} if the need is more than `limit` bytes. The message names the largest
/// items and what makes them smaller. `bound` says in words what sets the limit; if it is empty,
/// --memory-limit or the device does.
void require_room(const MemoryNeed& need, std::uint64_t limit, const std::string& bound);

/// Returns bytes in words, such as "1.5 GiB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace aerostat::render

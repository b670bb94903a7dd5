#include "render/memory_need.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "render/metering.hpp"
#include "render/passes.hpp"
#include "render/scene_cache.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {
namespace {

constexpr std::size_t kMostItemsTold = 3;

/// Returns what makes a group smaller.
std::string remedy_of(std::string_view group) {
  static const std::map<std::string_view, const char*> kRemedies{
      {"land", "a smaller /terrain/cells"},
      {"plants", "a smaller /vegetation/reach_m or /vegetation/density"},
      {"balloons", "fewer /balloons"},
      {"models", "fewer or smaller /objects"},
      {"sea", "a smaller /terrain/cells"},
      {"lakes and rivers", "a smaller /terrain/extent_m"},
      {"lines of flights", "fewer lines of tracks"}};
  const auto found = kRemedies.find(group);
  return found == kRemedies.end() ? "a smaller scene" : found->second;
}

std::uint64_t bytes_of(const bvh::Bvh& tree) {
  return tree.nodes.size() * sizeof(AeroBvhNode);
}

std::uint64_t bytes_of(const pack::PackedGroup& group) {
  std::uint64_t bytes = group.room.triangles * (sizeof(AeroTriangle) + sizeof(AeroFace)) +
                        group.room.vertices * sizeof(AeroVertex) +
                        group.instances.size() * sizeof(AeroInstance);
  for (const bvh::Bvh& tree : group.trees) bytes += bytes_of(tree);
  for (const bvh::Bvh& tree : group.models) bytes += bytes_of(tree);
  if (group.grid) bytes += group.grid->words().size_bytes();
  return bytes;
}

std::uint64_t bytes_of_tables(const pack::PackedScene& scene) {
  std::uint64_t bytes = sizeof(AeroScene) + scene.sky_table.size() * sizeof(AeroSkyCell);
  if (scene.sky_importance) bytes += sizeof(AeroSkyImportance);
  if (scene.cloud_chart) bytes += scene.cloud_chart->words.size() * sizeof(AeroChartWord);
  return bytes;
}

}  // namespace

std::uint64_t MemoryNeed::bytes() const {
  return std::accumulate(
      items.begin(), items.end(), std::uint64_t{0},
      [](std::uint64_t sum, const MemoryItem& item) { return sum + item.bytes; });
}

MemoryNeed memory_need(const HostGeometry& geometry, const pack::PackedScene& scene,
                       std::size_t film_pixels, Layers layers) {
  MemoryNeed need;
  for (std::size_t i = 0; i < geometry.groups.size(); ++i) {
    const char* const name = geometry.world.groups[i].kind->name;
    need.items.push_back({name, bytes_of(*geometry.groups[i]), remedy_of(name)});
  }
  const std::uint64_t pixel =
      sizeof(AeroFilmPixel) + (layers == Layers::all ? sizeof(AeroFilmGuide) : 0);
  need.items.push_back({"film", film_pixels * pixel, "a smaller picture, or a --crop"});
  need.items.push_back({"pictures on land and models", scene.texels.size() * sizeof(std::uint32_t),
                        "a smaller /terrain/drape, or models with smaller textures"});
  need.items.push_back({"sky and clouds", bytes_of_tables(scene), "no /sky/cumulus"});
  std::erase_if(need.items, [](const MemoryItem& item) { return item.bytes == 0; });
  std::stable_sort(need.items.begin(), need.items.end(),
                   [](const MemoryItem& a, const MemoryItem& b) { return a.bytes > b.bytes; });
  return need;
}

MemoryNeed memory_need(const scene::ResolvedScene& scene, const Options& options) {
  SceneCache own;
  SceneCache& cache = options.cache ? *options.cache : own;
  GeometryOptions how;
  how.meshes = Meshes::release;
  how.where =
      options.use == Use::single_picture ? scatter::Where::in_sight : scatter::Where::everywhere;
  how.carving = options.carving;
  how.reliefs = &cache.reliefs;
  how.models = &cache.models;
  const BuiltGeometry built = build_geometry(scene, nullptr, how);
  pack::PackedScene packed = pack::pack_scene(scene, cache.packing, cache.reliefs, cache.models);
  add_air_shadows(*built.geometry, scene, cache.packing.shadows, packed);
  const scene::Image& image = scene->image;
  const PassPlan plan(image, {0, 0, image.width, image.height}, 1);
  const std::size_t pixels =
      std::max(plan.area_from(0).pixels(), static_cast<std::size_t>(kMeteringPixels));
  return memory_need(*built.geometry, packed, pixels, layers_of(options));
}

void require_room(const MemoryNeed& need, std::uint64_t limit, const std::string& bound) {
  const std::uint64_t bytes = need.bytes();
  if (bytes <= limit) return;
  std::string largest;
  for (std::size_t i = 0; i < std::min(kMostItemsTold, need.items.size()); ++i) {
    const MemoryItem& item = need.items[i];
    largest += fmt::format("{}{} {} (less with {})", i == 0 ? "" : ", ", item.what,
                           bytes_text(item.bytes), item.remedy);
  }
  throw Error(
      ErrorKind::exhausted,
      fmt::format("not enough device memory: the render needs {}, and {} are allowed {}: {}",
                  bytes_text(bytes), bytes_text(limit),
                  bound.empty() ? "(--memory-limit changes that)" : "by " + bound, largest));
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr double kStep = 1024.0;
  const char* const units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= kStep && unit + 1 < std::size(units); ++unit) value /= kStep;
  return unit == 0 ? fmt::format("{} bytes", bytes) : fmt::format("{:.1f} {}", value, units[unit]);
}

}  // namespace aerostat::render

#include "plant/plant.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/error.hpp"
#include "plant/outline.hpp"
#include "plant/species.hpp"

namespace aerostat::plant {
namespace {

struct Entry {
  const char* name;
  /// The heights of the variants in metres.
  std::vector<double> heights_m;
  void (*build)(mesh::TriangleMesh&, int variant, Detail);
  /// Whether the plant has a closed crown, whose outline looks like it from far away.
  bool closed = false;
};

/// Returns the catalogue of species in the order of Species.
const std::array<Entry, kSpeciesCount>& catalogue() {
  static const std::array<Entry, kSpeciesCount> entries{{
      {"spruce",
       {17.0, 14.0, 21.0},
       [](auto& mesh, int variant, Detail detail) { build_conifer(mesh, variant, false, detail); },
       true},
      {"snowy_spruce",
       {17.0, 14.0, 21.0},
       [](auto& mesh, int variant, Detail detail) { build_conifer(mesh, variant, true, detail); },
       true},
      {"palm", {11.5, 14.0, 8.5}, build_palm},
      {"broadleaf", {13.0, 16.0, 11.0}, build_broadleaf, true},
      {"larch",
       {18.0, 14.0, 22.0},
       [](auto& mesh, int variant, Detail detail) { build_larch(mesh, variant, false, detail); }},
      {"golden_larch",
       {18.0, 14.0, 22.0},
       [](auto& mesh, int variant, Detail detail) { build_larch(mesh, variant, true, detail); }},
      {"birch",
       {13.5, 16.0},
       [](auto& mesh, int variant, Detail detail) { build_birch(mesh, variant, false, detail); }},
      {"golden_birch",
       {13.5, 16.0},
       [](auto& mesh, int variant, Detail detail) { build_birch(mesh, variant, true, detail); }},
      {"acacia", {5.5, 7.0}, build_acacia},
      {"shrub", {1.6, 2.4}, build_shrub},
      {"scrub", {1.3, 2.4}, build_scrub},
      {"tussock", {0.55, 0.8}, build_tussock},
      {"boulder",
       {1.2, 0.8, 1.6},
       [](auto& mesh, int variant, Detail detail) { build_boulder(mesh, variant, false, detail); }},
      {"snowy_boulder",
       {1.2, 0.8, 1.6},
       [](auto& mesh, int variant, Detail detail) { build_boulder(mesh, variant, true, detail); }},
      {"driftwood", {0.5}, build_driftwood},
  }};
  return entries;
}

const Entry& entry_of(Species species) {
  return catalogue()[static_cast<std::size_t>(species)];
}

void require(const ModelKey& model) {
  const int variants = variant_count(model.species);
  if (model.variant >= 0 && model.variant < variants) return;
  throw Error(ErrorKind::internal,
              fmt::format("plant '{}': found variant {}, expected 0 to {}",
                          species_name(model.species), model.variant, variants - 1));
}

/// Scales a mesh about the foot, so that all levels of detail have the same height.
void fit_height(mesh::TriangleMesh& mesh, double height_m) {
  float top = 0.0f;
  for (const vec3& p : mesh.positions) top = std::max(top, p.y);
  const float scale = static_cast<float>(height_m) / top;
  for (vec3& p : mesh.positions) p *= scale;
}

}  // namespace

int variant_count(Species species) {
  return static_cast<int>(entry_of(species).heights_m.size());
}

const char* species_name(Species species) {
  return entry_of(species).name;
}

double model_height(const ModelKey& model) {
  require(model);
  return entry_of(model.species).heights_m[static_cast<std::size_t>(model.variant)];
}

mesh::TriangleMesh build(const ModelKey& model, Detail detail) {
  const double height_m = model_height(model);
  mesh::TriangleMesh mesh;
  const Entry& entry = entry_of(model.species);
  entry.build(mesh, model.variant, std::min(detail, Detail::far));
  if (detail == Detail::outline && entry.closed && mesh.triangles.size() > kOutlineTriangles) {
    mesh = outline_of(mesh);
  }
  fit_height(mesh, height_m);
  return mesh;
}

}  // namespace aerostat::plant

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "core/math.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::size_t kMostNotes = 50;

/// How many elements of all meshes were mended.
struct Mended {
  std::size_t not_finite = 0, folded = 0;       // triangles; folded: two corners at one place
  std::size_t normals = 0, colors = 0, uv = 0;  // vertices
};

/// Removes triangles that have no area or a position that is not finite.
void drop_triangles(Primitive& primitive, Mended& mended) {
  const auto is_finite_corner = [&](std::uint32_t i) { return is_finite(primitive.positions[i]); };
  std::erase_if(primitive.triangles, [&](const Triangle& triangle) {
    const auto [a, b, c] = triangle;
    if (!is_finite_corner(a) || !is_finite_corner(b) || !is_finite_corner(c)) {
      ++mended.not_finite;
      return true;
    }
    const auto& p = primitive.positions;
    const bool is_folded = p[a] == p[b] || p[b] == p[c] || p[c] == p[a];
    mended.folded += is_folded ? 1 : 0;
    return is_folded;
  });
}

/// Keeps only the elements of `values` whose indices are in `kept`.
template <class Value>
void keep(std::vector<Value>& values, const std::vector<std::uint32_t>& kept) {
  if (values.empty()) return;
  std::vector<Value> result;
  result.reserve(kept.size());
  for (const std::uint32_t i : kept) result.push_back(values[i]);
  values = std::move(result);
}

/// Removes the vertices that no triangle uses.
void drop_vertices(Primitive& primitive) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> places(primitive.positions.size(), kUnused), kept;
  for (const Triangle& triangle : primitive.triangles) {
    for (const std::uint32_t corner : triangle) places[corner] = 0;
  }
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (places[i] == kUnused) continue;
    places[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(i);
  }
  if (kept.size() == places.size()) return;
  keep(primitive.positions, kept);
  keep(primitive.normals, kept);
  keep(primitive.uv, kept);
  keep(primitive.colors, kept);
  for (Triangle& triangle : primitive.triangles) {
    for (std::uint32_t& corner : triangle) corner = places[corner];
  }
}

/// Returns the normal of a triangle, or +y if it has no area.
vec3 flat_normal(const Primitive& primitive, const Triangle& triangle) {
  const dvec3 a(primitive.positions[triangle[0]]);
  const dvec3 normal = glm::cross(dvec3(primitive.positions[triangle[1]]) - a,
                                  dvec3(primitive.positions[triangle[2]]) - a);
  const double length = glm::length(normal);
  return length > 0.0 && std::isfinite(length) ? vec3(normal / length) : vec3(0.0f, 1.0f, 0.0f);
}

/// Makes all normals unit vectors. One that has no direction becomes that of a triangle.
void mend_normals(Primitive& primitive, Mended& mended) {
  if (primitive.normals.empty()) return;
  std::vector<std::uint8_t> is_bad(primitive.normals.size(), 0);
  for (std::size_t i = 0; i < is_bad.size(); ++i) {
    const double length = glm::length(dvec3(primitive.normals[i]));
    is_bad[i] = length > 0.0 && std::isfinite(length) ? 0 : 1;
    if (is_bad[i] == 0) primitive.normals[i] = vec3(dvec3(primitive.normals[i]) / length);
  }
  for (const Triangle& triangle : primitive.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (is_bad[corner] == 0) continue;
      primitive.normals[corner] = flat_normal(primitive, triangle);
      is_bad[corner] = 0;
      ++mended.normals;
    }
  }
}

/// Makes colours finite and at least 0, and uv finite.
void mend_colors_and_uv(Primitive& primitive, Mended& mended) {
  for (glm::vec4& color : primitive.colors) {
    const bool is_good = is_finite(vec3(color)) && std::isfinite(color.a);
    mended.colors += is_good ? 0 : 1;
    color = is_good ? glm::max(color, glm::vec4(0.0f)) : glm::vec4(1.0f);
  }
  for (vec2& uv : primitive.uv) {
    if (std::isfinite(uv.x) && std::isfinite(uv.y)) continue;
    ++mended.uv;
    uv = vec2(0.0f);
  }
}

void note_mended(Model& model, const Mended& mended) {
  const auto note = [&](const char* what, std::size_t count, const char* one, const char* many) {
    if (count == 0) return;
    model.notes.push_back(fmt::format("{}: {}.", what, track::counted(count, one, many)));
  };
  note("Left out because of positions that are not finite", mended.not_finite, "triangle",
       "triangles");
  note("Left out because two corners lie at one place", mended.folded, "triangle", "triangles");
  note("Taken from the triangles because they had no direction", mended.normals, "normal",
       "normals");
  note("Taken as white because they are not finite", mended.colors, "colour", "colours");
  note("Taken as zero because they are not finite", mended.uv, "texture coordinate",
       "texture coordinates");
}

/// Keeps the first kMostNotes notes, because a damaged file may cause any number of them.
void cut_notes(Model& model) {
  if (model.notes.size() <= kMostNotes) return;
  const std::size_t more = model.notes.size() - kMostNotes;
  model.notes.resize(kMostNotes);
  model.notes.push_back(fmt::format("There are {} more notes.", more));
}

/// Removes meshes without triangles and the placements of such meshes.
void drop_empty_meshes(Model& model) {
  std::vector<std::optional<std::size_t>> places;
  std::vector<Mesh> meshes;
  for (Mesh& mesh : model.meshes) {
    std::erase_if(mesh.primitives, [](const Primitive& each) { return each.triangles.empty(); });
    const bool is_kept = !mesh.primitives.empty();
    places.push_back(is_kept ? std::optional(meshes.size()) : std::nullopt);
    if (is_kept) meshes.push_back(std::move(mesh));
  }
  model.meshes = std::move(meshes);
  std::erase_if(model.placements, [&](const Placement& each) { return !places[each.mesh]; });
  for (Placement& placement : model.placements) placement.mesh = *places[placement.mesh];
}

/// Returns the uses of textures of a material.
std::array<std::optional<TextureUse>*, 4> uses_of(Material& material) {
  return {&material.base_color_texture, &material.metallic_roughness_texture,
          &material.normal_texture, &material.emission_texture};
}

/// Removes the textures that no material uses.
void drop_textures(Model& model) {
  std::vector<std::optional<std::size_t>> places(model.textures.size());
  std::vector<Texture> kept;
  for (Material& material : model.materials) {
    for (std::optional<TextureUse>* use : uses_of(material)) {
      if (!*use) continue;
      std::optional<std::size_t>& place = places[(*use)->texture];
      if (!place) {
        place = kept.size();
        kept.push_back(std::move(model.textures[(*use)->texture]));
      }
      (*use)->texture = *place;
    }
  }
  model.textures = std::move(kept);
}

}  // namespace

void finish(Model& model) {
  Mended mended;
  for (Mesh& mesh : model.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      drop_triangles(primitive, mended);
      drop_vertices(primitive);
      mend_normals(primitive, mended);
      mend_colors_and_uv(primitive, mended);
    }
  }
  drop_empty_meshes(model);
  drop_textures(model);
  note_mended(model, mended);
  cut_notes(model);
  if (model.placements.empty()) refuse("found no triangle that can be drawn");
  if (model.materials.empty()) model.materials.emplace_back();
}

}  // namespace aerostat::asset

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "asset/files.hpp"
#include "asset/model.hpp"
#include "asset/read.hpp"

/// What the readers of several formats need.
namespace aerostat::asset {

/// Counts what is read of a model. Each function throws Error{bad_data} with the limit before more
/// than that is read.
class Budget {
 public:
  explicit Budget(const Limits& limits) : limits_(limits) {}

  void take_vertices(std::uint64_t count);
  void take_triangles(std::uint64_t count);
  void take_placements(std::uint64_t count);
  void take_materials(std::uint64_t count);
  void take_nodes(std::uint64_t count);
  void take_texture(std::uint64_t width, std::uint64_t height);

  const Limits& limits() const { return limits_; }

 private:
  Limits limits_;
  std::uint64_t vertices_ = 0, triangles_ = 0, placements_ = 0, materials_ = 0, nodes_ = 0;
  std::uint64_t texture_bytes_ = 0;
};

/// What the reader of a format reads, and the model that it fills.
struct Reading {
  std::string_view bytes;
  Files files;
  Budget budget;
  Model model;

  void note(std::string_view sentence) { model.notes.emplace_back(sentence); }
};

/// These functions read files of one format. They throw Error{bad_data} whose message does not name
/// the file yet. Positions, normals, colours and uv of what they return may still be not finite.
void read_stl(Reading& reading);
void read_ply(Reading& reading);
void read_obj(Reading& reading);
void read_gltf(Reading& reading);

/// Decodes a picture and appends it to the textures. Throws Error{bad_data} if it cannot be
/// decoded, with the name of its format if that is known. `name` stands for it in messages.
std::size_t add_texture(Reading& reading, std::string_view bytes, const std::string& name);

Texture white_texture(std::uint32_t width, std::uint32_t height);

/// Returns the least opacity of a pixel of a texture.
std::uint8_t least_opacity(const Texture& texture);

/// Replaces the opacity of a texture. It comes from the opacity of `from` or, if all of `from` is
/// opaque, from its red channel, because pictures of opacity are often grey.
void set_opacity(Texture& texture, const Texture& from);

/// Returns the material of surfaces for which the file gives none: grey and double-sided.
Material plain_material();

/// Multiplies the base colour of a material by a grey, in place of a texture that is missing.
void show_missing_texture(Material& material);

/// Removes from a model what cannot be drawn, mends the rest, and adds notes about both.
/// Triangles with positions that are not finite or with a corner twice are left out, and so is what
/// nothing uses. Throws Error{bad_data} if no triangle is left.
void finish(Model& model);

/// Returns, for each axis, the middle of the box in whole units if it is farther than
/// kFarFromOrigin from zero, and otherwise zero.
glm::dvec3 far_origin(const Bounds& box);

/// Sets the origin of a model with these positions, and returns the positions minus the origin.
std::vector<glm::vec3> around_origin(std::span<const glm::dvec3> points, Model& model);

/// Adds a mesh and places it once, without a transform.
void add_mesh(Model& model, std::string name, std::vector<Primitive> primitives);

/// Returns whether no component is NaN or infinite.
inline bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Returns a linear component of a colour that is encoded in sRGB, from 0 to 1.
float linear_of_srgb(float encoded);

}  // namespace aerostat::asset

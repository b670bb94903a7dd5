#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

/// Models from files of other programs: glTF 2.0, OBJ, PLY and STL.
namespace aerostat::asset {

/// A picture as its file stores it, four bytes a pixel, with the top row first. What a colour uses
/// is encoded in sRGB and has opacity as its fourth channel; other uses take the bytes as they are.
struct Texture {
  std::string name;  // a file's name or the place in the file, for messages
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// What lies beyond the edges of a texture.
enum class Wrap { repeat, mirror, clamp };

/// A texture as a material uses it.
struct TextureUse {
  std::size_t texture = 0;  // in Model::textures
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest = false;  // a magnified pixel shows as a square, not blended with its neighbours
};

/// What the opacity of the base colour means. With `mask`, what is below a cutoff is not there.
enum class AlphaMode { opaque, mask, blend };

/// What a surface is made of, as in glTF 2.0. Colours are linear Rec. 709. A texture multiplies the
/// number of the same name.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};  // with opacity
  std::optional<TextureUse> base_color_texture;
  float metallic = 0.0f;   // times the blue channel of its texture
  float roughness = 1.0f;  // times the green channel; the square of this is GGX's alpha
  std::optional<TextureUse> metallic_roughness_texture;
  std::optional<TextureUse> normal_texture;  // in the tangent space of uv: +x along u, +y against v
  float normal_scale = 1.0f;
  glm::vec3 emission{0.0f};
  std::optional<TextureUse> emission_texture;
  AlphaMode alpha = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  float transmission = 0.0f;  // share of the light that passes instead of being scattered
  float ior = 1.5f;           // index of refraction
};

/// Triangles of one material. Front faces wind counter-clockwise. All attributes that are not empty
/// have one element for each position, and every index lies in them.
struct Primitive {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  // of length 1; empty: each triangle is flat
  std::vector<glm::vec2> uv;       // u to the right, v down from the top row; empty: no textures
  std::vector<glm::vec4> colors;   // linear, multiply base_color; empty: white
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t material = 0;  // in Model::materials
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

/// A mesh where it stands. A transform whose determinant is negative mirrors the mesh and so turns
/// the winding of its triangles over: whoever places the triangles swaps two corners of each.
/// Normals go by the inverse transpose.
struct Placement {
  std::size_t mesh = 0;  // in Model::meshes
  glm::dmat4 transform{1.0};
};

/// All that is read of a file, with y up. A point p of a mesh lies at `origin + transform * p` in
/// the file's units, turned so that y is up.
struct Model {
  std::vector<Mesh> meshes;
  std::vector<Placement> placements;
  std::vector<Material> materials;  // at least one
  std::vector<Texture> textures;
  /// Subtracted from all positions in double precision, so that meshes far from zero, such as those
  /// in UTM coordinates, keep their precision. Along each axis, it is zero unless the middle of the
  /// model is farther than kFarFromOrigin from zero.
  glm::dvec3 origin{0.0};
  /// Sentences for the user about what is missing and what was left out or guessed.
  std::vector<std::string> notes;
};

/// From this distance on, floats are coarser than a millimetre if the unit is a metre.
inline constexpr double kFarFromOrigin = 10'000.0;

/// A box along the axes. It is empty if `least` is greater than `most`.
struct Bounds {
  glm::dvec3 least{std::numeric_limits<double>::infinity()};
  glm::dvec3 most{-std::numeric_limits<double>::infinity()};

  bool empty() const { return least.x > most.x; }
  glm::dvec3 size() const { return most - least; }
  void add(const glm::dvec3& point) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
};

/// Returns the box around all placed triangles, without `origin`. Of meshes that are placed very
/// often, it holds the placed boxes and may be larger than need be.
Bounds bounds(const Model& model);

/// Returns the number of triangles: of the meshes, each once, and of all that is placed.
std::size_t triangle_count(const Mesh& mesh);
std::size_t triangle_count(const Model& model);
std::size_t placed_triangle_count(const Model& model);

}  // namespace aerostat::asset

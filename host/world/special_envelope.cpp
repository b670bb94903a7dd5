#include "world/special_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/envelope_shape.hpp"
#include "model/rigging.hpp"

namespace aerostat::world {
namespace {

/// How far the model reaches below the mouth, in diameters of the envelope, so that the skirt and
/// the cables end within it. Chosen by eye.
constexpr double kOverlap = 0.03;

float linear_of(std::uint8_t byte) {
  const float encoded = static_cast<float>(byte) / 255.0f;
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

/// Returns the texel of a texture at a point. Beyond its edges it repeats.
vec3 texel_at(const asset::Texture& texture, const vec2& uv) {
  const auto place = [](float share, std::uint32_t count) {
    const float within = share - std::floor(share);
    return std::min(static_cast<std::uint32_t>(within * static_cast<float>(count)), count - 1);
  };
  const std::size_t at =
      std::size_t{4} *
      (std::size_t{place(uv.y, texture.height)} * texture.width + place(uv.x, texture.width));
  return {linear_of(texture.rgba[at]), linear_of(texture.rgba[at + 1]),
          linear_of(texture.rgba[at + 2])};
}

/// Returns the colour of a vertex of a part of a model.
vec3 color_of(const FileModel& model, const Object& part, std::size_t vertex) {
  const asset::Material& material = model.materials[part.file_material.value_or(0)];
  vec3 color(material.base_color);
  if (!part.mesh.colors.empty()) color *= part.mesh.colors[vertex];
  if (material.base_color_texture && !part.mesh.uvs.empty()) {
    const asset::Texture& texture = model.textures[material.base_color_texture->texture];
    color *= texel_at(texture, part.mesh.uvs[vertex]);
  }
  return glm::clamp(color, 0.0f, 1.0f);
}

}  // namespace

mesh::TriangleMesh special_envelope(const scene::Balloon& balloon, const FileModel& model) {
  const scene::EnvelopeModel& given = *balloon.envelope;
  const model::EnvelopeShape usual(balloon.diameter_m, balloon.gores);
  const double height = given.height_m.value_or(usual.height());
  const double scale = model.size.y > 0.0 ? height / model.size.y : 1.0;
  const double angle = glm::radians(balloon.heading_deg + given.turn_deg);
  const dvec3 right(std::cos(angle), 0.0, std::sin(angle)),
      back(-std::sin(angle), 0.0, std::cos(angle));
  const double foot = model::mouth_height(balloon.diameter_m) - kOverlap * balloon.diameter_m;
  const dvec3 origin = balloon.position + dvec3(0.0, foot, 0.0);
  const auto turned = [&](const vec3& v) {
    const dvec3 d(v);
    return d.x * right + dvec3(0.0, d.y, 0.0) + d.z * back;
  };
  mesh::TriangleMesh whole;
  for (const Object& part : *model.parts) {
    mesh::TriangleMesh placed;
    placed.triangles = part.mesh.triangles;
    for (std::size_t i = 0; i < part.mesh.positions.size(); ++i) {
      placed.positions.push_back(vec3(origin + scale * turned(part.mesh.positions[i])));
      placed.normals.push_back(vec3(turned(part.mesh.normals[i])));
      placed.colors.push_back(color_of(model, part, i));
    }
    mesh::append(whole, placed);
  }
  return whole;
}

void cut_above_mouth(const scene::Balloon& balloon, mesh::TriangleMesh& cables) {
  // The ring at the mouth stays.
  constexpr double kRing = 0.2;
  const auto limit =
      static_cast<float>(balloon.position.y + model::mouth_height(balloon.diameter_m) + kRing);
  std::erase_if(cables.triangles, [&](const uvec3& triangle) {
    const auto& p = cables.positions;
    return std::max({p[triangle.x].y, p[triangle.y].y, p[triangle.z].y}) > limit;
  });
}

dvec3 mean_color(const FileModel& model) {
  dvec3 sum(0.0);
  double whole = 0.0;
  for (const Object& part : *model.parts) {
    for (const uvec3& triangle : part.mesh.triangles) {
      const auto& p = part.mesh.positions;
      const double area = 0.5 * static_cast<double>(glm::length(glm::cross(
                                    p[triangle.y] - p[triangle.x], p[triangle.z] - p[triangle.x])));
      for (int corner = 0; corner < 3; ++corner) {
        sum += area / 3.0 * dvec3(color_of(model, part, triangle[corner]));
      }
      whole += area;
    }
  }
  return whole > 0.0 ? sum / whole : dvec3(0.5);
}

}  // namespace aerostat::world

#include "exported_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "scene/io.hpp"
#include "support/resolved.hpp"
#include "world/exported.hpp"

namespace aerostat::test {
namespace {

std::vector<std::uint8_t> ply_of(const scene::Scene& scene, world::Placed instances) {
  const world::World world = world::build(resolved(scene));
  world::Objects triangles = world::as_triangles(world, instances);
  const std::vector<mesh::ExportObject> objects =
      world::exported_objects(triangles, scene, *world.models);
  return mesh::ply_bytes(objects);
}

struct Header {
  std::size_t vertices = 0, faces = 0, vertex_bytes = 0, bytes = 0;
};

/// Reads the lines of the header. The only use of the properties is the length of a vertex.
Header read_header(const std::string& text) {
  Header header;
  std::istringstream lines(text.substr(0, 4096));
  std::string line, element;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string word, kind;
    words >> word >> kind;
    if (word == "element") {
      element = kind;
      words >> (element == "vertex" ? header.vertices : header.faces);
    } else if (word == "property" && element == "vertex") {
      header.vertex_bytes += kind == "uchar" ? 1 : 4;
    } else if (word == "end_header") {
      header.bytes = static_cast<std::size_t>(lines.tellg());
      return header;
    }
  }
  throw std::runtime_error("a PLY without an end of its header");
}

dvec3 triple(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace

ExportedWorld exported_world(const scene::Scene& scene, world::Placed instances) {
  const std::vector<std::uint8_t> file = ply_of(scene, instances);
  const Header header = read_header(
      std::string(file.begin(), file.begin() + std::min<std::ptrdiff_t>(4096, std::ssize(file))));
  constexpr std::size_t kFaceBytes = 1 + 3 * 4 + 4;
  if (file.size() !=
      header.bytes + header.vertices * header.vertex_bytes + header.faces * kFaceBytes)
    throw std::runtime_error("a PLY of another length than its header says");
  ExportedWorld world;
  world.positions.resize(header.vertices);
  world.triangles.resize(header.faces);
  world.objects.resize(header.faces);
  const std::uint8_t* at = file.data() + header.bytes;
  world.colors.assign(header.vertices, vec3(1.0f));
  constexpr std::size_t kColorAt = 6 * sizeof(float) + 3;
  for (std::size_t i = 0; i < header.vertices; ++i) {
    std::memcpy(&world.positions[i], at, sizeof(vec3));
    if (header.vertex_bytes > kColorAt) {
      std::memcpy(&world.colors[i], at + kColorAt, sizeof(vec3));
    }
    at += header.vertex_bytes;
  }
  for (std::size_t i = 0; i < header.faces; ++i) {
    std::memcpy(&world.triangles[i], at + 1, sizeof(uvec3));
    std::memcpy(&world.objects[i], at + 13, sizeof(std::uint32_t));
    at += kFaceBytes;
  }
  return world;
}

DumpedCamera::DumpedCamera(const scene::Scene& scene) {
  const auto dump = nlohmann::json::parse(scene::write_text(scene));
  const auto& camera = dump.at("camera");
  origin_ = triple(camera.at("position"));
  forward_ = glm::normalize(triple(camera.at("target")) - origin_);
  const dvec3 upright = glm::normalize(triple(camera.at("up")));
  lens_ = camera.at("lens").get<std::string>();
  if (lens_ == "panorama") {
    forward_ = glm::normalize(forward_ - glm::dot(forward_, upright) * upright);
  }
  right_ = glm::normalize(glm::cross(forward_, upright));
  up_ = glm::cross(right_, forward_);
  half_height_m_ = 0.5 * camera.at("view_height_m").get<double>();
  width_ = dump.at("image").at("width").get<int>();
  height_ = dump.at("image").at("height").get<int>();
  tangent_ = std::tan(glm::radians(0.5 * camera.at("fov_y_deg").get<double>()));
}

dvec2 DumpedCamera::from_middle(const dvec2& point) const {
  const double half = 0.5 * height_;
  return dvec2(point.x - 0.5 * width_, half - point.y) / half;
}

dvec3 DumpedCamera::origin(int x, int y) const {
  if (lens_ != "orthographic") return origin_;
  const dvec2 at = half_height_m_ * from_middle({x + 0.5, y + 0.5});
  return origin_ + at.x * right_ + at.y * up_;
}

dvec3 DumpedCamera::direction(int x, int y) const {
  if (lens_ == "orthographic") return forward_;
  if (lens_ == "panorama") {
    const double azimuth = 2.0 * std::numbers::pi * ((x + 0.5) / width_ - 0.5);
    const double height = std::numbers::pi * (0.5 - (y + 0.5) / height_);
    const dvec3 level = std::cos(azimuth) * forward_ + std::sin(azimuth) * right_;
    return std::cos(height) * level + std::sin(height) * up_;
  }
  return direction_through({x + 0.5, y + 0.5});
}

dvec3 DumpedCamera::direction_through(const dvec2& point) const {
  const dvec2 at = tangent_ * from_middle(point);
  return glm::normalize(forward_ + at.x * right_ + at.y * up_);
}

}  // namespace aerostat::test

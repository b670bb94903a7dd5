#include "scene/read.hpp"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/enum_names.hpp"
#include "scene/fields.hpp"
#include "scene/io.hpp"
#include "scene/json_text.hpp"
#include "scene/overrides.hpp"
#include "scene/palettes.hpp"
#include "scene/schema.hpp"
#include "scene/semantics.hpp"
#include "scene/sun_angles.hpp"
#include "scene/sun_position.hpp"

namespace aerostat::scene {

namespace {

using detail::fields;
using detail::Json;

/// The archive of fields.hpp that reads: keys that are missing leave their field as it is. The
/// document has passed the schema.
class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) {}

  template <class T>
  bool operator()(const char* key, T& value) {
    const auto found = object_.find(key);
    if (found == object_.end()) return false;
    read(*found, value);
    return true;
  }

  template <class T>
  void operator()(const char* key, T& value, bool& given) {
    if ((*this)(key, value)) given = true;
  }

 private:
  template <class T>
  static void read(const Json& node, T& value) {
    if constexpr (std::is_enum_v<T>) {
      const auto names = detail::enum_names<T>();
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (node == names[i]) value = static_cast<T>(i);
      }
    } else if constexpr (std::is_arithmetic_v<T>) {
      value = node.get<T>();
    } else {
      Reader inner(node);
      fields(inner, value);
    }
  }

  static void read(const Json& node, vec3& v) { v = {node[0], node[1], node[2]}; }
  static void read(const Json& node, dvec2& v) { v = {node[0], node[1]}; }
  static void read(const Json& node, dvec3& v) { v = {node[0], node[1], node[2]}; }
  static void read(const Json& node, double (&v)[2]) {
    v[0] = node[0];
    v[1] = node[1];
  }

  template <class T>
  static void read(const Json& node, std::vector<T>& values) {
    values.clear();
    for (const Json& element : node) read(element, values.emplace_back());
  }

  const Json& object_;
};

/// JSON Schema counts 4.0 as an integer; the parser does not. A negative zero becomes zero.
void normalize_numbers(Json& node) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (node.is_structured()) {
    for (Json& child : node) normalize_numbers(child);
  } else if (node.is_number_float()) {
    const double value = node.get<double>();
    if (value == std::trunc(value) && std::abs(value) <= kExact) {
      node = static_cast<std::int64_t>(value);
    }
  }
}

/// A length within rounding of 1 stays as it is, so that reading what was written changes nothing.
dvec3 unit(const dvec3& v) {
  return std::abs(glm::dot(v, v) - 1.0) < 1e-12 ? v : glm::normalize(v);
}

void settle_sun(const Json& document, Sun& sun, const Sun& usual) {
  const Json given = document.value("sun", Json::object());
  if (given.contains("azimuth_deg") || given.contains("elevation_deg")) {
    detail::SunAngles angles = detail::angles_of(usual.direction);
    angles.azimuth_deg = given.value("azimuth_deg", angles.azimuth_deg);
    angles.elevation_deg = given.value("elevation_deg", angles.elevation_deg);
    sun.direction = detail::direction_of(angles);
  }
  if (given.contains("date")) {
    const auto days = detail::days_from_2000(given["date"], given["time"]);
    sun.direction = detail::direction_of(
        detail::sun_angles_at(days.value(), given["latitude_deg"], given["longitude_deg"]));
  }
  sun.direction = unit(sun.direction);
}

/// Colours follow from the palette where they are not given.
void settle_colors(const Json& document, Scene& scene) {
  const Json given = document.value("balloon", Json::object());
  if (given.contains("palette") && !given.contains("colors")) {
    dress(scene.balloon, scene.balloon.palette);
  }
  const Json further = document.value("balloons", Json::array());
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
    Balloon& balloon = scene.balloons[i];
    if (!further[i].contains("palette")) balloon.palette = palette_of_place(i);
    if (!further[i].contains("colors")) balloon.colors = palette_colors(balloon.palette);
  }
}

/// Ahead of the schema, since another version has another one.
void check_version(const Json& document, const std::string& name) {
  if (!document.is_object()) detail::fail(name, {}, detail::describe(document), "an object");
  const auto version = document.find("version");
  if (version == document.end()) detail::fail(name, {"version"}, "nothing", "1");
  if (*version != 1) detail::fail(name, {"version"}, detail::describe(*version), "1");
}

}  // namespace

namespace detail {

std::string read_bytes(const std::filesystem::path& path) {
  const auto unreadable = [&path](const std::string& reason) {
    return Error(ErrorKind::io,
                 fmt::format("{}: cannot read the scene: {}", path.string(), reason));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw unreadable("it is a directory");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable(errno != 0 ? std::strerror(errno) : "it cannot be opened");
  std::string bytes;
  char chunk[1 << 16];
  while (file && bytes.size() <= detail::kMaxFileBytes) {
    file.read(chunk, sizeof chunk);
    bytes.append(chunk, static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw unreadable("reading failed half-way");
  return bytes;
}

Json parse_document(const std::string& text, const std::string& name) {
  if (text.size() > kMaxFileBytes) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found more than {} MiB, expected a scene file", name,
                            kMaxFileBytes >> 20));
  }
  Json document = parse_json(text, name);
  expand_short_forms(document);
  return document;
}

Scene read_document(Json& document, const std::string& name) {
  normalize_numbers(document);
  check_version(document, name);
  check_schema(document, name);

  Scene usual = defaults(biome_of(document), view_of(document));
  set_quality(usual, quality_of(document));
  Scene scene = usual;
  Reader reader(document);
  fields(reader, scene);
  settle_colors(document, scene);
  check_semantics(document, scene, name);
  settle_sun(document, scene.sun, usual.sun);
  return scene;
}

}  // namespace detail

Scene read_text(const std::string& text, const std::string& name,
                const std::vector<Override>& overrides) {
  Json document = detail::parse_document(text, name);
  detail::apply_overrides(document, overrides, name);
  return detail::read_document(document, name);
}

Scene read_file(const std::filesystem::path& path, const std::vector<Override>& overrides) {
  return read_text(detail::read_bytes(path), path.string(), overrides);
}

}  // namespace aerostat::scene

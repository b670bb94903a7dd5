#include "scene/read.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/unit_vector.hpp"
#include "scene/enum_names.hpp"
#include "scene/fields.hpp"
#include "scene/io.hpp"
#include "scene/json_text.hpp"
#include "scene/moon_position.hpp"
#include "scene/overrides.hpp"
#include "scene/palettes.hpp"
#include "scene/schema.hpp"
#include "scene/semantics.hpp"
#include "scene/sun_angles.hpp"
#include "scene/sun_position.hpp"

namespace aerostat::scene {

namespace {

using detail::Json;

/// These functions read a value from a node that has passed the schema. A key that is missing
/// leaves its field as it is.
template <class T>
void read(const Json& node, T& value);

void read(const Json& node, vec3& v) {
  v = {node[0], node[1], node[2]};
}

void read(const Json& node, std::string& text) {
  text = node.get<std::string>();
}

void read(const Json& node, KeyValue& value) {
  value = {};
  if (node.is_string()) {
    value.text = node.get<std::string>();
  } else if (node.is_array()) {
    value.is_array = true;
    value.numbers = node.get<std::vector<double>>();
  } else {
    value.numbers = {node.get<double>()};
  }
}

void read(const Json& node, dvec2& v) {
  v = {node[0], node[1]};
}

void read(const Json& node, dvec3& v) {
  v = {node[0], node[1], node[2]};
}

void read(const Json& node, double (&v)[2]) {
  v[0] = node[0];
  v[1] = node[1];
}

template <class T>
void read(const Json& node, std::optional<T>& value) {
  read(node, value.emplace());
}

template <class T>
void read(const Json& node, std::vector<T>& values) {
  values.clear();
  for (const Json& element : node) read(element, values.emplace_back());
}

void read(const Json& node, std::array<Material, kMaterialCount>& materials) {
  for (std::size_t i = 0; i < kMaterialCount; ++i) {
    const auto found = node.find(material_name(static_cast<MaterialId>(i)));
    if (found != node.end()) read(*found, materials[i]);
  }
}

template <class T>
void read(const Json& node, T& value) {
  if constexpr (std::is_enum_v<T>) {
    const auto names = detail::enum_names<T>();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (node == names[i]) value = static_cast<T>(i);
    }
  } else if constexpr (std::is_arithmetic_v<T>) {
    value = node.get<T>();
  } else {
    detail::for_each_member<T>([&](const auto& field) {
      const auto found = node.find(field.key);
      if (found != node.end()) read(*found, value.*field.member);
    });
  }
}

/// Turns whole numbers such as 4.0 into integers. JSON Schema counts them as integers, but the
/// parser does not. A negative zero becomes zero.
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

/// Returns the unit vector of `v`. A length within rounding of 1 stays as it is, so that reading
/// a written scene changes nothing.
dvec3 kept_or_unit(const dvec3& v) {
  return std::abs(glm::dot(v, v) - 1.0) < 1e-12 ? v : unit(v);
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
  sun.direction = kept_or_unit(sun.direction);
}

/// Sets moon and stars of a date, time and place, if the document gives the sun by them.
void settle_night(const Json& document, Scene& usual) {
  const Json given = document.value("sun", Json::object());
  for (const char* key : detail::kSunDateKeys) {
    if (!given.contains(key)) return;
  }
  const auto days = detail::days_from_2000(given["date"], given["time"]);
  if (!days) return;
  const double latitude_deg = given["latitude_deg"], longitude_deg = given["longitude_deg"];
  const detail::MoonSeen moon = detail::moon_seen_at(*days, latitude_deg, longitude_deg);
  usual.moon = {true, moon.angles.azimuth_deg, moon.angles.elevation_deg, moon.distance_km};
  usual.stars.latitude_deg = latitude_deg;
  usual.stars.sidereal_deg = std::fmod(detail::sidereal_deg_at(*days) + longitude_deg, 360.0);
  usual.stars.year = std::clamp(2000.0 + *days / 365.25, 1900.0, 2100.0);
}

/// Sets colours from the palette where the document gives no colours.
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

/// Checks the version. This happens before the schema is checked, because another version has
/// another schema.
void check_version(const Json& document, const std::string& name) {
  if (!document.is_object()) detail::fail(name, {}, detail::describe(document), "an object");
  const auto version = document.find("version");
  if (version != document.end() && *version != 1)
    detail::fail(name, {"version"}, detail::describe(*version), "1");
}

/// Returns the document without the values that these pointers name. For an element of an array,
/// the whole array is removed. For a key that an object lacks, nothing is removed, unless the
/// object is in an array.
Json without(Json document, const std::vector<detail::Pointer>& pointers) {
  for (const detail::Pointer& pointer : pointers) {
    Json* node = &document;
    for (std::size_t i = 0; i < pointer.size() && node->is_object(); ++i) {
      const auto child = node->find(pointer[i]);
      if (child == node->end()) break;
      if (i + 1 == pointer.size() || child->is_array()) {
        node->erase(child);
        break;
      }
      node = &*child;
    }
  }
  document["version"] = 1;
  return document;
}

struct Read {
  Scene scene;
  Scene usual;  // values that hold where the document gives none
};

/// Reads the scene from a document that has passed the schema.
Read read_fields(const Json& document) {
  Scene usual = detail::usual_scene(document);
  Scene scene = usual;
  read(document, scene);
  settle_colors(document, scene);
  return {std::move(scene), std::move(usual)};
}

/// Adds the semantic faults in the part of a document that has passed the schema.
void tell_nonsense(const Json& document, const std::vector<detail::Pointer>& faulty,
                   detail::Faults& faults) {
  const Json rest = without(document, faulty);
  detail::Faults others(faults.name());
  if (!detail::check_schema(rest, others).empty()) return;
  const std::size_t before = faults.count();
  detail::check_semantics(rest, read_fields(rest).scene, faults);
  faults.forget_after(before, faulty);
}

}  // namespace

namespace detail {

Scene usual_scene(const Json& document) {
  Scene usual = defaults(biome_of(document), view_of(document), mood_of(document));
  set_season(usual, season_of(document));
  if (has_source(document)) set_elevation(usual);
  set_quality(usual, quality_of(document));
  const Json haze = document.value("haze", Json::object());
  set_haze_droplets(usual.haze, haze.value("visibility_m", usual.haze.visibility_m));
  settle_night(document, usual);
  return usual;
}

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
  std::vector<char> chunk(std::size_t{1} << 16);
  while (file && bytes.size() <= detail::kMaxFileBytes) {
    file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    bytes.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw unreadable("reading failed half-way");
  return bytes;
}

Json parse_document(const std::string& text, Faults& faults) {
  if (text.size() > kMaxFileBytes) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found more than {} MiB, expected a scene file", faults.name(),
                            kMaxFileBytes >> 20));
  }
  Json document = parse_json(text, faults);
  expand_short_forms(document);
  return document;
}

Scene read_document(Json& document, Faults& faults) {
  normalize_numbers(document);
  check_version(document, faults.name());
  const std::vector<Pointer> faulty = check_schema(document, faults);
  if (!faulty.empty()) tell_nonsense(document, faulty, faults);
  faults.throw_if_any();

  auto [scene, usual] = read_fields(document);
  check_semantics(document, scene, faults);
  faults.throw_if_any();
  settle_sun(document, scene.sun, usual.sun);
  return scene;
}

}  // namespace detail

namespace {

/// Reads a scene whose files are named from `folder`.
Scene read_from(const std::filesystem::path& folder, const std::string& text,
                const std::string& name, const std::vector<Override>& overrides, NamedFiles files) {
  detail::Faults faults(name, text);
  Json document = detail::parse_document(text, faults);
  if (files == NamedFiles::below_the_scene) detail::require_files_below(document, faults);
  detail::name_files_from(folder, document);
  detail::apply_overrides(document, overrides, faults);
  return detail::read_document(document, faults);
}

}  // namespace

Scene read_text(const std::string& text, const std::string& name,
                const std::vector<Override>& overrides) {
  return read_from({}, text, name, overrides, NamedFiles::anywhere);
}

Scene read_file(const std::filesystem::path& path, const std::vector<Override>& overrides,
                NamedFiles files) {
  return read_from(path.parent_path(), detail::read_bytes(path), path.string(), overrides, files);
}

}  // namespace aerostat::scene

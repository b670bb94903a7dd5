#include "scene/overrides.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <mutex>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/enum_names.hpp"
#include "scene/land.hpp"
#include "scene/sun_angles.hpp"
#include "scene/sun_position.hpp"
#include "scene/write.hpp"

namespace aerostat::scene {

namespace detail {

namespace {

const Json kNothing;  // stands for values that the defaults do not have

[[noreturn]] void bad_pointer(const std::string& text, const std::string& expected) {
  throw Error(ErrorKind::usage,
              fmt::format("--set: found {}, expected {}", describe(Json(text)), expected));
}

std::string unescape(const std::string& token, const std::string& whole) {
  std::string result;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (token[i] != '~') {
      result += token[i];
    } else if (i + 1 < token.size() && (token[i + 1] == '0' || token[i + 1] == '1')) {
      result += token[++i] == '0' ? '~' : '/';
    } else {
      bad_pointer(whole, "'~' only as ~0 (for ~) or ~1 (for /)");
    }
  }
  return result;
}

template <class Enum>
Enum enum_of(const Json& node, const char* key, Enum otherwise) {
  if (!node.is_object() || !node.contains(key)) return otherwise;
  const auto names = enum_names<Enum>();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (node[key] == names[i]) return static_cast<Enum>(i);
  }
  return otherwise;
}

/// Returns the element that `token` names. An index one past the end, or "-", appends an element.
Json& element(Json& array, const std::string& token, const std::string& name,
              const Pointer& pointer) {
  std::size_t index = array.size();
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, index);
  const bool canonical = token == "0" || (!token.empty() && token[0] != '0');
  const bool is_index = error == std::errc() && stop == end && canonical;
  if ((!is_index && token != "-") || index > array.size()) {
    fail(name, pointer, describe(Json(token)),
         fmt::format("an index from 0 to {} ({} appends)", array.size(), array.size()));
  }
  if (index == array.size()) array.push_back(nullptr);
  return array[index];
}

/// Returns the JSON of a further balloon or of a model for which a file gives no values, or null
/// for a key of the scene that is neither of these lists.
const Json* usual_element(const std::string& list) {
  static const Json usual = [] {
    Scene scene;
    scene.balloons.emplace_back();
    scene.objects.emplace_back();
    const Json all = to_json(scene);
    return Json{{"balloons", all["balloons"][0]}, {"objects", all["objects"][0]}};
  }();
  return usual.contains(list) ? &usual[list] : nullptr;
}

/// Returns the JSON of the defaults of a document's biome, view and mood. To make it takes longer
/// than all else that an override needs, so each is made once and kept.
const Json& usual_values(const Json& document) {
  static std::mutex mutex;
  static std::map<std::tuple<BiomeKind, View, Mood>, Json> kept;
  const std::tuple key(biome_of(document), view_of(document), mood_of(document));
  const std::lock_guard lock(mutex);
  auto found = kept.find(key);
  if (found == kept.end()) {
    Json made(to_json(std::apply(defaults, key)));
    found = kept.emplace(key, std::move(made)).first;
  }
  return found->second;
}

/// Returns the node that `pointer` names, and creates it if it does not exist.
Json& reach(Json& document, const Json& defaults, const Pointer& pointer, const std::string& name) {
  Json* node = &document;
  const Json* fallback = &defaults;
  Pointer so_far;
  for (const std::string& token : pointer) {
    if (node->is_null()) *node = fallback->is_array() ? *fallback : Json::object();
    if (!node->is_structured()) {
      fail(name, so_far, describe(*node),
           fmt::format("an object to hold {}", describe(Json(token))));
    }
    so_far.push_back(token);
    const bool known = fallback->is_object() && fallback->contains(token);
    fallback = known ? &(*fallback)[token] : &kNothing;
    const Json* const element_default = so_far.size() == 2 ? usual_element(so_far[0]) : nullptr;
    if (element_default != nullptr) fallback = element_default;
    node = node->is_array() ? &element(*node, token, name, so_far) : &(*node)[token];
  }
  return *node;
}

Json override_value(const Override& change) {
  if (!is_json(change.value)) return change.value;
  return parse_json(change.value, "--set " + change.pointer);
}

/// Removes the other ways of giving the sun's direction. Their values are kept as angles where
/// `pointer` sets one angle of two.
void settle_sun(Json& document, const Pointer& pointer) {
  if (pointer.size() < 2 || pointer[0] != "sun" || !document.contains("sun")) return;
  Json& sun = document["sun"];
  if (!sun.is_object()) return;
  const bool is_angle = pointer[1] == "azimuth_deg" || pointer[1] == "elevation_deg";
  const bool is_date = std::find(std::begin(kSunDateKeys), std::end(kSunDateKeys), pointer[1]) !=
                       std::end(kSunDateKeys);
  if (pointer[1] == "direction" || is_date) {
    sun.erase("azimuth_deg");
    sun.erase("elevation_deg");
  }
  if (is_date) sun.erase("direction");
  if (pointer[1] == "direction" || is_angle) {
    for (const char* key : kSunDateKeys) sun.erase(key);
  }
  if (is_angle) {
    const Json direction = sun.value("direction", Json());
    sun.erase("direction");
    if (!direction.is_array() || direction.size() != 3 || !direction[0].is_number() ||
        !direction[1].is_number() || !direction[2].is_number()) {
      return;
    }
    const SunAngles angles = angles_of(
        {direction[0].get<double>(), direction[1].get<double>(), direction[2].get<double>()});
    sun["azimuth_deg"] = angles.azimuth_deg;
    sun["elevation_deg"] = angles.elevation_deg;
  }
}

/// Removes the colours of a balloon when its palette is set.
void settle_colors(Json& document, const Pointer& pointer) {
  if (pointer.size() < 2 || pointer.back() != "palette") return;
  Pointer balloon = pointer;
  balloon.pop_back();
  std::string path;
  for (const std::string& token : balloon) path += "/" + token;
  const Json::json_pointer place(path);
  if (document.contains(place) && document[place].is_object()) document[place].erase("colors");
}

}  // namespace

Pointer parse_pointer(const std::string& text) {
  if (text.empty() || text[0] != '/') bad_pointer(text, "a JSON pointer such as /image/width");
  Pointer pointer;
  std::size_t start = 1;
  while (start <= text.size()) {
    const std::size_t end = std::min(text.find('/', start), text.size());
    pointer.push_back(unescape(text.substr(start, end - start), text));
    start = end + 1;
  }
  if (pointer.size() > kMaxDepth) bad_pointer(text, fmt::format("at most {} levels", kMaxDepth));
  return pointer;
}

void expand_short_forms(Json& document) {
  if (document.is_object() && document.contains("terrain") && document["terrain"].is_object()) {
    const auto source = document["terrain"].find("source");
    if (source != document["terrain"].end() && source->is_string()) {
      *source = Json::array({*source});
    }
  }
  const auto biome = document.find("biome");
  if (document.is_object() && biome != document.end() && biome->is_string()) {
    *biome = Json{{"kind", *biome}};
  }
  const Json::json_pointer kind("/biome/kind");
  if (document.is_object() && document.contains(kind) && document[kind] == kLeftOutBiome) {
    document["biome"].erase("kind");
  }
}

void apply_overrides(Json& document, const std::vector<Override>& overrides, Faults& faults) {
  for (const Override& change : overrides) {
    const Pointer pointer = parse_pointer(change.pointer);
    settle_sun(document, pointer);
    settle_colors(document, pointer);
    reach(document, usual_values(document), pointer, faults.name()) = override_value(change);
    faults.set_overridden(pointer);
    expand_short_forms(document);
  }
}

BiomeKind biome_of(const Json& document) {
  return document.is_object() && document.contains("biome")
             ? enum_of(document["biome"], "kind", BiomeKind::snow)
             : BiomeKind::snow;
}

bool has_source(const Json& document) {
  const Json::json_pointer source("/terrain/source");
  if (!document.is_object() || !document.contains(source)) return false;
  const Json& names = document[source];
  return names.is_array() && !names.empty();
}

Season season_of(const Json& document) {
  return document.is_object() && document.contains("biome")
             ? enum_of(document["biome"], "season", Season::summer)
             : Season::summer;
}

View view_of(const Json& document) {
  return document.is_object() && document.contains("camera")
             ? enum_of(document["camera"], "view", View::outside)
             : View::outside;
}

Mood mood_of(const Json& document) {
  return enum_of(document, "mood", Mood::none);
}

Quality quality_of(const Json& document) {
  return enum_of(document, "quality", Quality::standard);
}

}  // namespace detail

Override parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    throw Error(ErrorKind::usage, fmt::format("--set: found {}, expected /json/pointer=value",
                                              detail::describe(detail::Json(text))));
  }
  Override result{text.substr(0, equals), text.substr(equals + 1)};
  detail::parse_pointer(result.pointer);
  return result;
}

}  // namespace aerostat::scene

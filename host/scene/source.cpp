#include "scene/source.hpp"

#include <cmath>
#include <iterator>

#include "scene/overrides.hpp"
#include "scene/palettes.hpp"
#include "scene/read.hpp"
#include "scene/sun_angles.hpp"
#include "scene/write.hpp"

namespace aerostat::scene {

using detail::Json;
using detail::OrderedJson;
using detail::Pointer;

namespace {

constexpr const char* kName = "scene";

/// Returns degrees rounded to nine decimals, so that the angles of a direction show no rounding
/// errors.
double rounded(double degrees) {
  return std::round(degrees * 1e9) / 1e9 + 0.0;
}

/// Returns a scene as JSON, with the sun's angles beside its direction.
Json shown(const Scene& scene) {
  Json json(detail::to_json(scene));
  const detail::SunAngles angles = detail::angles_of(scene.sun.direction);
  json["sun"]["azimuth_deg"] = rounded(angles.azimuth_deg);
  json["sun"]["elevation_deg"] = rounded(angles.elevation_deg);
  return json;
}

Json::json_pointer json_pointer(const std::string& text) {
  detail::parse_pointer(text);  // checks the text and throws our own errors
  return Json::json_pointer(text);
}

const Json* found(const Json& in, const Json::json_pointer& pointer) {
  return in.contains(pointer) ? &in.at(pointer) : nullptr;
}

/// Removes from an object all values that equal those of `usual`, and objects that are then
/// empty.
void prune(Json& object, const Json& usual) {
  for (auto at = object.begin(); at != object.end();) {
    const auto same = usual.find(at.key());
    const bool known = usual.is_object() && same != usual.end();
    if (at->is_object()) prune(*at, known ? *same : Json::object());
    const bool empty = at->is_object() && at->empty();
    at = empty || (known && *at == *same) ? object.erase(at) : std::next(at);
  }
}

/// Returns the value with its keys in the order of `model`, followed by all other keys.
OrderedJson ordered(const Json& value, const OrderedJson& model) {
  if (!value.is_object()) return OrderedJson(value);
  OrderedJson result = OrderedJson::object();
  const OrderedJson nothing;
  if (model.is_object()) {
    for (const auto& [key, child] : model.items()) {
      if (value.contains(key)) result[key] = ordered(value[key], child);
    }
  }
  for (const auto& [key, child] : value.items()) {
    if (!result.contains(key)) result[key] = ordered(child, nothing);
  }
  return result;
}

void erase(Json& document, const Pointer& pointer, std::size_t depth, const Json& usual) {
  const std::string& token = pointer[depth];
  if (document.is_array()) {
    const auto at = Json::json_pointer("/" + token);
    if (!document.contains(at) || !usual.contains(at)) return;
    if (depth + 1 == pointer.size()) {
      document[at] = usual.at(at);
    } else {
      erase(document[at], pointer, depth + 1, usual.at(at));
    }
    return;
  }
  if (!document.is_object() || !document.contains(token)) return;
  if (depth + 1 == pointer.size()) {
    // Models, artwork and species have no other file, and a lamp must have a position.
    const bool in_list = pointer[0] == "objects" ||
                         (depth > 1 && pointer[depth - 2] == "artwork") ||
                         (depth > 1 && pointer[depth - 2] == "species") ||
                         (depth > 0 && pointer[depth - 1] == "envelope");
    if (in_list && token == "file") return;
    const bool required = pointer[0] == "lights" && token == "position";
    required ? void(document[token] = usual.at(token)) : void(document.erase(token));
    return;
  }
  const bool known = usual.is_object() && usual.contains(token);
  erase(document[token], pointer, depth + 1, known ? usual[token] : Json());
  if (document[token].is_object() && document[token].empty()) document.erase(token);
}

/// Appends the changes that turn the members of `base` into those of `here`. Returns false if no
/// list of changes can express them.
bool collect_changes(const Json& base, const Json& here, const Json& shown_here,
                     const Json::json_pointer& at, std::vector<Override>& changes) {
  for (const auto& [key, value] : here.items()) {
    const auto former = base.find(key);
    const bool known = base.is_object() && former != base.end();
    if (known && *former == value) continue;
    if (value.is_object()) {
      if (!collect_changes(known ? *former : Json::object(), value, shown_here, at / key, changes))
        return false;
    } else {
      changes.push_back({(at / key).to_string(), value.dump()});
    }
  }
  for (const auto& [key, value] : base.items()) {
    if (here.contains(key) || key == "$schema") continue;
    if (value.is_object()) {
      if (!collect_changes(value, Json::object(), shown_here, at / key, changes)) return false;
      continue;
    }
    const Json* const now = found(shown_here, at / key);
    if (now == nullptr) return false;
    if (*now != value) changes.push_back({(at / key).to_string(), now->dump()});
  }
  return true;
}

}  // namespace

struct SceneSource::State {
  explicit State(Json given) : State(std::move(given), detail::Faults(kName)) {}
  State(Json given, detail::Faults faults)
      : document(std::move(given)), scene(detail::read_document(document, faults)) {
    fill_in();
  }

  void fill_in() {
    Scene usual = detail::usual_scene(document);
    for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
      dress(usual.balloons.emplace_back(), palette_of_place(i));
    }
    usual.lights.resize(scene.lights.size());
    usual.objects.resize(scene.objects.size());
    usual.vegetation.species.resize(scene.vegetation.species.size());
    usual_values = shown(usual);
    // Biome, season, view, mood and quality choose all other defaults. Their own defaults are these
    // words.
    usual_values["biome"]["kind"] = "snow";
    usual_values["biome"]["season"] = "summer";
    usual_values["camera"]["view"] = "outside";
    usual_values["mood"] = "none";
    usual_values["quality"] = "standard";
    values = shown(scene);
    if (!document.contains("sun")) return;
    for (const auto& [key, value] : document["sun"].items()) values["sun"][key] = value;
  }

  std::string print(Json left) const;

  Json document;
  Scene scene;
  Json values, usual_values;
};

/// Returns the text of a document, which is that of the state with other names of files at most.
std::string SceneSource::State::print(Json left) const {
  Json usual = usual_values;
  // The version is always written, because without it the file cannot be read.
  usual.erase("version");
  // Lists have no default elements, so that each element is written in full.
  usual["balloons"] = usual["lights"] = usual["objects"] = Json::array();
  usual["vegetation"]["species"] = Json::array();
  usual["biome"].erase("kind");
  left["biome"]["kind"] = values["biome"]["kind"];
  // Angles are left out only if both equal their defaults. An angle that is left out alone would
  // be worked out from the default direction when the text is read, with other rounding.
  const bool both = left.contains("sun") && left["sun"].contains("azimuth_deg") &&
                    left["sun"].contains("elevation_deg") &&
                    left["sun"]["azimuth_deg"] == usual["sun"]["azimuth_deg"] &&
                    left["sun"]["elevation_deg"] == usual["sun"]["elevation_deg"];
  if (!both) usual["sun"].erase("azimuth_deg"), usual["sun"].erase("elevation_deg");
  prune(left, usual);
  if (left["biome"].size() == 1) left["biome"] = left["biome"]["kind"];
  OrderedJson model = OrderedJson::object();
  model["$schema"] = nullptr;
  model.update(detail::to_json(scene));
  return detail::print_json(ordered(left, model));
}

SceneSource::SceneSource() : SceneSource(std::make_shared<State>(Json{{"version", 1}})) {}

SceneSource SceneSource::from_file(const std::filesystem::path& path) {
  const std::string text = detail::read_bytes(path);
  detail::Faults faults(path.string(), text);
  Json document = detail::parse_document(text, faults);
  detail::name_files_from(path.parent_path(), document);
  return SceneSource(std::make_shared<State>(std::move(document), std::move(faults)));
}

SceneSource SceneSource::from_text(const std::string& text, const std::string& name) {
  detail::Faults faults(name, text);
  Json document = detail::parse_document(text, faults);
  return SceneSource(std::make_shared<State>(std::move(document), std::move(faults)));
}

const Scene& SceneSource::scene() const {
  return state_->scene;
}

SceneSource SceneSource::with(const std::vector<Override>& changes) const {
  Json document = state_->document;
  detail::Faults faults(kName);
  detail::apply_overrides(document, changes, faults);
  return SceneSource(std::make_shared<State>(std::move(document)));
}

SceneSource SceneSource::without(const std::vector<std::string>& pointers) const {
  Json document = state_->document;
  for (const std::string& pointer : pointers) {
    erase(document, detail::parse_pointer(pointer), 0, state_->usual_values);
  }
  return SceneSource(std::make_shared<State>(std::move(document)));
}

std::string SceneSource::value(const std::string& pointer) const {
  const Json* const value = found(state_->values, json_pointer(pointer));
  return value == nullptr ? std::string() : value->dump();
}

bool SceneSource::gives(const std::string& pointer) const {
  return state_->document.contains(json_pointer(pointer));
}

bool SceneSource::differs(const std::string& pointer) const {
  const auto at = json_pointer(pointer);
  const Json* const value = found(state_->values, at);
  const Json* const usual = found(state_->usual_values, at);
  if (value == nullptr || usual == nullptr) return value != usual;
  return *value != *usual;
}

std::string SceneSource::text() const {
  return state_->print(state_->document);
}

std::string SceneSource::text_in(const std::filesystem::path& folder) const {
  Json document = state_->document;
  detail::name_files_below(folder, document);
  return state_->print(std::move(document));
}

std::vector<std::string> SceneSource::files_outside(const std::filesystem::path& folder) const {
  Json document = state_->document;
  detail::name_files_below(folder, document);
  return detail::absolute_files(document);
}

std::optional<std::vector<Override>> SceneSource::changes_from(const SceneSource& base) const {
  std::vector<Override> changes;
  const bool possible = collect_changes(base.state_->document, state_->document, state_->values,
                                        Json::json_pointer(), changes);
  if (!possible) return std::nullopt;
  return changes;
}

}  // namespace aerostat::scene

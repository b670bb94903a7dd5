#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "labels/place_limits.hpp"
#include "labels/places.hpp"
#include "scene/json_text.hpp"
#include "scene/locate.hpp"
#include "track/text.hpp"

namespace aerostat::labels {
namespace {

using scene::detail::Json;
using scene::detail::Pointer;

/// Collects the named points of a document.
class Reader {
 public:
  Reader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  std::vector<NamedPlace> read() {
    const Json document = scene::detail::parse_json(text_, name_);
    const std::string type = word(document, "type");
    if (type == "Feature") {
      feature(document, {});
    } else if (type == "FeatureCollection") {
      const Json& features = member(document, "features");
      if (!features.is_array()) fail({"features"}, features, "an array of features");
      for (std::size_t i = 0; i < features.size(); ++i) {
        feature(features[i], {"features", std::to_string(i)});
      }
    } else {
      fail({}, document, "GeoJSON with the type FeatureCollection or Feature");
    }
    require_places(places_, name_);
    return std::move(places_);
  }

 private:
  [[noreturn]] void fail(const Pointer& pointer, const std::string& found,
                         const std::string& expected) const {
    const scene::detail::TextPlace place = scene::detail::locate(text_, pointer);
    throw Error(ErrorKind::bad_data,
                fmt::format("{}:{}:{}: {}: found {}, expected {}", name_, place.line, place.column,
                            scene::detail::to_string(pointer), found, expected));
  }
  [[noreturn]] void fail(const Pointer& pointer, const Json& found,
                         const std::string& expected) const {
    fail(pointer, scene::detail::describe(found), expected);
  }

  static const Json& member(const Json& object, const char* key) {
    static const Json nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(key);
    return found == object.end() ? nothing : *found;
  }

  static std::string word(const Json& object, const char* key) {
    const Json& value = member(object, key);
    return value.is_string() ? value.get<std::string>() : std::string();
  }

  static Pointer below(Pointer pointer, std::initializer_list<const char*> keys) {
    pointer.insert(pointer.end(), keys.begin(), keys.end());
    return pointer;
  }

  void feature(const Json& feature, const Pointer& at) {
    if (!feature.is_object()) fail(at, feature, "a feature");
    const Json& geometry = member(feature, "geometry");
    const Json& properties = member(feature, "properties");
    const std::string type = word(geometry, "type");
    if (type != "Point" && type != "MultiPoint") return;
    const std::string label = track::clean_text(word(properties, "name"));
    if (track::trimmed(label).empty()) return;
    NamedPlace place;
    place.name = track::trimmed(label);
    place.height_m = height(properties, at);
    const Json& coordinates = member(geometry, "coordinates");
    const Pointer pointer = below(at, {"geometry", "coordinates"});
    if (type == "Point") return point(place, coordinates, pointer);
    if (!coordinates.is_array()) fail(pointer, coordinates, "an array of points");
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      point(place, coordinates[i], below(pointer, {std::to_string(i).c_str()}));
    }
  }

  std::optional<double> height(const Json& properties, const Pointer& at) const {
    for (const char* key : {"ele", "elevation"}) {
      const Json& value = member(properties, key);
      if (value.is_null()) continue;
      if (value.is_number()) return value.get<double>();
      const auto number =
          value.is_string() ? track::number_of(value.get<std::string>()) : std::nullopt;
      if (!number) fail(below(at, {"properties", key}), value, "a height in metres");
      return number;
    }
    return std::nullopt;
  }

  void point(NamedPlace place, const Json& coordinates, const Pointer& at) {
    const bool is_point = coordinates.is_array() && coordinates.size() >= 2 &&
                          coordinates[0].is_number() && coordinates[1].is_number();
    if (!is_point) fail(at, coordinates, "[longitude, latitude] in degrees");
    place.place = {coordinates[1].get<double>(), coordinates[0].get<double>()};
    const bool has_height = coordinates.size() > 2 && coordinates[2].is_number();
    if (!place.height_m && has_height) place.height_m = coordinates[2].get<double>();
    const std::string fault = fault_of(place);
    if (!fault.empty()) fail(at, fault, "[longitude, latitude, height] in degrees and metres");
    places_.push_back(std::move(place));
  }

  std::string_view text_;
  std::string name_;
  std::vector<NamedPlace> places_;
};

}  // namespace

std::vector<NamedPlace> places_of_geojson(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

}  // namespace aerostat::labels

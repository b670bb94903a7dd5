#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "scene/enum_names.hpp"
#include "scene/fields.hpp"
#include "scene/json_print.hpp"
#include "scene/schema.hpp"

namespace aerostat::scene::detail {

namespace {

/// The name under which the schema defines a struct that it uses more than once.
template <class S>
constexpr const char* kDefinition = nullptr;
template <>
constexpr const char* kDefinition<Balloon> = "balloon";
template <>
constexpr const char* kDefinition<Material> = "material";
template <>
constexpr const char* kDefinition<GeoPoint> = "place";
template <>
constexpr const char* kDefinition<FlightTrack> = "track";

/// The count of numbers in an array of numbers, or 0 for another type.
template <class T>
constexpr std::size_t kNumberCount = 0;
template <>
constexpr std::size_t kNumberCount<dvec2> = 2;
template <>
constexpr std::size_t kNumberCount<double[2]> = 2;
template <>
constexpr std::size_t kNumberCount<vec3> = 3;
template <>
constexpr std::size_t kNumberCount<dvec3> = 3;

OrderedJson number_json(double value) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (value == std::trunc(value) && std::abs(value) <= kExact) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

std::string text_of(const About& about) {
  return fmt::format(fmt::runtime(std::string(about.text) + about.ending),
                     fmt::arg("from", number_json(about.from).dump()),
                     fmt::arg("to", number_json(about.to).dump()));
}

void add_range(const About& about, OrderedJson& rule) {
  rule[about.is_above ? "exclusiveMinimum" : "minimum"] = number_json(about.from);
  rule["maximum"] = number_json(about.to);
}

template <class Enum>
OrderedJson words_of(const About& about) {
  auto names = enum_names<Enum>();
  if (about.word_count > 0) names = names.first(about.word_count);
  std::vector<std::string> words(names.begin(), names.end());
  if (about.left_out_word != nullptr) words.emplace_back(about.left_out_word);
  return words;
}

OrderedJson open_object(const char* text) {
  return {{"description", text}, {"type", "object"}, {"additionalProperties", false}};
}

/// Makes the rules of the schema, and keeps those that it defines once.
class Rules {
 public:
  /// Returns the rule of a struct that has a table.
  template <class S>
  OrderedJson object_rule() {
    OrderedJson rule = open_object(kTable<S>.text);
    OrderedJson required = OrderedJson::array(), properties = OrderedJson::object();
    for_each_field<S>([&](const auto& field) {
      if (field.about.is_required) required.push_back(field.key);
      properties[field.key] = rule_of(field);
    });
    if (!required.empty()) rule["required"] = required;
    rule["properties"] = properties;
    return rule;
  }

  const OrderedJson& definitions() const { return definitions_; }

 private:
  template <class S, class T>
  OrderedJson rule_of(const Field<S, T>& field) {
    return rule<T>(field.about);
  }
  template <class T>
  OrderedJson rule_of(const OnlyRead<T>& field) {
    return rule<T>(field.about);
  }

  template <class T>
  OrderedJson rule(const About& about) {
    OrderedJson rule = {{"description", text_of(about)}};
    if constexpr (std::is_enum_v<T>) {
      rule["type"] = "string";
      rule["enum"] = words_of<T>(about);
    } else if constexpr (std::is_same_v<T, bool>) {
      rule["type"] = "boolean";
    } else if constexpr (std::is_same_v<T, std::string>) {
      rule["type"] = "string";
    } else if constexpr (std::is_arithmetic_v<T>) {
      rule["type"] = std::is_integral_v<T> ? "integer" : "number";
      add_range(about, rule);
    } else if constexpr (kNumberCount<T> > 0) {
      rule["type"] = "array";
      for (const char* key : {"minItems", "maxItems"}) rule[key] = kNumberCount<T>;
      rule["items"] = {{"type", "number"}};
      add_range(about, rule["items"]);
    } else {
      return structured(about, std::type_identity<T>());
    }
    return rule;
  }

  template <class T>
  OrderedJson structured(const About& about, std::type_identity<std::optional<T>>) {
    return rule<T>(about);
  }

  template <class T>
  OrderedJson structured(const About& about, std::type_identity<std::vector<T>>) {
    OrderedJson rule = {{"description", text_of(about)}, {"type", "array"}};
    if (about.from > 0.0) rule["minItems"] = number_json(about.from);
    rule["maxItems"] = number_json(about.to);
    if constexpr (kNumberCount < T >> 0) {
      rule["items"] = this->rule<T>(color(about.part_text));
    } else if constexpr (std::is_enum_v<T>) {
      rule["items"] = {{"type", "string"}, {"enum", words_of<T>({})}};
    } else {
      rule["items"] = structured({}, std::type_identity<T>());
    }
    return rule;
  }

  /// A single text may stand for a list of one.
  OrderedJson structured(const About& about, std::type_identity<std::vector<std::string>>) {
    const OrderedJson one = rule<std::string>(text(about.part_text));
    const OrderedJson list = {{"description", text_of(about)},
                              {"type", "array"},
                              {"maxItems", number_json(about.to)},
                              {"items", one}};
    return {{"description", text_of(about)}, {"anyOf", OrderedJson::array({one, list})}};
  }

  /// The value of a key is a number, a text or a few numbers.
  static OrderedJson structured(const About& about, std::type_identity<KeyValue>) {
    constexpr int kMostNumbers = 4;
    const OrderedJson number = {{"type", "number"}}, text = {{"type", "string"}};
    const OrderedJson numbers = {{"description", text_of(about)},
                                 {"type", "array"},
                                 {"minItems", 1},
                                 {"maxItems", kMostNumbers},
                                 {"items", number}};
    return {{"description", text_of(about)},
            {"anyOf", OrderedJson::array({number, text, numbers})}};
  }

  OrderedJson structured(const About& about,
                         std::type_identity<std::array<Material, kMaterialCount>>) {
    OrderedJson rule = open_object(about.text);
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
      rule["properties"][material_name(static_cast<MaterialId>(i))] =
          structured({}, std::type_identity<Material>());
    }
    return rule;
  }

  OrderedJson structured(const About& about, std::type_identity<Biome>) {
    const OrderedJson name = {{"description", about.part_text},
                              {"type", "string"},
                              {"enum", words_of<BiomeKind>(word("").or_left_out(kLeftOutBiome))}};
    return {{"description", text_of(about)},
            {"anyOf", OrderedJson::array({name, object_rule<Biome>()})}};
  }

  template <class S>
  OrderedJson structured(const About&, std::type_identity<S>) {
    if constexpr (kDefinition<S> == nullptr) {
      return object_rule<S>();
    } else {
      if (!definitions_.contains(kDefinition<S>)) {
        definitions_[kDefinition<S>] = object_rule<S>();
      }
      return {{"$ref", std::string("#/definitions/") + kDefinition<S>}};
    }
  }

  OrderedJson definitions_ = OrderedJson::object();
};

}  // namespace

OrderedJson make_schema() {
  Rules rules;
  const OrderedJson scene = rules.object_rule<Scene>();
  OrderedJson schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                        {"$id", "aerostat-scene.schema.json"},
                        {"title", "aerostat scene"}};
  for (const char* key : {"description", "type", "additionalProperties"}) schema[key] = scene[key];
  schema["required"] = {"version"};
  OrderedJson& properties = schema["properties"];
  properties["$schema"] = {{"description", "Path by which editors find this schema."},
                           {"type", "string"}};
  properties["version"] = {{"description", "Version of the format, which is 1."},
                           {"type", "integer"},
                           {"enum", OrderedJson::array({1})}};
  properties.update(scene["properties"]);
  schema["definitions"] = rules.definitions();
  return schema;
}

std::string schema_text() {
  return print_json(make_schema());
}

}  // namespace aerostat::scene::detail

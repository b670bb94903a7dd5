#include "scene/field_rule.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/expected.hpp"
#include "scene/land.hpp"
#include "scene/overrides.hpp"
#include "scene/schema.hpp"

namespace aerostat::scene {

using detail::Json;

namespace {

FieldType type_of(const Json& rule) {
  if (rule.contains("enum")) return FieldType::word;
  const std::string type = rule.value("type", "object");
  if (type == "boolean") return FieldType::boolean;
  if (type == "integer") return FieldType::integer;
  if (type == "number") return FieldType::number;
  if (type == "string") return FieldType::text;
  return type == "array" ? FieldType::array : FieldType::object;
}

void read_range(const Json& rule, FieldRule& field) {
  field.minimum = rule.value("minimum", rule.value("exclusiveMinimum", field.minimum));
  field.maximum = rule.value("maximum", field.maximum);
}

FieldRule read_rule(const Json& rule) {
  FieldRule field;
  field.type = type_of(rule);
  field.description = rule.value("description", "");
  read_range(rule, field);
  if (field.type == FieldType::word) {
    for (const Json& word : rule["enum"]) {
      field.words.push_back(word.is_string() ? word.get<std::string>() : word.dump());
    }
  }
  if (field.type == FieldType::array) {
    field.least_items = rule.value("minItems", 0);
    field.most_items = rule.value("maxItems", 0);
    read_range(rule["items"], field);
  }
  return field;
}

void collect_pointers(const Json& rule, const std::string& pointer,
                      std::vector<std::string>& pointers) {
  const Json& resolved = detail::resolve_rule(rule, detail::schema_document(), "object");
  if (resolved.contains("properties")) {
    for (const auto& [key, child] : resolved["properties"].items()) {
      collect_pointers(child, pointer + "/" + key, pointers);
    }
  } else if (resolved.contains("items") &&
             detail::resolve_rule(resolved["items"], detail::schema_document(), "object")
                 .contains("properties")) {
    collect_pointers(resolved["items"], pointer + "/0", pointers);
  } else {
    pointers.push_back(pointer);
  }
}

}  // namespace

FieldRule field_rule(const std::string& pointer) {
  const Json& schema = detail::schema_document();
  const Json* rule = &schema;
  std::string description;
  for (const std::string& token : detail::parse_pointer(pointer)) {
    const bool is_array = rule->contains("items");
    if (!is_array && !(rule->contains("properties") && (*rule)["properties"].contains(token))) {
      throw Error(ErrorKind::usage, fmt::format("{}: a scene has no such value", pointer));
    }
    if (is_array) description = rule->value("description", "");
    rule = &detail::resolve_rule(detail::child_rule(*rule, token), schema, "object");
  }
  FieldRule field = read_rule(*rule);
  if (field.description.empty()) field.description = description;
  // The word for a biome that is left open is none that a scene has.
  if (pointer == "/biome/kind") std::erase(field.words, kLeftOutBiome);
  return field;
}

std::vector<std::string> field_pointers() {
  std::vector<std::string> pointers;
  collect_pointers(detail::schema_document(), "", pointers);
  return pointers;
}

}  // namespace aerostat::scene

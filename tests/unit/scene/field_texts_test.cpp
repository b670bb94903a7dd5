// Tests that the schema in the folder of scenes and the texts of the window are those of the tables
// of fields.

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "generated_file.hpp"
#include "scene/field_edit.hpp"
#include "scene/scene.hpp"
#include "scene/schema.hpp"

namespace aerostat::scene {
namespace {

using Json = nlohmann::ordered_json;

/// Texts of one translation context, each once, in the order in which they were added.
class Context {
 public:
  explicit Context(std::string name) : name_(std::move(name)) {}

  void add(const std::string& text) {
    const bool known = std::find(texts_.begin(), texts_.end(), text) != texts_.end();
    if (!known && !text.empty()) texts_.push_back(text);
  }

  std::string marked() const {
    std::string result;
    for (const std::string& text : texts_) {
      result += fmt::format("QT_TRANSLATE_NOOP(\"{}\", {})\n", name_, Json(text).dump());
    }
    return result;
  }

 private:
  std::string name_;
  std::vector<std::string> texts_;
};

/// Calls `visit` for every rule in the schema that has a description, in the order of the schema.
void for_each_rule(const Json& node, const std::function<void(const Json&)>& visit) {
  if (node.is_object() && node.contains("description") && node["description"].is_string()) {
    visit(node);
  }
  if (node.is_structured()) {
    for (const Json& child : node) for_each_rule(child, visit);
  }
}

std::string window_texts() {
  Context labels("Controls"), units("Units"), descriptions("Schema"), words("Words");
  for (const FieldEdit& edit : field_edits()) {
    labels.add(edit.label);
    if (edit.none != nullptr) labels.add(edit.none);
    units.add(edit.unit);
  }
  for_each_rule(Json::parse(detail::schema_text()), [&](const Json& rule) {
    descriptions.add(rule["description"]);
    if (rule.value("type", "") != "string") return;
    for (const Json& word : rule.value("enum", Json::array())) words.add(word);
  });
  for (std::size_t i = 0; i < kMaterialCount; ++i) {
    words.add(material_name(static_cast<MaterialId>(i)));
  }
  return "// Texts of fields for the translators of the window. lupdate reads this file, and\n"
         "// tests/unit/scene/field_texts_test.cpp writes it.\n" +
         labels.marked() + units.marked() + descriptions.marked() + words.marked();
}

TEST(Generated, SchemaIsMadeFromTheTablesOfFields) {
  test::expect_generated("scenes/aerostat-scene.schema.json", detail::schema_text());
}

TEST(Generated, WindowTextsAreMadeFromTheTablesOfFields) {
  test::expect_generated("host/viewer/field_texts.inc", window_texts());
}

}  // namespace
}  // namespace aerostat::scene

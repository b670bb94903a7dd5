// Tests that the manual's reference of scene files agrees with the schema and the defaults.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "generated_file.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "scene/schema.hpp"

namespace aerostat::scene {
namespace {

using Json = nlohmann::ordered_json;

const std::string kManual = "docs/manual/scene-file.md";
const std::string kMark = "<!-- From here on written by tests/unit/scene/reference_test.cpp -->\n";

/// Builds the reference in Markdown.
class Reference {
 public:
  Reference() : schema_(Json::parse(detail::schema_text())) {
    constexpr BiomeKind kKinds[] = {BiomeKind::snow, BiomeKind::tropical, BiomeKind::sand,
                                    BiomeKind::meadow};
    for (std::size_t i = 0; i < 4; ++i) {
      defaults_[i] = Json::parse(write_text(defaults(kKinds[i], View::outside)));
    }
    section("", schema_, "");
  }

  const std::string& text() const { return text_; }

 private:
  const Json& followed(const Json& rule) const {
    if (rule.contains("$ref")) {
      return schema_.at(Json::json_pointer(rule["$ref"].get<std::string>().substr(1)));
    }
    return rule.contains("anyOf") ? rule["anyOf"].back() : rule;
  }

  /// Adds a table of the keys of an object, then the tables of the objects in it.
  void section(const std::string& pointer, const Json& object, const std::string& description) {
    text_ +=
        fmt::format("\n## {}\n\n{}\n\n| key | value | default | meaning |\n|---|---|---|---|\n",
                    pointer.empty() ? "The whole" : fmt::format("`{}`", pointer),
                    pointer.empty() ? "Keys of the scene itself." : description);
    const Json& properties = object["properties"];
    for (const auto& [key, rule] : properties.items()) row(pointer + "/" + key, key, rule);
    for (const auto& [key, rule] : properties.items()) {
      const Json& inner = followed(rule);
      const std::string path = pointer + "/" + key;
      if (pointer == "/materials" && key != properties.begin().key()) continue;
      if (inner.contains("properties")) {
        section(pointer == "/materials" ? "/materials/OBJECT" : path, inner, inner["description"]);
      } else if (inner.value("items", Json::object()).contains("properties")) {
        section(path + "/0", inner["items"], inner["items"]["description"]);
      }
    }
  }

  void row(const std::string& pointer, const std::string& key, const Json& rule) {
    const Json& inner = followed(rule);
    const bool is_object = inner.contains("properties");
    std::string meaning = rule.value("description", inner.value("description", ""));
    if (is_object && pointer.rfind("/materials/", 0) != 0) meaning += " See below.";
    text_ += fmt::format("| `{}` | {} | {} | {} |\n", key, value_of(rule),
                         is_object ? "" : default_of(pointer), cell(meaning));
  }

  static std::string range_of(const Json& rule) {
    if (!rule.contains("maximum")) return "";
    const bool is_open = rule.contains("exclusiveMinimum");
    return fmt::format("{}{} to {}", is_open ? "above " : "",
                       rule[is_open ? "exclusiveMinimum" : "minimum"].dump(),
                       rule["maximum"].dump());
  }

  std::string value_of(const Json& rule) const {
    if (rule.contains("anyOf")) {
      std::string text;
      for (const Json& one : rule["anyOf"]) {
        text += text.empty() ? "" : ", or ";
        text += one["type"] == "object" ? "an object" : value_of(one);
      }
      return text;
    }
    const Json& inner = followed(rule);
    if (inner.contains("enum")) {
      std::vector<std::string> words;
      for (const Json& word : inner["enum"]) words.push_back(fmt::format("`{}`", word.dump()));
      return fmt::format("{}", fmt::join(words, ", "));
    }
    const std::string type = inner["type"];
    if (type == "array") {
      const Json& item = inner["items"];
      const std::size_t least = inner.value("minItems", std::size_t{0}), most = inner["maxItems"];
      const std::string count =
          least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
      return fmt::format("{} of: {}", count, value_of(item));
    }
    const std::string range = range_of(inner);
    return range.empty() ? type : type + ", " + range;
  }

  /// Escapes bars, because a bar would end the cell.
  static std::string cell(const std::string& text) {
    std::string escaped;
    for (const char character : text) {
      if (character == '|') escaped += '\\';
      escaped += character;
    }
    return escaped;
  }

  static std::string shown(const Json& value) {
    if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
    if (!value.is_array()) return value.dump();
    std::vector<std::string> parts;
    for (const Json& part : value) parts.push_back(shown(part));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }

  /// Returns the default of a key, or one default for each biome if they differ. Returns nothing if
  /// the key is left out, or if its default depends on the element of an array or on the material.
  std::string default_of(const std::string& pointer) const {
    const Json::json_pointer at(pointer);
    std::array<std::string, 4> values;
    for (std::size_t i = 0; i < 4; ++i) {
      if (pointer.find("/0/") != std::string::npos || !defaults_[i].contains(at)) return "";
      values[i] = fmt::format("`{}`", shown(defaults_[i][at]));
    }
    if (std::count(values.begin(), values.end(), values[0]) == 4) return values[0];
    return fmt::format("snow {}, tropical {}, sand {}, meadow {}", values[0], values[1], values[2],
                       values[3]);
  }

  Json schema_;
  std::array<Json, 4> defaults_;
  std::string text_;
};

TEST(Generated, ReferenceOfTheManualIsWhatSchemaAndDefaultsSay) {
  const std::string page = test::file_text(AEROSTAT_SOURCE_DIR "/" + kManual);
  const auto mark = page.find(kMark);
  ASSERT_NE(mark, std::string::npos) << kManual;
  test::expect_generated(kManual, page.substr(0, mark + kMark.size()) + Reference().text());
}

}  // namespace
}  // namespace aerostat::scene

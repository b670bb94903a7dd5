// Tests that the numbers in the schema's texts agree with the schema and the program.
#include <cmath>
#include <cstdint>
#include <regex>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/field_rule.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {
namespace {

/// Returns a number as the texts write it, such as 1000000 or 0.1.
std::string number_text(double value) {
  return value == std::trunc(value) ? std::to_string(static_cast<std::int64_t>(value))
                                    : fmt::format("{}", value);
}

/// Returns a text without its parentheses: "0 (none) to 10" becomes "0 to 10".
std::string plain(const std::string& text) {
  return std::regex_replace(text, std::regex(R"( \([^)]*\))"), "");
}

bool has_range(const FieldRule& rule) {
  const bool counts = rule.type == FieldType::integer || rule.type == FieldType::number ||
                      rule.type == FieldType::array;
  // For points in space, only the manual's reference states the range.
  const bool says_range = std::regex_search(plain(rule.description), std::regex(R"(\d to -?\d)"));
  if (rule.type == FieldType::array && !says_range) return false;
  return counts && rule.minimum > -1e299 && rule.maximum < 1e299 && rule.maximum > rule.minimum;
}

TEST(SchemaText, SaysTheRangeOfEveryNumber) {
  int ranges = 0;
  for (const std::string& pointer : field_pointers()) {
    const FieldRule rule = field_rule(pointer);
    if (!has_range(rule)) continue;
    ++ranges;
    const std::string range = number_text(rule.minimum) + " to " + number_text(rule.maximum);
    EXPECT_NE(plain(rule.description).find(range), std::string::npos)
        << pointer << " is " << range << ", but its text says: " << rule.description;
  }
  EXPECT_GT(ranges, 80);
}

TEST(SchemaText, SaysWhatAQualitySets) {
  const std::string text = plain(field_rule("/quality").description);
  const char* const words[] = {"draft", "standard", "final"};
  for (const Quality quality : {Quality::draft, Quality::standard, Quality::final}) {
    Scene scene;
    set_quality(scene, quality);
    const std::string sets = fmt::format(
        "{}, {}, {}, {} with {}", scene.image.spp, scene.image.adaptive_threshold,
        scene.sun.soft_shadows, scene.sky.ambient_occlusion, words[static_cast<int>(quality)]);
    EXPECT_NE(text.find(sets), std::string::npos) << sets << " is not in: " << text;
  }
}

}  // namespace
}  // namespace aerostat::scene

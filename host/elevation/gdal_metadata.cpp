#include "elevation/gdal_metadata.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

std::string unescaped(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  std::string result;
  while (!text.empty()) {
    char next = text.front();
    std::size_t length = 1;
    for (const auto& [entity, character] : kEntities) {
      if (text.substr(0, entity.size()) != entity) continue;
      next = character;
      length = entity.size();
    }
    result += next;
    text.remove_prefix(length);
  }
  return result;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Returns the value of an attribute in the text of a tag, or an empty text.
std::string attribute(std::string_view tag, const std::string& name) {
  const std::string start = " " + name + "=\"";
  const std::size_t at = tag.find(start);
  if (at == std::string_view::npos) return "";
  const std::string_view rest = tag.substr(at + start.size());
  return unescaped(rest.substr(0, rest.find('"')));
}

void take(const std::string& name, const std::string& role, const std::string& value,
          GdalMetadata& result) {
  const std::optional<double> number = number_of(value);
  const bool is_finite = number && std::isfinite(*number);
  if (role == "scale" && is_finite && *number != 0.0) result.scale = number;
  if (role == "offset" && is_finite) result.offset = number;
  if (role == "unittype") result.unit = value;
  if (name == "PIXELTYPE" && value == "SIGNEDBYTE") result.signed_bytes = true;
  if (name == "LAYER_TYPE" && lower_case(value) == "thematic") result.thematic = true;
}

}  // namespace

GdalMetadata gdal_metadata_of(const std::string& xml) {
  GdalMetadata result;
  const std::string_view text = xml;
  constexpr std::string_view kOpen = "<Item", kClose = "</Item>";
  for (std::size_t at = text.find(kOpen); at != std::string_view::npos; at = text.find(kOpen, at)) {
    const std::size_t end_of_tag = text.find('>', at);
    if (end_of_tag == std::string_view::npos) break;
    const std::string_view tag = text.substr(at, end_of_tag - at);
    at = end_of_tag + 1;
    if (tag.ends_with('/')) continue;
    const std::size_t close = text.find(kClose, at);
    if (close == std::string_view::npos) break;
    const std::string value = trimmed(unescaped(text.substr(at, close - at)));
    at = close + kClose.size();
    const std::string band = attribute(tag, "sample");
    if (!band.empty() && band != "0") continue;
    take(attribute(tag, "name"), attribute(tag, "role"), value, result);
  }
  return result;
}

}  // namespace aerostat::elevation

#include "geo/crs_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

namespace aerostat::geo {
namespace {

/// The parameters of PROJ that describe a system without leading to a file.
constexpr std::array kParameters{
    "proj",    "datum",   "ellps",     "a",       "b",        "rf",     "f",
    "es",      "R",       "R_A",       "lat_0",   "lat_1",    "lat_2",  "lat_ts",
    "lon_0",   "lonc",    "alpha",     "gamma",   "k",        "k_0",    "x_0",
    "y_0",     "zone",    "south",     "units",   "to_meter", "vunits", "pm",
    "axis",    "no_defs", "vto_meter", "towgs84", "type",     "wktext", "over",
    "no_uoff", "lat_b",   "h",         "sweep",   "approx",   "no_off", "nadgrids",
    "lon_1",   "lon_2",   "o_proj",    "o_lat_p", "o_lon_p",  "m",      "n"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// Returns whether a text names grids other than "@null", which stands for no grid.
bool names_grids(const std::string& lower_text) {
  constexpr std::string_view kKey = "grids";
  for (std::size_t at = lower_text.find(kKey); at != std::string::npos;
       at = lower_text.find(kKey, at + 1)) {
    std::size_t value = at + kKey.size();
    while (value < lower_text.size() && std::isspace(static_cast<unsigned char>(lower_text[value])))
      ++value;
    if (value >= lower_text.size() || lower_text[value] != '=') continue;
    const bool null_grid = lower_text.compare(value, 6, "=@null") == 0 && at >= 3 &&
                           lower_text.compare(at - 3, 3, "nad") == 0;
    const std::size_t end = value + 6;
    const bool ends = end >= lower_text.size() || lower_text[end] == '"' ||
                      std::isspace(static_cast<unsigned char>(lower_text[end]));
    if (!null_grid || !ends) return true;
  }
  return false;
}

std::string refusal_of_proj_string(const std::string& text) {
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word.front() == '+') word.erase(0, 1);
    const std::string key = word.substr(0, word.find('='));
    if (key == "step" || word == "proj=pipeline") return "it is a pipeline";
    if (std::find(kParameters.begin(), kParameters.end(), key) == kParameters.end()) {
      return fmt::format("the parameter \"{}\" is not allowed here", shortened(key));
    }
  }
  return "";
}

}  // namespace

std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 70;
  std::string result;
  for (const char c : text.substr(0, kMost)) {
    result += std::iscntrl(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
  }
  // A cut must not leave a part of a character of several bytes.
  if (text.size() > kMost) {
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80)
      result.pop_back();
    if (!result.empty() && static_cast<unsigned char>(result.back()) >= 0x80) result.pop_back();
    result += "...";
  }
  return result;
}

std::string refusal_of_crs_text(const std::string& text) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return "it is empty";
  if (text.size() > kLongestCrsText) {
    return fmt::format("it has {} characters, and at most {} are read", text.size(),
                       kLongestCrsText);
  }
  if (has(text, std::string_view("\0", 1))) return "it has a zero byte";
  const std::string all = lower(text);
  const std::size_t first = all.find_first_not_of(" \t\r\n");
  const bool is_wkt = has(all, "[") || has(all, "(\"");
  if (all[first] == '{') return "PROJJSON is not read";
  if (names_grids(all) || has(all, "parameterfile")) return "names of grids are not allowed here";
  if (has(all, "proj-based")) return "operations of PROJ are not allowed here";
  if (is_wkt) return "";
  if (has(all, "://")) return "URLs are not read";
  if (has(all, "+init=") || all.compare(first, 5, "init=") == 0) {
    return "lists of definitions are not read; write \"EPSG:32632\" instead of "
           "\"+init=epsg:32632\"";
  }
  if (all[first] == '@' || all[first] == '/' || all[first] == '.' || all[first] == '~' ||
      has(all, "\\") || has(all, "../")) {
    return "names of files are not read";
  }
  if (has(all, "proj=") || all[first] == '+') return refusal_of_proj_string(text);
  return "";
}

}  // namespace aerostat::geo

#include "elevation/side_files.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/bytes.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

constexpr std::uint64_t kMostBytes = 65536;

/// Returns the text of a small regular file, or an empty text.
std::string text_of(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return "";
  if (std::filesystem::file_size(path, code) > kMostBytes || code) return "";
  try {
    const std::vector<std::uint8_t> bytes = read_whole(path, kMostBytes);
    return std::string(bytes.begin(), bytes.end());
  } catch (const Error&) {
    return "";
  }
}

std::string text_beside(std::filesystem::path path, const std::string& ending) {
  for (const bool upper : {false, true}) {
    std::string name = ending;
    if (upper) {
      for (char& c : name) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
      }
    }
    path.replace_extension(name);
    if (std::string text = text_of(path); !text.empty()) return text;
  }
  return "";
}

bool is_wkt(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string::npos) return false;
  const std::string head = lower_case(std::string_view(text).substr(first, 16));
  for (const char* word :
       {"projcs[", "geogcs[", "projcrs[", "geogcrs[", "compd_cs[", "compoundcrs[", "boundcrs[",
        "geodcrs[", "geodeticcrs[", "projectedcrs[", "geographiccrs["}) {
    if (head.starts_with(word)) return true;
  }
  return false;
}

/// Returns the WKT in the file that GDAL writes beside a raster, or an empty text. Whatever else
/// such a file says is left aside.
std::string wkt_of_aux_xml(const std::string& xml) {
  const std::size_t tag = xml.find("<SRS");
  const std::size_t start = tag == std::string::npos ? tag : xml.find('>', tag);
  const std::size_t end = start == std::string::npos ? start : xml.find("</SRS>", start);
  if (end == std::string::npos) return "";
  std::string wkt;
  for (std::size_t at = start + 1; at < end;) {
    const bool is_quote = xml.compare(at, 6, "&quot;") == 0;
    wkt += is_quote ? '"' : xml[at];
    at += is_quote ? 6 : 1;
  }
  return is_wkt(wkt) ? wkt : "";
}

/// Returns the code of the datum in an old .prj, as the number of its degrees and the number from
/// which its UTM zones count in the north, or zeros.
std::array<int, 2> codes_of_datum(const std::string& datum) {
  if (datum.starts_with("wgs84") || datum == "wgs_1984" || datum == "wge") return {4326, 32600};
  if (datum.starts_with("wgs72")) return {4322, 32200};
  if (datum.starts_with("nad83") || datum == "nar") return {4269, 26900};
  if (datum.starts_with("nad27") || datum == "nas") return {4267, 26700};
  return {0, 0};
}

std::string crs_of_old_prj(const std::string& prj) {
  std::map<std::string, std::string> words;
  std::istringstream lines(prj);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    std::string key, value;
    if (parts >> key >> value) words.emplace(lower_case(key), lower_case(value));
  }
  std::string datum = words["datum"];
  if (datum.empty()) datum = words["spheroid"] == "wgs84" ? "wgs84" : "";
  const auto [degrees, utm] = codes_of_datum(datum);
  if (degrees == 0) return "";
  if (words["projection"] == "geographic") return fmt::format("EPSG:{}", degrees);
  const double zone = number_of(words["zone"]).value_or(0.0);
  if (words["projection"] != "utm" || !(std::abs(zone) >= 1.0 && std::abs(zone) <= 60.0)) return "";
  if (zone < 0.0)
    return utm == 32600 ? fmt::format("EPSG:{}", 32700 + static_cast<int>(-zone)) : "";
  return fmt::format("EPSG:{}", utm + static_cast<int>(zone));
}

}  // namespace

std::optional<std::array<double, 6>> world_of(const std::string& text) {
  std::istringstream words(text);
  std::array<double, 6> world{};
  std::string word;
  for (double& number : world) {
    if (!(words >> word)) return std::nullopt;
    const std::optional<double> value = number_of(word);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    number = *value;
  }
  if (words >> word) return std::nullopt;
  return world;
}

SideFiles side_files_of(const std::filesystem::path& path) {
  SideFiles files;
  files.prj = text_beside(path, ".prj");
  files.hdr = text_beside(path, ".hdr");
  std::filesystem::path aux = path;
  files.aux_wkt = wkt_of_aux_xml(text_of(aux += ".aux.xml"));
  for (const char* ending :
       {".tfw", ".tifw", ".tiffw", ".pgw", ".pngw", ".jgw", ".jpgw", ".wld", ".blw", ".bpw"}) {
    if (!files.world) files.world = world_of(text_beside(path, ending));
  }
  return files;
}

std::string crs_of_prj(const std::string& prj, std::vector<std::string>& notes) {
  if (prj.empty()) return "";
  if (is_wkt(prj)) return prj;
  std::string crs = crs_of_old_prj(prj);
  if (crs.empty()) {
    notes.emplace_back(
        "The .prj file beside it is in no form that is understood, and was left aside.");
  }
  return crs;
}

}  // namespace aerostat::elevation

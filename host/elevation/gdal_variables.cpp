#include "elevation/gdal_variables.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <sstream>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

constexpr std::size_t kMostVariables = 1000;

bool is_plain(const std::string& name) {
  return !name.empty() && name.size() <= 200 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '/' || c == '.' || c == '-' || c == ' ';
         });
}

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos
             ? ""
             : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

std::vector<std::string> variables_in(const std::string& gdalinfo) {
  std::vector<std::string> names;
  std::istringstream lines(gdalinfo);
  for (std::string line; std::getline(lines, line) && names.size() < kMostVariables;) {
    line = trimmed(line);
    const std::size_t sign = line.find("_NAME=");
    // The name follows the file's name, which stands in quotation marks: NETCDF:"file":name.
    const std::size_t mark = line.rfind("\":");
    if (!line.starts_with("SUBDATASET_") || sign == std::string::npos ||
        mark == std::string::npos) {
      continue;
    }
    const std::string name = line.substr(mark + 2);
    if (is_plain(name)) names.push_back(name);
  }
  return names;
}

std::string last_part(const std::string& variable) {
  return variable.substr(variable.rfind('/') + 1);  // npos + 1 is 0
}

std::string variable_of_heights(const std::vector<std::string>& variables,
                                const std::string& wanted) {
  if (!wanted.empty()) {
    for (const std::string& name : variables) {
      if (name == wanted) return name;
    }
    for (const std::string& name : variables) {
      if (lower_case(last_part(name)) == lower_case(last_part(wanted))) return name;
    }
    return "";
  }
  if (variables.size() == 1) return variables.front();
  constexpr std::array kUsual{
      "elevation", "z",    "band1",      "topo", "dem", "height", "altitude",   "surface_altitude",
      "elev",      "orog", "topography", "dtm",  "dsm", "hgt",    "bathymetry", "depth"};
  for (const char* usual : kUsual) {
    for (const std::string& name : variables) {
      if (lower_case(last_part(name)) == usual) return name;
    }
  }
  return "";
}

bool counts_downwards(const std::string& gdalinfo) {
  std::istringstream lines(gdalinfo);
  for (std::string line; std::getline(lines, line);) {
    line = lower_case(trimmed(line));
    if (line == "positive=down") return true;  // of the band, not of another variable
  }
  return false;
}

}  // namespace aerostat::elevation

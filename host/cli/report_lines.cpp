#include "cli/report_lines.hpp"

#include <cmath>

#include <fmt/format.h>

namespace aerostat::cli {

namespace {

std::string degrees_text(double degrees, char positive, char negative) {
  return fmt::format("{:.5f} {}", std::abs(degrees), degrees < 0.0 ? negative : positive);
}

}  // namespace

std::string report_line(const char* name, const std::string& text) {
  return fmt::format("{:<10}{}\n", name, text);
}

std::string place_text(const geo::Place& place) {
  return degrees_text(place.latitude_deg, 'N', 'S') + ", " +
         degrees_text(place.longitude_deg, 'E', 'W');
}

}  // namespace aerostat::cli

#include "staging/climate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace aerostat::staging {
namespace {

/// A height by latitude.
struct AtLatitude {
  double latitude_deg, height_m;
};

// The line above which snow lies all year, and the line up to which trees grow, by latitude. They
// are round means of what textbooks of physical geography give for both hemispheres; dry regions
// have higher snow lines than wet ones, which is why the highest stand at 20 to 30 degrees.
constexpr std::array<AtLatitude, 11> kSnowLine{{{0, 4700},
                                                {10, 4800},
                                                {20, 5300},
                                                {30, 4900},
                                                {40, 3700},
                                                {46, 3000},
                                                {50, 2600},
                                                {60, 1500},
                                                {70, 700},
                                                {80, 250},
                                                {90, 0}}};
constexpr std::array<AtLatitude, 10> kTreeLine{{{0, 3800},
                                                {20, 3800},
                                                {30, 3400},
                                                {40, 2900},
                                                {46, 2100},
                                                {50, 1800},
                                                {60, 950},
                                                {66, 600},
                                                {71, 0},
                                                {90, -500}}};
/// By how much lower snow lies in the depth of winter.
constexpr std::array<AtLatitude, 5> kWinterDrop{
    {{0, 200}, {20, 1000}, {30, 2200}, {46, 2400}, {90, 2400}}};

double at_latitude(std::span<const AtLatitude> table, double latitude_deg) {
  const double latitude = std::abs(latitude_deg);
  for (std::size_t k = 1; k < table.size(); ++k) {
    if (latitude > table[k].latitude_deg) continue;
    const AtLatitude &a = table[k - 1], &b = table[k];
    const double t = (latitude - a.latitude_deg) / (b.latitude_deg - a.latitude_deg);
    return a.height_m + t * (b.height_m - a.height_m);
  }
  return table.back().height_m;
}

/// A rough rectangle of desert and steppe.
struct DryRegion {
  double south, north, west, east;
};
constexpr std::array<DryRegion, 13> kDryRegions{{{15, 31, -17, 36},       // Sahara
                                                 {13, 33, 36, 62},        // Arabia, Iran
                                                 {24, 30, 62, 75},        // Sind, Thar
                                                 {36, 46, 54, 66},        // Turkestan
                                                 {36, 46, 76, 112},       // Taklamakan, Gobi
                                                 {31, 38.5, -120, -108},  // Mojave to the Colorado
                                                 {24, 33, -116, -103},    // Sonora, Chihuahua
                                                 {-17, -4, -81.5, -76},   // coast of Peru
                                                 {-28, -17, -71, -66},    // Atacama
                                                 {-34, -28, -71.5, -66},  // dry Andes
                                                 {-30, -16, 11, 22},      // Namib, Kalahari
                                                 {-32, -19, 114, 143},    // Australia
                                                 {27, 30, -18.5, -13}}};  // eastern Canaries

bool is_dry(const geo::Place& place) {
  const double longitude = std::remainder(place.longitude_deg, 360.0);
  return std::any_of(kDryRegions.begin(), kDryRegions.end(), [&](const DryRegion& region) {
    return place.latitude_deg >= region.south && place.latitude_deg <= region.north &&
           longitude >= region.west && longitude <= region.east;
  });
}

scene::Season season_of(double month, bool south) {
  const double northern = std::fmod(month + (south ? 6.0 : 0.0) - 1.0, 12.0) + 1.0;
  if (northern >= 3.5 && northern < 6.0) return scene::Season::spring;
  if (northern >= 9.5 && northern < 12.0) return scene::Season::autumn;
  return scene::Season::summer;
}

}  // namespace

Climate climate_of(const geo::Place& place, double month, double lowest_m, double highest_m) {
  Climate climate;
  const bool south = place.latitude_deg < 0.0;
  climate.season = season_of(month, south);
  // The snow is least in late August, and on the southern hemisphere in late February.
  const double turn = (month - (south ? 2.8 : 8.8)) / 12.0 * 2.0 * std::numbers::pi;
  const double winter = 0.5 * (1.0 - std::cos(turn));
  climate.snow_line_m = at_latitude(kSnowLine, place.latitude_deg) -
                        winter * at_latitude(kWinterDrop, place.latitude_deg);
  climate.tree_line_m = at_latitude(kTreeLine, place.latitude_deg);
  const double middle_m = 0.5 * (lowest_m + highest_m);
  if (is_dry(place) && climate.snow_line_m > middle_m) {
    climate.biome = scene::BiomeKind::sand;
  } else if (highest_m > climate.tree_line_m - 200.0 || highest_m > climate.snow_line_m) {
    climate.biome = scene::BiomeKind::snow;
  } else if (std::abs(place.latitude_deg) < 25.0) {
    climate.biome = scene::BiomeKind::tropical;
  } else {
    climate.biome = scene::BiomeKind::meadow;
  }
  return climate;
}

}  // namespace aerostat::staging

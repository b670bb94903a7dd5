#include "staging/climate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "scene/enum_names.hpp"

namespace aerostat::staging {

using scene::detail::word_of;

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
constexpr double kHighestDesert_m = 2200.0;  // mean height above which dry regions are green
constexpr std::array<DryRegion, 13> kDryRegions{
    {{15, 31, -17, 36},         // Sahara
     {13, 33, 36, 62},          // Arabia, Iran
     {24, 30, 62, 75},          // Sind, Thar
     {36, 46, 54, 66},          // Turkestan
     {36, 46, 76, 112},         // Taklamakan, Gobi
     {31, 38.5, -117.5, -108},  // Mojave to the Colorado
     {24, 33, -116, -103},      // Sonora, Chihuahua
     {-17, -4, -81.5, -76},     // coast of Peru
     {-28, -17, -71, -66},      // Atacama
     {-34, -28, -71.5, -66},    // dry Andes
     {-30, -16, 11, 22},        // Namib, Kalahari
     {-32, -19, 114, 143},      // Australia
     {27, 30, -18.5, -13}}};    // eastern Canaries

/// Rough rectangles of land that summers turn brown.
constexpr std::array<DryRegion, 6> kDrySummers{{{32, 42, -124.5, -117},  // California
                                                {35, 43.5, -10, 36},     // Mediterranean
                                                {27, 33.5, -18.5, -5},   // Canaries, Morocco
                                                {-38, -30, -73.5, -70},  // Chile
                                                {-35, -31, 17, 26},      // Cape
                                                {-36, -30, 114, 120}}};  // south-west Australia

bool is_in(std::span<const DryRegion> regions, const geo::Place& place) {
  const double longitude = std::remainder(place.longitude_deg, 360.0);
  return std::any_of(regions.begin(), regions.end(), [&](const DryRegion& region) {
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
  climate.is_brown = is_in(kDrySummers, place) && climate.season == scene::Season::summer;
  if (is_in(kDryRegions, place) && middle_m < kHighestDesert_m) {
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

std::vector<scene::Override> biome_values(const Climate& climate, bool has_sea) {
  const auto whole = [](double metres) { return std::to_string(std::lround(metres)); };
  std::vector<scene::Override> values = {{"/biome/kind", word_of(climate.biome)},
                                         {"/biome/ground/snow_line_m", whole(climate.snow_line_m)}};
  const auto ground = [&values](const char* key, const std::string& value) {
    values.push_back({std::string("/biome/ground/") + key, value});
  };
  if (climate.biome != scene::BiomeKind::sand) ground("forest_top_m", whole(climate.tree_line_m));
  switch (climate.biome) {
    case scene::BiomeKind::snow:
      // Alpine grass, greener than what snow leaves bare in winter. The colours were chosen by eye,
      // here and below.
      ground("cover_a", "[0.055, 0.085, 0.026]");
      ground("cover_b", "[0.125, 0.13, 0.05]");
      break;
    case scene::BiomeKind::tropical:
      ground("beach_top_m", has_sea ? "3" : "-1000000");
      break;
    case scene::BiomeKind::meadow:
      values.push_back({"/biome/season", word_of(climate.season)});
      if (!climate.is_brown) break;
      ground("cover_a", "[0.19, 0.155, 0.07]");
      ground("cover_b", "[0.27, 0.215, 0.105]");
      ground("forest", "[0.06, 0.068, 0.032]");
      ground("forest_share", "0.22");
      ground("field_m", "0");
      break;
    case scene::BiomeKind::sand:
      break;
  }
  return values;
}

}  // namespace aerostat::staging

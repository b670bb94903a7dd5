#include "land/cover_codes.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::land {
namespace {

using enum CoverClass;

struct Code {
  int code;
  CoverClass is;
};

// Source: ESA WorldCover Product User Manual V2.0 (2022), the classes of the map.
constexpr std::array<Code, 11> kWorldCover{{{10, woods},
                                            {20, shrub},
                                            {30, meadow},
                                            {40, crops},
                                            {50, built_up},
                                            {60, bare},
                                            {70, snow},
                                            {80, water},
                                            {90, wetland},
                                            {95, woods},      // mangroves
                                            {100, meadow}}};  // moss and lichen

// Source: the legend of the National Land Cover Database of the USGS, with the classes that only
// Alaska has.
constexpr std::array<Code, 20> kNlcd{
    {{11, water},    {12, snow},   {21, built_up}, {22, built_up}, {23, built_up},
     {24, built_up}, {31, bare},   {41, woods},    {42, woods},    {43, woods},
     {51, shrub},    {52, shrub},  {71, meadow},   {72, meadow},   {73, meadow},
     {74, meadow},   {81, meadow}, {82, crops},    {90, wetland},  {95, wetland}}};

// Source: the nomenclature of CORINE Land Cover of the Copernicus programme. Its rasters hold
// either these codes or their numbers from 1 to 44.
constexpr std::array<Code, 44> kCorine{
    {{111, built_up}, {112, built_up}, {121, built_up}, {122, built_up}, {123, built_up},
     {124, built_up}, {131, bare},     {132, bare},     {133, bare},     {141, meadow},
     {142, meadow},   {211, crops},    {212, crops},    {213, crops},    {221, crops},
     {222, crops},    {223, crops},    {231, meadow},   {241, crops},    {242, crops},
     {243, crops},    {244, woods},    {311, woods},    {312, woods},    {313, woods},
     {321, meadow},   {322, shrub},    {323, shrub},    {324, shrub},    {331, bare},
     {332, bare},     {333, bare},     {334, bare},     {335, snow},     {411, wetland},
     {412, wetland},  {421, wetland},  {422, wetland},  {423, wetland},  {511, water},
     {512, water},    {521, water},    {522, water},    {523, water}}};

/// A scheme in one of its forms.
struct Scheme {
  CoverScheme id;
  const char* name;
  CoverCodes codes;
};

CoverCodes codes_of(std::span<const Code> table) {
  CoverCodes codes;
  for (const Code& one : table) codes[one.code] = one.is;
  return codes;
}

CoverCodes numbered(std::span<const Code> table) {
  CoverCodes codes;
  for (std::size_t i = 0; i < table.size(); ++i) codes[static_cast<int>(i) + 1] = table[i].is;
  return codes;
}

/// Returns the schemes in the order in which they are tried.
std::vector<Scheme> all_schemes() {
  return {{CoverScheme::worldcover, "ESA WorldCover", codes_of(kWorldCover)},
          {CoverScheme::nlcd, "NLCD", codes_of(kNlcd)},
          {CoverScheme::corine, "CORINE", codes_of(kCorine)},
          {CoverScheme::corine, "CORINE, numbered from 1 to 44", numbered(kCorine)}};
}

/// Returns how many of the codes that occur a scheme leaves without a class.
std::size_t unknown_in(const Scheme& scheme, const CoverCodes& own, const CoverCounts& found) {
  return static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [&](const auto& one) {
    return !own.contains(one.first) && !scheme.codes.contains(one.first);
  }));
}

/// Lists codes with their shares, the first forty of them.
std::string list_of(const CoverCounts& found) {
  constexpr std::size_t kMostListed = 40;
  double all = 0.0;
  for (const auto& [code, count] : found) all += static_cast<double>(count);
  std::string list;
  std::size_t listed = 0;
  for (const auto& [code, count] : found) {
    if (++listed > kMostListed) return list + ", ...";
    if (!list.empty()) list += ", ";
    list += fmt::format("{} ({:.2g} %)", code, 100.0 * static_cast<double>(count) / all);
  }
  return list;
}

}  // namespace

KnownCodes known_codes(CoverScheme scheme, const CoverCodes& own, const CoverCounts& found,
                       const std::filesystem::path& file) {
  const Scheme none{CoverScheme::automatic, "", {}};
  std::vector<Scheme> schemes = all_schemes();
  if (scheme != CoverScheme::automatic) {
    std::erase_if(schemes, [&](const Scheme& one) { return one.id != scheme; });
  } else {
    schemes.insert(schemes.begin(), none);  // the user's own codes may be enough
  }
  const auto best =
      std::min_element(schemes.begin(), schemes.end(), [&](const Scheme& a, const Scheme& b) {
        return unknown_in(a, own, found) < unknown_in(b, own, found);
      });
  if (const std::size_t unknown = unknown_in(*best, own, found); unknown > 0) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: {} of the codes of land cover {} unknown{}; the file has {}; "
                            "/terrain/cover/classes gives codes their classes",
                            file.string(), unknown, unknown == 1 ? "is" : "are",
                            best->id == CoverScheme::automatic ? std::string()
                                                               : fmt::format(" to {}", best->name),
                            list_of(found)));
  }
  KnownCodes known{best->codes, {}};
  for (const auto& [code, is] : own) known.classes[code] = is;
  if (best->id != CoverScheme::automatic) {
    known.note = fmt::format("Land cover is taken as that of {}.", best->name);
  }
  return known;
}

}  // namespace aerostat::land

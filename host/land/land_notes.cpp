#include "land/land_notes.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "elevation/sentinels.hpp"

namespace aerostat::land {
namespace {

constexpr float kHighestLand_m = 9000.0f, kDeepestSea_m = -12000.0f;

std::string name_of(const elevation::RasterInfo& info) {
  return info.path.filename().string();
}

/// Returns the sentences of the files. A sentence that several files have is given once.
std::vector<std::string> notes_of_files(const Land& land) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> files_of;
  for (const elevation::RasterInfo& info : land.files()) {
    for (const std::string& note : info.notes) {
      if (!files_of.contains(note)) order.push_back(note);
      files_of[note].push_back(name_of(info));
    }
  }
  std::vector<std::string> notes;
  for (const std::string& note : order) {
    const std::vector<std::string>& files = files_of[note];
    const std::size_t others = files.size() - 1;
    notes.push_back(others == 0 ? fmt::format("{}: {}", files[0], note)
                                : fmt::format("{} and {} other file{}: {}", files[0], others,
                                              others == 1 ? "" : "s", note));
  }
  return notes;
}

/// Warns of a value at an end of the range that may stand for "no height" without being declared.
/// Heights are turned back into the values that the file stores.
void add_sentinel(const Pyramid& pyramid, float end, float next, std::uint64_t count,
                  std::vector<std::string>& notes) {
  const elevation::RasterInfo& info = pyramid.raster().info();
  const std::string warning =
      elevation::sentinel_warning({end / info.metres_per_unit, next / info.metres_per_unit, count,
                                   pyramid.statistics().known() - count});
  if (!warning.empty()) notes.push_back(name_of(info) + ": " + warning);
}

void add_range(const Pyramid& pyramid, std::vector<std::string>& notes) {
  const RasterStatistics& found = pyramid.statistics();
  const std::string name = name_of(pyramid.raster().info());
  add_sentinel(pyramid, found.lowest, found.next_lowest, found.at_lowest, notes);
  add_sentinel(pyramid, found.highest, found.next_highest, found.at_highest, notes);
  if (found.highest > kHighestLand_m) {
    notes.push_back(fmt::format(
        "{}: heights reach {:.0f} m, which is higher than any land. If they are feet, say so by "
        "/terrain/unit=ft.",
        name, found.highest));
  }
  if (found.lowest < kDeepestSea_m) {
    notes.push_back(fmt::format("{}: heights go down to {:.0f} m, which is deeper than any sea.",
                                name, found.lowest));
  }
}

void add_voids(const Pyramid& pyramid, std::vector<std::string>& notes) {
  const RasterStatistics& found = pyramid.statistics();
  if (found.voids == 0) return;
  const double share =
      100.0 * static_cast<double>(found.voids) / static_cast<double>(found.samples);
  const double largest =
      100.0 * static_cast<double>(found.largest_void) / static_cast<double>(found.samples);
  notes.push_back(fmt::format(
      "{}: {} of {} samples ({:.3g} %) have no height, the largest gap being {:.3g} % of the "
      "file{}. Gaps are filled smoothly from the land around them; /terrain/voids=sea makes large "
      "ones a sea.",
      name_of(pyramid.raster().info()), found.voids, found.samples, share, largest,
      found.void_at_rim ? " and reaching its rim" : ""));
}

void add_below_zero(const Land& land, std::vector<std::string>& notes) {
  if (land.has_sea()) {
    notes.emplace_back(
        "Land at or below 0 m is taken as sea; /biome/water/enabled=false makes it dry.");
  } else if (land.lowest_m() < -5.0f) {
    notes.push_back(
        fmt::format("Heights go down to {:.0f} m, and that is taken as dry land. If it is the "
                    "floor of a sea, say "
                    "so by /biome/water/enabled=true.",
                    land.lowest_m()));
  }
}

/// Says how much water was found, and where it is switched off.
void add_waters(const Land& land, std::vector<std::string>& notes) {
  if (land.waters().empty()) return;
  double area_m2 = 0.0;
  const InlandWater* largest = &land.waters()[0];
  for (const InlandWater& water : land.waters()) {
    area_m2 += water.area_m2;
    if (water.area_m2 > largest->area_m2) largest = &water;
  }
  const std::size_t count = land.waters().size();
  notes.push_back(fmt::format(
      "{} level area{} of {:.3g} km2 in all {} taken as lakes and rivers, the largest one with "
      "{:.3g} km2 at {:.0f} m; /terrain/inland_water=none makes them dry.",
      count, count == 1 ? "" : "s", 1e-6 * area_m2, count == 1 ? "is" : "are",
      1e-6 * largest->area_m2, largest->level_m));
}

}  // namespace

std::string datum_note(std::span<const elevation::RasterInfo> files) {
  const elevation::RasterInfo* first = nullptr;
  for (const elevation::RasterInfo& file : files) {
    if (file.vertical_datum.empty()) continue;
    if (first == nullptr) first = &file;
    if (file.vertical_datum == first->vertical_datum) continue;
    return fmt::format(
        "The heights of {} count from the level \"{}\" and those of {} from \"{}\". They are used "
        "as "
        "they are, so that the land can have a step between them.",
        name_of(*first), first->vertical_datum, name_of(file), file.vertical_datum);
  }
  return {};
}

std::vector<std::string> notes_about(const Land& land) {
  std::vector<std::string> notes = notes_of_files(land);
  if (std::string note = datum_note(land.files()); !note.empty()) notes.push_back(std::move(note));
  for (const auto& pyramid : land.pyramids()) {
    add_range(*pyramid, notes);
    add_voids(*pyramid, notes);
  }
  add_below_zero(land, notes);
  add_waters(land, notes);
  if (!land.has_place()) {
    notes.push_back(
        fmt::format("{}: no coordinate reference system is named, so that its numbers are taken as "
                    "metres and its "
                    "place on the Earth is unknown; name one by /terrain/crs.",
                    name_of(land.files()[0])));
  }
  return notes;
}

}  // namespace aerostat::land

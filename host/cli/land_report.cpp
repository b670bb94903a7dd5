#include "cli/land_report.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report_lines.hpp"
#include "core/grouped.hpp"
#include "elevation/raster.hpp"
#include "geo/transform.hpp"
#include "land/pyramid.hpp"

namespace aerostat::cli {

namespace {

using Json = nlohmann::ordered_json;
using elevation::RasterInfo;

constexpr std::size_t kFilesInText = 8;

/// What is missing in all files.
struct Gaps {
  std::uint64_t samples = 0, voids = 0;
  double largest_share = 0.0;  // of a file, for the largest gap of all
};

Gaps gaps_of(const land::Land& land) {
  Gaps gaps;
  for (const auto& pyramid : land.pyramids()) {
    const land::RasterStatistics& found = pyramid->statistics();
    gaps.samples += found.samples;
    gaps.voids += found.voids;
    gaps.largest_share = std::max(gaps.largest_share, static_cast<double>(found.largest_void) /
                                                          static_cast<double>(found.samples));
  }
  return gaps;
}

std::string crs_name(const RasterInfo& file) {
  const std::string& crs = file.georeference->crs;
  return crs.empty() ? "unknown" : geo::crs_info(crs).name;
}

std::string file_text(const RasterInfo& file) {
  std::string text =
      fmt::format("{}: {}, {}, {} x {} samples", file.path.filename().string(), file.format,
                  file.sample_type, grouped(file.width), grouped(file.height));
  if (file.metres_per_unit != 1.0) text += ", heights in units of " + file.unit;
  if (!file.vertical_datum.empty()) text += ", over \"" + file.vertical_datum + "\"";
  return text;
}

/// Returns a line for each file, and one for each coordinate reference system.
std::string files_text(const land::Land& land) {
  const std::vector<RasterInfo>& files = land.files();
  std::string text;
  for (std::size_t i = 0; i < std::min(files.size(), kFilesInText); ++i) {
    text += report_line(i == 0 ? "files" : "", file_text(files[i]));
  }
  if (files.size() > kFilesInText) {
    text += report_line("", fmt::format("and {} more", files.size() - kFilesInText));
  }
  std::vector<std::string> systems;
  for (const RasterInfo& file : files) {
    std::string name = crs_name(file);
    if (std::find(systems.begin(), systems.end(), name) == systems.end()) {
      systems.push_back(std::move(name));
    }
  }
  return text + report_line("system", fmt::format("{}", fmt::join(systems, "; ")));
}

std::string extent_text(const land::Land& land) {
  const dvec2 size_km = land.size_m() * 1e-3;
  std::string text = fmt::format("{:.2f} x {:.2f} km", size_km.x, size_km.y);
  if (land.middle().place) text += " around " + place_text(*land.middle().place);
  return report_line("extent", text + fmt::format(", a sample every {:.3g} m", land.cell_m()));
}

std::string voids_text(const land::Land& land) {
  const Gaps gaps = gaps_of(land);
  if (gaps.voids == 0) return report_line("gaps", "none");
  return report_line(
      "gaps",
      fmt::format(
          "{} of {} samples have no height ({:.3g} %), the largest gap {:.3g} % of its file",
          grouped(gaps.voids), grouped(gaps.samples),
          100.0 * static_cast<double>(gaps.voids) / static_cast<double>(gaps.samples),
          100.0 * gaps.largest_share));
}

Json file_json(const RasterInfo& file) {
  Json json = {{"file", file.path.string()},
               {"format", file.format},
               {"sample_type", file.sample_type},
               {"width", file.width},
               {"height", file.height},
               {"unit", file.unit},
               {"metres_per_unit", file.metres_per_unit}};
  const std::string& crs = file.georeference->crs;
  json["crs"] = crs.empty() ? Json(nullptr) : Json(geo::crs_info(crs).name);
  json["vertical_datum"] = file.vertical_datum.empty() ? Json(nullptr) : Json(file.vertical_datum);
  return json;
}

Json chosen_json(const staging::Staged& staged) {
  Json json = Json::object();
  for (const scene::Override& change : staged.chosen) {
    // A value is JSON, or a word that stands for itself as with --set.
    Json value = Json::parse(change.value, nullptr, false);
    json[change.pointer] = value.is_discarded() ? Json(change.value) : std::move(value);
  }
  return json;
}

}  // namespace

std::string land_text(const std::string& name, const staging::Staged& staged) {
  const land::Land& land = *staged.land;
  std::string text = fmt::format(
      "{}: land from {}\n", name,
      land.files().size() == 1 ? "a file" : fmt::format("{} files", grouped(land.files().size())));
  text += files_text(land) + extent_text(land);
  text +=
      report_line("heights", fmt::format("{:.4g} to {:.4g} m", land.lowest_m(), land.highest_m()));
  text += voids_text(land);
  text += report_line("sea", land.has_sea() ? "at 0 m" : "none");
  for (const std::string& note : staged.notes) text += report_line("note", note);
  return text;
}

std::string land_json(const std::string& name, const staging::Staged& staged) {
  const land::Land& land = *staged.land;
  const Gaps gaps = gaps_of(land);
  Json files = Json::array();
  for (const RasterInfo& file : land.files()) files.push_back(file_json(file));
  Json json = {{"file", name}, {"files", std::move(files)}};
  if (land.middle().place) {
    json["middle"] = {{"latitude_deg", land.middle().place->latitude_deg},
                      {"longitude_deg", land.middle().place->longitude_deg}};
  }
  json["width_m"] = land.size_m().x;
  json["height_m"] = land.size_m().y;
  json["cell_m"] = land.cell_m();
  json["lowest_m"] = land.lowest_m();
  json["highest_m"] = land.highest_m();
  json["samples"] = gaps.samples;
  json["voids"] = gaps.voids;
  json["largest_void_share"] = gaps.largest_share;
  json["has_sea"] = land.has_sea();
  json["chosen"] = chosen_json(staged);
  json["notes"] = staged.notes;
  // Names of files may contain bytes that are not UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aerostat::cli

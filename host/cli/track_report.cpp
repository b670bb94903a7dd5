#include "cli/track_report.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report_lines.hpp"
#include "core/grouped.hpp"
#include "track/read.hpp"
#include "track/summary.hpp"
#include "track/text.hpp"

namespace aerostat::cli {

namespace {

using Json = nlohmann::ordered_json;
using track::Flight;
using track::HeightSource;

constexpr std::size_t kGapsInText = 5;

/// Returns a time of the flight, which is one of day if the file names no date.
std::string time_text(const Flight& flight, double time) {
  return flight.clock() == track::Clock::utc ? track::utc_text(time)
                                             : track::clock_text(time) + " UTC";
}

const char* name_of(HeightSource source) {
  switch (source) {
    case HeightSource::gnss:
      return "GNSS heights";
    case HeightSource::gnss_shifted:
      return "GNSS heights over the ellipsoid, shifted to the sea";
    case HeightSource::gnss_fitted:
      return "GNSS heights, shifted to the ground";
    case HeightSource::pressure:
      return "pressure heights";
    case HeightSource::pressure_fitted:
      return "pressure heights, shifted to the ground";
    case HeightSource::over_ground:
      return "heights over the ground, from the file";
    case HeightSource::assumed:
      return "heights over the ground, assumed";
    case HeightSource::none:
      break;
  }
  return "unknown";
}

const char* key_of(HeightSource source) {
  switch (source) {
    case HeightSource::gnss:
      return "gnss";
    case HeightSource::gnss_shifted:
      return "gnss_shifted";
    case HeightSource::gnss_fitted:
      return "gnss_fitted";
    case HeightSource::pressure:
      return "pressure";
    case HeightSource::pressure_fitted:
      return "pressure_fitted";
    case HeightSource::over_ground:
      return "over_ground";
    case HeightSource::assumed:
      return "assumed";
    case HeightSource::none:
      break;
  }
  return "none";
}

std::string point_text(const Flight& flight, std::size_t point) {
  const track::Position position = flight.position_of(point);
  std::string text;
  if (flight.clock() != track::Clock::none) {
    text = time_text(flight, flight.course().times[point]) + ", ";
  }
  text += place_text(position.place);
  if (!flight.course().heights_m.empty()) text += fmt::format(", {:.0f} m", position.height_m);
  return text;
}

std::string gaps_text(const Flight& flight) {
  const auto& gaps = flight.gaps();
  if (gaps.empty()) return report_line("gaps", "none");
  std::string text = report_line("gaps", track::counted(gaps.size(), "gap", "gaps"));
  for (std::size_t i = 0; i < std::min(gaps.size(), kGapsInText); ++i) {
    text += report_line(
        "", fmt::format("{}, {}, {:.2f} km", time_text(flight, gaps[i].from_s),
                        track::duration_text(gaps[i].to_s - gaps[i].from_s), gaps[i].way_m * 1e-3));
  }
  if (gaps.size() > kGapsInText) {
    text += report_line("", fmt::format("and {} more", gaps.size() - kGapsInText));
  }
  return text;
}

std::string heights_text(const Flight& flight, track::Format format) {
  const track::FitReport& fit = flight.fit();
  std::string text = name_of(fit.source);
  const std::string_view own = "GNSS heights";
  if (format != track::Format::igc && text.substr(0, own.size()) == own) {
    text.replace(0, own.size(), "heights of the file");
  }
  if (fit.smoothing_s > 0.0) text += fmt::format(", smoothed over {:.0f} s", fit.smoothing_s);
  if (fit.filled > 0) text += fmt::format(", {} filled in", grouped(fit.filled));
  if (!fit.has_ground)
    return report_line("heights", text + "; not tested, because no ground is known");
  if (fit.shift_start_m != 0.0 || fit.shift_end_m != 0.0) {
    text += fmt::format("; shifted by {:+.0f} m at the start and {:+.0f} m at the end",
                        fit.shift_start_m, fit.shift_end_m);
  }
  std::string all = report_line("heights", text);
  const auto add = [&](const char* name, const track::EndOffsets& offsets) {
    if (!offsets.start_m || !offsets.end_m) return;
    all += report_line(
        "", fmt::format("{} {:+.0f} m over the ground at the start, {:+.0f} m at the end", name,
                        *offsets.start_m, *offsets.end_m));
  };
  add(format == track::Format::igc ? "GNSS" : "they lie", fit.gnss);
  add("pressure", fit.pressure);
  if (fit.clamped > 0) {
    all += report_line(
        "", fmt::format("{} lifted above the ground, by {:.0f} m at most",
                        track::counted(fit.clamped, "fix", "fixes"), fit.clamped_most_m));
  }
  return all;
}

std::string figures_text(const Flight& flight, const track::Summary& summary) {
  std::string text = report_line("take-off", point_text(flight, flight.takeoff()));
  text += report_line("landing", point_text(flight, flight.landing()));
  if (flight.clock() != track::Clock::none) {
    text += report_line("duration", track::duration_text(summary.duration_s));
  }
  text += report_line("way",
                      fmt::format("{:.1f} km over the ground, {:.1f} km from take-off to landing",
                                  summary.way_m * 1e-3, summary.straight_m * 1e-3));
  if (summary.highest_m) {
    text += report_line("height", fmt::format("{:.0f} to {:.0f} m over the sea", *summary.lowest_m,
                                              *summary.highest_m));
  }
  if (summary.highest_over_ground_m) {
    text += report_line(
        "", fmt::format("at most {:.0f} m over the ground", *summary.highest_over_ground_m));
  }
  if (summary.fastest_climb_mps) {
    text +=
        report_line("climb", fmt::format("at most {:.1f} m/s up and {:.1f} m/s down, over 10 s",
                                         *summary.fastest_climb_mps, *summary.fastest_sink_mps));
  }
  if (summary.fastest_mps) {
    text += report_line("speed", fmt::format("at most {:.1f} m/s over the ground, over 10 s",
                                             *summary.fastest_mps));
  }
  const track::Extent& extent = summary.extent;
  text += report_line(
      "extent", fmt::format("{:.1f} x {:.1f} km, from {} to {}", extent.width_m * 1e-3,
                            extent.height_m * 1e-3, place_text({extent.south_deg, extent.west_deg}),
                            place_text({extent.north_deg, extent.east_deg})));
  return text;
}

Json point_json(const Flight& flight, std::size_t point) {
  const track::Position position = flight.position_of(point);
  Json json = {{"latitude_deg", position.place.latitude_deg},
               {"longitude_deg", position.place.longitude_deg}};
  if (!flight.course().heights_m.empty()) json["height_m"] = position.height_m;
  if (flight.clock() != track::Clock::none) {
    json["time"] = time_text(flight, flight.course().times[point]);
  }
  if (position.time_s) json["time_s"] = *position.time_s;
  if (position.ground_m) json["ground_m"] = *position.ground_m;
  return json;
}

void add(Json& json, const char* key, const std::optional<double>& value) {
  if (value) json[key] = *value;
}

Json fit_json(const track::FitReport& fit) {
  Json json = {{"source", key_of(fit.source)}, {"has_ground", fit.has_ground}};
  add(json, "gnss_over_ground_start_m", fit.gnss.start_m);
  add(json, "gnss_over_ground_end_m", fit.gnss.end_m);
  add(json, "pressure_over_ground_start_m", fit.pressure.start_m);
  add(json, "pressure_over_ground_end_m", fit.pressure.end_m);
  json["shift_start_m"] = fit.shift_start_m;
  json["shift_end_m"] = fit.shift_end_m;
  json["smoothing_s"] = fit.smoothing_s;
  json["filled"] = fit.filled;
  json["clamped"] = fit.clamped;
  return json;
}

Json figures_json(const Flight& flight, const track::Summary& summary) {
  Json json = {{"takeoff", point_json(flight, flight.takeoff())},
               {"landing", point_json(flight, flight.landing())}};
  if (flight.clock() != track::Clock::none) json["duration_s"] = summary.duration_s;
  json["way_m"] = summary.way_m;
  json["straight_m"] = summary.straight_m;
  add(json, "lowest_m", summary.lowest_m);
  add(json, "highest_m", summary.highest_m);
  add(json, "highest_over_ground_m", summary.highest_over_ground_m);
  add(json, "fastest_climb_mps", summary.fastest_climb_mps);
  add(json, "fastest_sink_mps", summary.fastest_sink_mps);
  add(json, "fastest_mps", summary.fastest_mps);
  const track::Extent& extent = summary.extent;
  json["extent"] = {{"south_deg", extent.south_deg}, {"north_deg", extent.north_deg},
                    {"west_deg", extent.west_deg},   {"east_deg", extent.east_deg},
                    {"width_m", extent.width_m},     {"height_m", extent.height_m}};
  Json gaps = Json::array();
  for (const track::Gap& gap : flight.gaps()) {
    gaps.push_back({{"from", time_text(flight, gap.from_s)},
                    {"seconds", gap.to_s - gap.from_s},
                    {"way_m", gap.way_m}});
  }
  json["gaps"] = gaps;
  return json;
}

std::vector<std::string> all_notes(const track::Cleaned& cleaned, const Flight& flight) {
  std::vector<std::string> notes = cleaned.track.notes;
  notes.insert(notes.end(), flight.fit().notes.begin(), flight.fit().notes.end());
  return notes;
}

}  // namespace

std::string track_text(const std::string& name, const track::Cleaned& cleaned,
                       const Flight& flight) {
  const track::Summary summary = track::summary_of(flight);
  const track::Track& track = cleaned.track;
  std::string text = fmt::format("{}: {} track{}\n", name, track::name_of(track.format),
                                 track.name.empty() ? "" : " '" + track.name + "'");
  std::string fixes = grouped(summary.fixes);
  if (track.segments.size() > 1) fixes += fmt::format(" in {} segments", track.segments.size());
  if (summary.interval_s > 0.0) fixes += fmt::format(", one every {:.3g} s", summary.interval_s);
  text += report_line("fixes", fixes);
  text += figures_text(flight, summary);
  if (flight.clock() != track::Clock::none) text += gaps_text(flight);
  text += heights_text(flight, track.format);
  for (const std::string& note : all_notes(cleaned, flight)) text += report_line("note", note);
  return text;
}

std::string track_json(const std::string& name, const track::Cleaned& cleaned,
                       const Flight& flight) {
  const track::Summary summary = track::summary_of(flight);
  const track::CleanReport& report = cleaned.report;
  Json json = {{"file", name},
               {"format", track::name_of(cleaned.track.format)},
               {"name", cleaned.track.name},
               {"fixes", summary.fixes},
               {"segments", cleaned.track.segments.size()},
               {"interval_s", summary.interval_s}};
  json["left_out"] = {{"invalid", report.invalid},
                      {"nowhere", report.nowhere},
                      {"duplicates", report.duplicates},
                      {"outliers", report.outliers},
                      {"wrong_heights", report.wrong_heights},
                      {"standing_start_s", report.cut_start_s},
                      {"standing_end_s", report.cut_end_s}};
  json.update(figures_json(flight, summary));
  json["heights"] = fit_json(flight.fit());
  json["notes"] = all_notes(cleaned, flight);
  // Names of files may contain bytes that are not UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aerostat::cli

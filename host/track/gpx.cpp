#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/raw.hpp"
#include "track/text.hpp"
#include "track/xml.hpp"

/// GPX 1.0 and 1.1: tracks (trk, trkseg, trkpt), and routes (rte, rtept) if there are no tracks.
namespace aerostat::track {

namespace {

class GpxHandler : public XmlHandler {
 public:
  void begin(std::string_view name, const XmlAttributes& attributes) override {
    ++depth_;
    if (track_ == nullptr && (name == "trk" || name == "rte")) {
      list(name).emplace_back();
      track_ = &list(name).back();
      track_depth_ = depth_;
      if (name == "rte") track_->segments.emplace_back();
    } else if (name == "trkseg" && track_ != nullptr) {
      track_->segments.emplace_back();
    } else if (name == "trkpt" || name == "rtept" || name == "wpt") {
      begin_point(name, attributes);
    }
  }

  void end(std::string_view name, std::string_view text) override {
    // Names, heights and times count only directly within a track or a point. Extensions have
    // elements of the same names.
    if (in_point_ && depth_ == point_depth_ + 1) {
      if (name == "ele") fix_.gnss_m = number_of(text);
      if (name == "time") read_time(text);
    } else if (track_ != nullptr && depth_ == track_depth_ + 1 && name == "name") {
      track_->name = clean_text(text);
    }
    if (in_point_ && depth_ == point_depth_) end_point(name);
    if (name == "trkseg" && track_ != nullptr) drop_empty_segment();
    if (depth_ == track_depth_ && (name == "trk" || name == "rte")) end_track(name);
    --depth_;
  }

  bool has_content() const override { return count_ > 1; }

  RawFile result(std::vector<std::string> notes);

 private:
  std::vector<RawTrack>& list(std::string_view name) { return name == "trk" ? tracks_ : routes_; }

  void drop_empty_segment() {
    if (!track_->segments.empty() && track_->segments.back().empty()) track_->segments.pop_back();
  }

  void end_track(std::string_view name) {
    if (track_ == nullptr) return;
    drop_empty_segment();
    if (track_->segments.empty()) list(name).pop_back();
    require_few(list(name).size());
    track_ = nullptr;
  }

  void begin_point(std::string_view name, const XmlAttributes& attributes) {
    in_point_ = true;
    point_depth_ = depth_;
    fix_ = Fix();
    const auto latitude = number_of(attributes.value("lat").value_or(""));
    const auto longitude = number_of(attributes.value("lon").value_or(""));
    has_place_ = latitude && longitude;
    if (has_place_) fix_.place = {*latitude, *longitude};
    waypoints_ += name == "wpt" ? 1 : 0;
  }

  void end_point(std::string_view name) {
    in_point_ = false;
    if (name == "wpt" || track_ == nullptr) return;
    if (!has_place_) {
      ++without_place_;
      return;
    }
    if (track_->segments.empty()) track_->segments.emplace_back();
    add_fix(*track_, fix_, count_);
  }

  void read_time(std::string_view text) {
    const auto time = time_of(text);
    if (!time) {
      unread_times_ += trimmed(text).empty() ? 0 : 1;
      return;
    }
    fix_.time_s = time->time_s;
    without_zone_ += time->has_zone ? 0 : 1;
  }

  std::vector<RawTrack> tracks_, routes_;
  RawTrack* track_ = nullptr;
  Fix fix_;
  bool in_point_ = false, has_place_ = false;
  int depth_ = 0, track_depth_ = 0, point_depth_ = 0;
  std::size_t count_ = 0, waypoints_ = 0, without_place_ = 0, unread_times_ = 0, without_zone_ = 0;
};

RawFile GpxHandler::result(std::vector<std::string> notes) {
  const auto has_fixes = [](const std::vector<RawTrack>& tracks) {
    for (const RawTrack& track : tracks) {
      for (const Segment& segment : track.segments) {
        if (!segment.empty()) return true;
      }
    }
    return false;
  };
  RawFile file{{}, std::move(notes)};
  const bool is_route = !has_fixes(tracks_) && has_fixes(routes_);
  file.tracks = std::move(is_route ? routes_ : tracks_);
  if (is_route) file.notes.emplace_back("The file has no track, so its route was taken.");
  if (!has_fixes(file.tracks) && waypoints_ > 0) {
    throw Error(ErrorKind::bad_data, "the GPX file has only waypoints; expected a track (trk)");
  }
  const auto note = [&](std::size_t count, const char* one, const char* many, const char* format) {
    if (count > 0)
      file.notes.push_back(fmt::format(fmt::runtime(format), counted(count, one, many)));
  };
  note(without_place_, "point", "points",
       "{} without a readable latitude and longitude cannot be used.");
  note(unread_times_, "time", "times",
       "{} not understood; expected a form like 2023-10-02T07:45:10Z.");
  note(without_zone_, "time", "times", "{} without a zone taken for UTC.");
  return file;
}

}  // namespace

RawFile read_gpx(std::string_view bytes) {
  GpxHandler handler;
  std::vector<std::string> notes = read_xml(bytes, handler);
  return handler.result(std::move(notes));
}

}  // namespace aerostat::track

#include <algorithm>
#include <charconv>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/distance.hpp"
#include "track/raw.hpp"
#include "track/text.hpp"
#include "track/xml.hpp"

/// KML: gx:Track and gx:MultiTrack, and LineString if there are none of these. The order of
/// coordinates is longitude, latitude, altitude.
namespace aerostat::track {

namespace {

/// Takes numbers off the front of a text.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : rest_(trimmed(text)) {}

  bool is_done() const { return rest_.empty(); }

  std::optional<double> next() {
    const std::size_t end = std::min(rest_.find_first_of(" \t\r\n,"), rest_.size());
    const auto number = number_of(rest_.substr(0, end));
    rest_ = trimmed(rest_.substr(end));
    return number;
  }

  bool take_comma() {
    if (rest_.empty() || rest_[0] != ',') return false;
    rest_ = trimmed(rest_.substr(1));
    return true;
  }

 private:
  std::string_view rest_;
};

/// Returns a fix from up to three numbers, if there are at least a longitude and a latitude.
std::optional<Fix> fix_of(const std::vector<std::optional<double>>& numbers) {
  if (numbers.size() < 2 || !numbers[0] || !numbers[1]) return std::nullopt;
  Fix fix;
  fix.place = {*numbers[1], *numbers[0]};
  if (numbers.size() > 2) fix.gnss_m = numbers[2];
  return fix;
}

class KmlHandler : public XmlHandler {
 public:
  void begin(std::string_view name, const XmlAttributes&) override {
    ++depth_;
    if (name == "Placemark") {
      placemark_depth_ = depth_;
      placemark_name_.clear();
    } else if (name == "MultiTrack" || name == "MultiGeometry") {
      in_multiple_ = true;
      continued_ = nullptr;
    } else if (name == "Track" || name == "LineString") {
      mode_.clear();
      whens_.clear();
      fixes_.clear();
    }
  }

  void end(std::string_view name, std::string_view text) override {
    if (name == "name" && depth_ == placemark_depth_ + 1) placemark_name_ = clean_text(text);
    if (name == "altitudeMode") mode_ = clean_text(text);
    if (name == "when") read_when(text);
    if (name == "coord") read_coord(text);
    if (name == "coordinates") read_coordinates(text);
    if (name == "Track") end_track();
    if (name == "LineString") end_geometry(lines_);
    if (name == "MultiTrack" || name == "MultiGeometry") {
      in_multiple_ = false;
      continued_ = nullptr;
    }
    if (name == "Placemark") placemark_depth_ = -1;
    --depth_;
  }

  bool has_content() const override { return count_ > 1; }

  RawFile result(std::vector<std::string> notes);

 private:
  void require_limit(std::size_t count) const {
    if (count <= kMostFixes) return;
    throw Error(ErrorKind::bad_data, fmt::format("the file has more than {} places", kMostFixes));
  }

  void read_when(std::string_view text) {
    const auto time = time_of(text);
    whens_.push_back(time ? std::optional(time->time_s) : std::nullopt);
    without_zone_ += time && !time->has_zone ? 1 : 0;
    require_limit(whens_.size());
  }

  void read_coord(std::string_view text) {
    std::vector<std::optional<double>> numbers;
    for (Numbers rest(text); !rest.is_done() && numbers.size() < 4;) {
      numbers.push_back(rest.next());
      rest.take_comma();
    }
    fixes_.push_back(fix_of(numbers));
    require_limit(fixes_.size());
  }

  void read_coordinates(std::string_view text) {
    fixes_.clear();
    std::vector<std::optional<double>> numbers;
    for (Numbers rest(text); !rest.is_done();) {
      numbers.push_back(rest.next());
      if (rest.take_comma() && numbers.size() < 4) continue;
      fixes_.push_back(fix_of(numbers));
      numbers.clear();
      require_limit(fixes_.size());
    }
  }

  void end_track() {
    if (whens_.size() != fixes_.size() && !whens_.empty()) ++unpaired_;
    for (std::size_t i = 0; i < std::min(fixes_.size(), whens_.size()); ++i) {
      if (fixes_[i]) fixes_[i]->time_s = whens_[i];
    }
    end_geometry(tracks_);
  }

  void end_geometry(std::vector<RawTrack>& tracks) {
    if (continued_ != &tracks) {
      tracks.push_back({placemark_name_, {}, HeightReference::unknown, Clock::utc, {}});
    }
    RawTrack& track = tracks.back();
    track.segments.emplace_back();
    for (const auto& fix : fixes_) {
      if (fix) add_fix(track, *fix, count_);
      unread_ += fix ? 0 : 1;
    }
    settle_heights(track);
    if (track.segments.back().empty()) track.segments.pop_back();
    const bool has_fixes = !track.segments.empty();
    if (!has_fixes) tracks.pop_back();
    continued_ = in_multiple_ && has_fixes ? &tracks : nullptr;
    require_few(tracks.size());
    fixes_.clear();
  }

  void settle_heights(RawTrack& track);
  void join_lines(std::vector<std::string>& notes);

  std::vector<RawTrack> tracks_, lines_;
  std::string placemark_name_, mode_;
  std::vector<std::optional<double>> whens_;
  std::vector<std::optional<Fix>> fixes_;
  int depth_ = 0, placemark_depth_ = -1;
  bool in_multiple_ = false;
  std::vector<RawTrack>* continued_ = nullptr;  // the list whose last track goes on
  std::size_t count_ = 0, unread_ = 0, unpaired_ = 0, without_zone_ = 0;
};

/// Decides by the altitude mode what the altitudes of the last segment mean. Many programs leave
/// the mode out although their altitudes are heights over the sea.
void KmlHandler::settle_heights(RawTrack& track) {
  Segment& fixes = track.segments.back();
  if (mode_ == "absolute") track.reference = HeightReference::sea;
  if (mode_ == "relativeToGround") track.reference = HeightReference::ground;
  if (mode_ == "absolute" || mode_ == "relativeToGround") return;
  const bool is_zero = std::all_of(fixes.begin(), fixes.end(),
                                   [](const Fix& fix) { return fix.gnss_m.value_or(0.0) == 0.0; });
  if (is_zero) {
    for (Fix& fix : fixes) fix.gnss_m.reset();
  } else if (track.notes.empty()) {
    track.notes.push_back(fmt::format(
        "The altitude mode is {}, but the altitudes were taken as heights over the sea.",
        mode_.empty() ? "not given" : "'" + mode_ + "'"));
  }
}

/// Joins lines that begin where the one before ends. Programs cut a way into pieces to colour them.
void KmlHandler::join_lines(std::vector<std::string>& notes) {
  constexpr double kTouching_m = 2.0;
  std::vector<RawTrack> joined;
  for (RawTrack& line : lines_) {
    const bool touches = !joined.empty() && joined.back().reference == line.reference &&
                         distance_m(joined.back().segments.back().back().place,
                                    line.segments.front().front().place) < kTouching_m;
    if (!touches) {
      joined.push_back(std::move(line));
      continue;
    }
    std::move(line.segments.begin(), line.segments.end(),
              std::back_inserter(joined.back().segments));
  }
  if (joined.size() < lines_.size()) {
    notes.push_back(fmt::format("{} that touch each other were joined into {}.",
                                counted(lines_.size(), "line", "lines"), joined.size()));
  }
  lines_ = std::move(joined);
}

RawFile KmlHandler::result(std::vector<std::string> notes) {
  RawFile file{{}, std::move(notes)};
  if (!tracks_.empty() && !lines_.empty()) {
    file.notes.emplace_back("The file has lines as well, which were passed over for its tracks.");
  }
  if (tracks_.empty()) join_lines(file.notes);
  file.tracks = std::move(tracks_.empty() ? lines_ : tracks_);
  if (unread_ > 0) {
    file.notes.push_back(fmt::format("{} could not be read and cannot be used.",
                                     counted(unread_, "coordinate", "coordinates")));
  }
  if (unpaired_ > 0) {
    file.notes.emplace_back("A track has another number of times than of coordinates.");
  }
  if (without_zone_ > 0) {
    file.notes.push_back(
        fmt::format("{} without a zone taken for UTC.", counted(without_zone_, "time", "times")));
  }
  return file;
}

}  // namespace

RawFile read_kml(std::string_view bytes) {
  KmlHandler handler;
  std::vector<std::string> notes = read_xml(bytes, handler);
  return handler.result(std::move(notes));
}

}  // namespace aerostat::track

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/raw.hpp"
#include "track/text.hpp"

/// IGC files of flight recorders. The records B (fixes), H (header) and I (extensions of fixes) are
/// read, and all others are skipped.
namespace aerostat::track {

namespace {

constexpr double kDay_s = 86400.0;
constexpr double kHalfDay_s = 0.5 * kDay_s;

/// Where an extension stands in a fix, as offset and length.
struct Column {
  std::size_t first = 0, length = 0;
};

/// Returns a number of a fixed column, which may begin with a minus sign or spaces.
std::optional<int> height_of(std::string_view text) {
  text = trimmed(text);
  const bool is_negative = !text.empty() && text[0] == '-';
  const auto digits = digits_of(is_negative ? text.substr(1) : text);
  if (!digits) return std::nullopt;
  return is_negative ? -*digits : *digits;
}

/// Returns an angle in degrees from a column such as 4647347N and the digits that may follow its
/// decimals elsewhere.
std::optional<double> angle_of(std::string_view text, std::string_view more, char negative) {
  const std::size_t degree_digits = text.size() - 6;
  const auto degrees = digits_of(text.substr(0, degree_digits));
  const auto minutes = digits_of(text.substr(degree_digits, 5));
  if (!degrees || !minutes || *minutes >= 60000) return std::nullopt;
  double in_minutes = *minutes / 1000.0;
  if (const auto extra = digits_of(more)) {
    in_minutes += *extra / (1000.0 * std::pow(10.0, static_cast<double>(more.size())));
  }
  const double angle = *degrees + in_minutes / 60.0;
  return text.back() == negative ? -angle : angle;
}

/// Returns the date of a header such as HFDTE111023 or HFDTEDATE:111023,01 in days.
std::optional<int> date_of(std::string_view line) {
  const std::size_t first = line.find_first_of("0123456789", 5);
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t end = line.find_first_not_of("0123456789", first);
  const std::string_view digits =
      line.substr(first, end == std::string_view::npos ? end : end - first);
  if (digits.size() != 6 && digits.size() != 8) return std::nullopt;
  int year = *digits_of(digits.substr(4));
  if (digits.size() == 6) year += year < 70 ? 2000 : 1900;
  const auto days = days_of(year, *digits_of(digits.substr(2, 2)), *digits_of(digits.substr(0, 2)));
  // Loggers that do not know the date write 1 January 1970 or 1980.
  const bool is_unset = year < 1980 || (year == 1980 && days == days_of(1980, 1, 1));
  return is_unset ? std::nullopt : days;
}

class IgcReader {
 public:
  void read(std::string_view line) {
    if (line[0] == 'B') {
      read_fix(line);
    } else if (line[0] == 'I') {
      read_extensions(line);
    } else if (line[0] == 'H' && line.size() > 5) {
      read_header(line);
    }
  }

  RawFile result();

 private:
  void read_extensions(std::string_view line);
  void read_header(std::string_view line);
  void read_date(std::string_view line);
  void read_fix(std::string_view line);
  double time_of_fix(int hhmmss, std::string_view fraction);
  void settle_doubtful_fixes();
  void settle_zero_heights();

  std::string_view extension(std::string_view line, const char* code) const {
    const auto found = columns_.find(code);
    if (found == columns_.end() || found->second.first >= line.size()) return {};
    return line.substr(found->second.first, found->second.length);
  }

  std::map<std::string, Column, std::less<>> columns_;
  RawTrack track_{"", {Segment()}, HeightReference::unknown, Clock::utc, {}};
  std::vector<std::string> notes_;
  std::optional<int> date_;
  int day_ = 0;        // the days since 1970, or since the first day if no date is known
  int midnights_ = 0;  // that passed since the last date
  double last_s_ = -1.0, before_jump_s_ = -1.0;
  std::size_t since_jump_ = 0;
  std::size_t count_ = 0, unread_ = 0, passed_midnights_ = 0, dates_ = 0;
  bool no_gnss_height_ = false;
};

void IgcReader::read_extensions(std::string_view line) {
  columns_.clear();
  for (std::size_t at = 3; at + 7 <= line.size(); at += 7) {
    const auto first = digits_of(line.substr(at, 2));
    const auto last = digits_of(line.substr(at + 2, 2));
    if (!first || !last || *first < 36 || *last < *first) continue;
    columns_[std::string(line.substr(at + 4, 3))] = {static_cast<std::size_t>(*first - 1),
                                                     static_cast<std::size_t>(*last - *first + 1)};
  }
}

void IgcReader::read_header(std::string_view line) {
  const std::string_view code = line.substr(2, 3);
  if (code == "DTE") read_date(line);
  if (code == "GTY" && line.find(':') != std::string_view::npos) {
    track_.name = clean_text(line.substr(line.find(':') + 1));
  }
  if (code != "ALG") return;
  const auto says = [&](const char* word) { return line.find(word, 5) != std::string_view::npos; };
  if (says("ELL")) track_.reference = HeightReference::ellipsoid;
  if (says("GEO") || says("MSL")) track_.reference = HeightReference::sea;
  no_gnss_height_ = says("NIL");
}

void IgcReader::read_date(std::string_view line) {
  const auto date = date_of(line);
  if (!date || date_ == date) return;
  if (date_ && count_ == 0)
    notes_.emplace_back("The header has several dates; the last was taken.");
  if (!date_) {
    for (Fix& fix : track_.segments[0]) *fix.time_s += *date * kDay_s;
    if (count_ > 0) last_s_ += *date * kDay_s;
  }
  date_ = date;
  day_ = *date;
  midnights_ = 0;
  ++dates_;
}

/// Returns the time of a fix. Without a new date, the clock passes midnight when it falls back by
/// more than half a day. A single wrong time that jumped forward before does not count.
double IgcReader::time_of_fix(int hhmmss, std::string_view fraction) {
  constexpr double kJump_s = 3600.0;
  constexpr std::size_t kShortJump = 3;
  double of_day_s = hhmmss / 10000 * 3600.0 + hhmmss / 100 % 100 * 60.0 + hhmmss % 100;
  if (const auto digits = digits_of(fraction)) {
    of_day_s += *digits / std::pow(10.0, static_cast<double>(fraction.size()));
  }
  const auto time = [&] { return (day_ + midnights_) * kDay_s + of_day_s; };
  if (last_s_ >= 0.0 && time() < last_s_ - kHalfDay_s) {
    const bool was_jump = before_jump_s_ >= 0.0 && since_jump_ <= kShortJump;
    if (!was_jump || time() < before_jump_s_) {
      ++midnights_;
      ++passed_midnights_;
    }
  }
  ++since_jump_;
  if (last_s_ >= 0.0 && time() > last_s_ + kJump_s) {
    before_jump_s_ = last_s_;
    since_jump_ = 1;
  }
  last_s_ = time();
  return last_s_;
}

void IgcReader::read_fix(std::string_view line) {
  if (!is_igc_fix(line)) {
    ++unread_;
    return;
  }
  Fix fix;
  const auto latitude = angle_of(line.substr(7, 8), extension(line, "LAD"), 'S');
  const auto longitude = angle_of(line.substr(15, 9), extension(line, "LOD"), 'W');
  fix.place = {latitude.value_or(999.0), longitude.value_or(999.0)};
  fix.valid = line[24] == 'A';
  if (const auto height = height_of(line.substr(25, 5))) fix.pressure_m = *height;
  if (const auto height = height_of(line.substr(30, 5))) fix.gnss_m = *height;
  fix.time_s = time_of_fix(*digits_of(line.substr(1, 6)), extension(line, "TDS"));
  add_fix(track_, fix, count_);
}

/// A fix that is marked V has no height of its own. Its place is used only if most fixes are such.
void IgcReader::settle_doubtful_fixes() {
  Segment& fixes = track_.segments[0];
  const auto is_doubtful = [](const Fix& fix) { return !fix.valid; };
  const auto doubtful =
      static_cast<std::size_t>(std::count_if(fixes.begin(), fixes.end(), is_doubtful));
  if (doubtful * 2 <= fixes.size()) return;
  for (Fix& fix : fixes) {
    if (fix.valid) continue;
    const bool has_place = fix.place.latitude_deg != 0.0 || fix.place.longitude_deg != 0.0;
    fix.valid = has_place && std::abs(fix.place.latitude_deg) <= 90.0;
    fix.gnss_m.reset();
  }
  track_.notes.push_back(fmt::format(
      "{} marked V, without GNSS height. They were used nevertheless, because most are like that.",
      counted(doubtful, "fix is", "fixes are")));
}

/// Phones and loggers without a sensor fill the columns of a height with zeros.
void IgcReader::settle_zero_heights() {
  Segment& fixes = track_.segments[0];
  const auto settle = [&](std::optional<double> Fix::*height, bool is_unknown, const char* name) {
    const bool is_zero = std::all_of(fixes.begin(), fixes.end(), [&](const Fix& fix) {
      return !fix.valid || (fix.*height).value_or(0.0) == 0.0;
    });
    if (!is_zero && !is_unknown) return;
    for (Fix& fix : fixes) (fix.*height).reset();
    track_.notes.push_back(fmt::format("The file has no {} heights, only zeros.", name));
  };
  settle(&Fix::pressure_m, false, "pressure");
  settle(&Fix::gnss_m, no_gnss_height_, "GNSS");
}

RawFile IgcReader::result() {
  if (unread_ > 0) {
    notes_.push_back(fmt::format("{} could not be read and cannot be used.",
                                 counted(unread_, "line of a fix", "lines of fixes")));
  }
  settle_doubtful_fixes();
  settle_zero_heights();
  if (!date_) {
    track_.clock = Clock::of_day;
    track_.notes.emplace_back("The file names no date, so only the time of day is known.");
  }
  if (passed_midnights_ > 0) {
    track_.notes.push_back(fmt::format("The clock passed midnight {} without a new date.",
                                       counted(passed_midnights_, "time", "times")));
  }
  if (dates_ > 1) {
    track_.notes.push_back(fmt::format("The file has {} dates, each for what follows it.", dates_));
  }
  return {{std::move(track_)}, std::move(notes_)};
}

}  // namespace

bool is_igc_fix(std::string_view line) {
  if (line.size() < 35 || line[0] != 'B') return false;
  const auto time = digits_of(line.substr(1, 6));
  if (!time || *time / 10000 > 23 || *time / 100 % 100 > 59 || *time % 100 > 60) return false;
  const bool has_letters = (line[14] == 'N' || line[14] == 'S') &&
                           (line[23] == 'E' || line[23] == 'W') &&
                           (line[24] == 'A' || line[24] == 'V');
  return has_letters && digits_of(line.substr(7, 7)) && digits_of(line.substr(15, 8));
}

RawFile read_igc(std::string_view bytes) {
  IgcReader reader;
  bytes = without_mark(bytes);
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    const std::string_view line = trimmed(bytes.substr(0, end));
    if (!line.empty()) reader.read(line);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return reader.result();
}

}  // namespace aerostat::track

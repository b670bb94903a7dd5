#include "scene/json_text.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/dot_decimals.hpp"
#include "core/error.hpp"
#include "scene/faults.hpp"
#include "scene/locate.hpp"

namespace aerostat::scene::detail {

namespace {

constexpr std::size_t kShownLength = 60;
constexpr std::size_t kLongestComplaint = 200;

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

/// Returns at most `length` bytes of `text`, cut between characters.
std::string shortened(std::string text, std::size_t length) {
  if (text.size() <= length) return text;
  std::size_t end = length;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

/// Follows the parser, so that it knows the pointer of the current value. Throws where a limit is
/// passed.
class Watcher {
 public:
  Watcher(const std::string& name, const JsonRules& rules) : name_(name), rules_(rules) {}

  bool operator()(Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::key) {
      enter_key(parsed.get_ref<const std::string&>());
    } else if (event == Event::object_start || event == Event::array_start) {
      if (frames_.size() == rules_.most_depth) {
        fail(name_, pointer(), "deeper nesting",
             fmt::format("at most {} levels", rules_.most_depth));
      }
      frames_.push_back({event == Event::array_start, 0, {}, {}});
    } else {
      if (event != Event::value) frames_.pop_back();
      leave_value();
    }
    return true;
  }

  /// Returns the pointers of the keys that an object has twice.
  const std::vector<Pointer>& twice() const { return twice_; }

  /// Returns the pointer of the value that is being read.
  Pointer pointer() const {
    Pointer result;
    for (const Frame& frame : frames_) {
      if (frame.is_array) {
        result.push_back(std::to_string(frame.index));
      } else if (!frame.keys.empty()) {
        result.push_back(frame.key);
      }
    }
    return result;
  }

 private:
  struct Frame {
    bool is_array = false;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  void enter_key(const std::string& key) {
    Frame& frame = frames_.back();
    frame.key = key;
    if (!frame.keys.insert(key).second) twice_.push_back(pointer());
  }

  void leave_value() {
    if (++values_ > rules_.most_values) {
      fail(name_, pointer(), "too many values",
           fmt::format("at most {} in a file", rules_.most_values));
    }
    if (!frames_.empty()) ++frames_.back().index;
  }

  const std::string& name_;
  const JsonRules& rules_;
  std::vector<Frame> frames_;
  std::vector<Pointer> twice_;
  std::size_t values_ = 0;
};

/// Returns the line and column of the last character that the parser has read.
std::string position(std::string_view text, std::size_t bytes_read) {
  const std::size_t read = std::min(bytes_read, text.size());
  const TextPlace place = place_of(text, read == 0 ? 0 : read - 1);
  return fmt::format("line {}, column {}", place.line, place.column);
}

/// Returns the parser's message without its prefix and without the last text read, which may be
/// long.
std::string syntax_complaint(const std::string& what) {
  const std::size_t start = what.find("syntax error");
  std::string complaint = start == std::string::npos ? what : what.substr(start);
  const std::size_t token = complaint.find("; last read: '");
  if (token != std::string::npos) {
    const std::size_t quote = complaint.rfind("'; expected ");
    const bool says = quote != std::string::npos && quote > token;
    // The text may itself contain what the parser writes behind it, so only short ASCII is kept.
    const std::string expected = says ? complaint.substr(quote + 1) : "";
    complaint.resize(token);
    if (expected.size() <= kShownLength && is_printable(expected)) complaint += expected;
  }
  return shortened(std::move(complaint), kLongestComplaint);
}

}  // namespace

std::string to_string(const Pointer& pointer) {
  if (pointer.empty()) return "/";
  std::string result;
  for (const std::string& token : pointer) {
    const std::string visible = quoted(token);
    result += '/';
    for (const char c : visible.substr(1, visible.size() - 2)) {
      if (c == '~') {
        result += "~0";
      } else if (c == '/') {
        result += "~1";
      } else {
        result += c;
      }
    }
  }
  return result;
}

void fail(const std::string& name, const Pointer& pointer, const std::string& found,
          const std::string& expected) {
  throw BadScene(name, {{pointer, found, expected}});
}

std::string describe(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) {
    const bool plain =
        value.size() <= 4 &&
        std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); });
    return plain ? value.dump() : fmt::format("an array of {}", value.size());
  }
  if (value.is_string()) {
    const std::string text = shortened(value.get_ref<const std::string&>(), kShownLength);
    return quoted(text);
  }
  return value.dump();
}

bool is_json(std::string_view text) {
  const DotDecimals dot;
  return Json::accept(text.begin(), text.end(), true);
}

Json parse_json(std::string_view text, const std::string& name) {
  return parse_json(text, name, JsonRules());
}

Json parse_json(std::string_view text, const std::string& name, const JsonRules& rules) {
  Faults faults(name);
  Json json = parse_json(text, faults, rules);
  faults.throw_if_any();
  return json;
}

Json parse_json(std::string_view text, Faults& faults, const JsonRules& rules) {
  const std::string& name = faults.name();
  const DotDecimals dot;
  Watcher watcher(name, rules);
  const auto callback = [&watcher](int, Json::parse_event_t event, Json& parsed) {
    return watcher(event, parsed);
  };
  try {
    Json json = Json::parse(text.begin(), text.end(), callback, true, rules.with_comments);
    for (const Pointer& pointer : watcher.twice())
      faults.add(pointer, "this key twice", "this key once");
    return json;
  } catch (const Json::parse_error& error) {
    throw Error(ErrorKind::bad_data, fmt::format("{}: {}: {}", name, position(text, error.byte),
                                                 syntax_complaint(error.what())));
  } catch (const Json::out_of_range&) {
    fail(name, watcher.pointer(), "a number that is too large", "a finite number");
  }
}

}  // namespace aerostat::scene::detail

#include "scene/locate.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace aerostat::scene::detail {

namespace {

/// Moves over JSON text that is known to be valid and may contain comments.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
    skip_blank();
  }

  std::size_t at() const { return at_; }
  void go_to(std::size_t at) { at_ = at; }
  bool is_at(char c) const { return at_ < text_.size() && text_[at_] == c; }

  /// Moves past one character and the blanks and comments after it.
  void step() {
    ++at_;
    skip_blank();
  }

  /// Moves past a string and returns its value.
  std::string read_string() {
    const std::size_t start = at_;
    skip_string();
    const Json value = Json::parse(text_.substr(start, at_ - start), nullptr, false);
    skip_blank();
    return value.is_string() ? value.get<std::string>() : std::string();
  }

  /// Moves past a value and the blanks and comments after it.
  void skip_value() {
    int depth = 0;
    do {
      if (is_at('"')) {
        skip_string();
      } else if (is_at('{') || is_at('[')) {
        ++depth;
        ++at_;
      } else if (is_at('}') || is_at(']')) {
        --depth;
        ++at_;
      } else if (is_at(',') || is_at(':')) {
        ++at_;
      } else {
        at_ = std::min(text_.find_first_of(" \t\r\n,:]}/", at_ + 1), text_.size());
      }
      skip_blank();
    } while (depth > 0 && at_ < text_.size());
  }

 private:
  void skip_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\' ? 1 : 0;
    ++at_;
  }

  void skip_blank() {
    constexpr std::string_view kBlank = " \t\r\n";
    while (at_ < text_.size()) {
      if (text_.substr(at_, 2) == "//") {
        at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
      } else if (kBlank.find(text_[at_]) != std::string_view::npos) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Returns the place where the member `key` of the current object begins, and moves to its value.
/// Returns nothing if there is no such member.
std::optional<std::size_t> enter_member(Walk& walk, const std::string& key) {
  std::optional<std::size_t> found;
  std::size_t value = 0;
  walk.step();
  while (walk.is_at('"')) {
    const std::size_t start = walk.at();
    const bool is_it = walk.read_string() == key;
    walk.step();  // moves past the colon
    if (is_it) {
      found = start;
      value = walk.at();
    }
    walk.skip_value();
    if (walk.is_at(',')) walk.step();
  }
  if (found) walk.go_to(value);
  return found;
}

std::optional<std::size_t> enter_element(Walk& walk, const std::string& token) {
  walk.step();
  for (std::size_t i = 0; !walk.is_at(']'); ++i) {
    if (std::to_string(i) == token) return walk.at();
    const std::size_t before = walk.at();
    walk.skip_value();
    if (walk.is_at(',')) walk.step();
    if (walk.at() == before) break;
  }
  return std::nullopt;
}

}  // namespace

TextPlace place_of(std::string_view text, std::size_t bytes) {
  const std::string_view before = text.substr(0, bytes);
  const std::size_t end = before.rfind('\n');
  const std::string_view line = end == std::string_view::npos ? before : before.substr(end + 1);
  const auto is_first = [](char c) { return (c & 0xC0) != 0x80; };
  return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(std::count_if(line.begin(), line.end(), is_first)) + 1};
}

TextPlace locate(std::string_view text, const Pointer& pointer) {
  Walk walk(text);
  std::size_t best = walk.at();
  for (const std::string& token : pointer) {
    std::optional<std::size_t> found;
    if (walk.is_at('{')) {
      found = enter_member(walk, token);
    } else if (walk.is_at('[')) {
      found = enter_element(walk, token);
    }
    if (!found) break;
    best = *found;
  }
  return place_of(text, best);
}

}  // namespace aerostat::scene::detail

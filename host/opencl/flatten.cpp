#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "opencl/program.hpp"

namespace aerostat::opencl {
namespace {

std::string_view without_leading_space(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

bool is_one_of(char c, std::string_view characters) {
  return characters.find(c) != std::string_view::npos;
}

/// Returns the text after `#name` if `line` is that directive, or nothing.
std::optional<std::string_view> directive(std::string_view line, std::string_view name) {
  line = without_leading_space(line);
  if (line.empty() || line.front() != '#') return std::nullopt;
  line = without_leading_space(line.substr(1));
  if (!line.starts_with(name)) return std::nullopt;
  line.remove_prefix(name.size());
  const bool whole_word = line.empty() || is_one_of(line.front(), " \t\r\"</");
  return whole_word ? std::optional(without_leading_space(line)) : std::nullopt;
}

/// Returns the file of an `#include "file"`, or nothing. System includes are not followed.
std::optional<std::string> included_name(std::string_view line) {
  const auto rest = directive(line, "include");
  if (!rest || rest->empty() || rest->front() != '"') return std::nullopt;
  const auto end = rest->find('"', 1);
  if (end == std::string_view::npos) return std::nullopt;
  return std::string(rest->substr(1, end - 1));
}

/// Tracks whether a line begins inside a block comment, in which a directive is only text.
class CommentTracker {
 public:
  bool inside() const { return inside_; }

  void advance(std::string_view line) {
    bool in_string = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto pair = line.substr(i, 2);
      if (inside_) {
        if (pair == "*/") inside_ = false, ++i;
      } else if (in_string) {
        if (line[i] == '\\')
          ++i;
        else if (line[i] == '"')
          in_string = false;
      } else if (pair == "//") {
        return;
      } else if (pair == "/*") {
        inside_ = true;
        ++i;
      } else {
        in_string = line[i] == '"';
      }
    }
  }

 private:
  bool inside_ = false;
};

/// Counts the `#if`s around a line. The guard around a whole header does not count.
class ConditionTracker {
 public:
  bool conditional() const { return depth_ > (guarded_ ? 1 : 0); }

  void advance(std::string_view line) {
    const auto ifndef = directive(line, "ifndef");
    if (directive(line, "define")) {
      guarded_ = guarded_ || (directives_ == 1 && depth_ == 1 && first_is_ifndef_);
    }
    if (directives_ == 0 && ifndef) first_is_ifndef_ = true;
    if (ifndef || directive(line, "if") || directive(line, "ifdef")) ++depth_;
    if (directive(line, "endif")) --depth_;
    if (without_leading_space(line).starts_with('#')) ++directives_;
  }

 private:
  int depth_ = 0;
  int directives_ = 0;
  bool first_is_ifndef_ = false;
  bool guarded_ = false;
};

class Flattener {
 public:
  explicit Flattener(const SourceTree& sources) : sources_(sources) {}

  void add(const std::string& path, bool conditional) {
    seen_.emplace(path, conditional);
    mark(1, path);
    CommentTracker comment;
    ConditionTracker condition;
    int number = 1;
    std::string_view text = sources_.at(path);
    for (; !text.empty(); ++number) {
      const auto end = std::min(text.find('\n'), text.size());
      const auto line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      const bool code = !comment.inside();
      comment.advance(line);
      if (code) condition.advance(line);
      const auto name = code ? included_name(line) : std::nullopt;
      if (name) {
        include(*name, path, number, conditional || condition.conditional());
      } else if (!code || !is_once(line)) {
        result_.append(line);
      }
      result_ += '\n';
    }
  }

  std::string take() { return std::move(result_); }

 private:
  static bool is_once(std::string_view line) {
    const auto pragma = directive(line, "pragma");
    return pragma && pragma->starts_with("once");
  }

  void mark(int line, const std::string& path) {
    result_ += fmt::format("#line {} \"{}\"\n", line, path);
  }

  void include(const std::string& name, const std::string& from, int line, bool conditional) {
    const auto path = find(name, from);
    if (!path) {
      throw Error(ErrorKind::internal,
                  fmt::format("{}:{}: there is no kernel file \"{}\"", from, line, name));
    }
    const auto former = seen_.find(*path);
    if (former == seen_.end()) {
      add(*path, conditional);
      mark(line, from);
    } else if (former->second && !conditional) {
      // The text of the file stands where the preprocessor may skip it, so it could be missing
      // here.
      throw Error(ErrorKind::internal,
                  fmt::format("{}:{}: \"{}\" was first included inside an #if: include it before",
                              from, line, name));
    }
  }

  std::optional<std::string> find(const std::string& name, const std::string& from) const {
    namespace fs = std::filesystem;
    for (const fs::path& folder :
         {fs::path(from).parent_path(), fs::path("device"), fs::path("shared"), fs::path()}) {
      auto path = (folder / name).lexically_normal().generic_string();
      if (sources_.contains(path)) return path;
    }
    return std::nullopt;
  }

  const SourceTree& sources_;
  /// The included files, and whether each of them stands under a condition.
  std::map<std::string, bool> seen_;
  std::string result_;
};

}  // namespace

std::string flatten(const SourceTree& sources, const std::string& entry) {
  if (!sources.contains(entry)) {
    throw Error(ErrorKind::internal, fmt::format("there is no kernel file \"{}\"", entry));
  }
  Flattener flattener(sources);
  flattener.add(entry, false);
  return flattener.take();
}

}  // namespace aerostat::opencl

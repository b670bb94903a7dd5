#include "asset/files.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "asset/words.hpp"
#include "core/error.hpp"

namespace aerostat::asset {
namespace {

namespace fs = std::filesystem;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Returns the absolute path without symbolic links, or an empty path if the system cannot tell it.
fs::path whole(const fs::path& path) {
  std::error_code failed;
  const fs::path result = fs::weakly_canonical(path, failed);
  return failed ? fs::path() : result;
}

bool is_within(const fs::path& path, const fs::path& folder) {
  const auto [end_of_folder, ignored] =
      std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return !path.empty() && !folder.empty() && end_of_folder == folder.end();
}

/// Returns the entry of a folder whose name is `name` if capital letters are ignored. If there are
/// several, it returns the first in alphabetical order.
std::optional<fs::path> entry_like(const fs::path& folder, const std::string& name) {
  std::error_code failed;
  std::optional<fs::path> found;
  const std::string wanted = lower_case(name);
  fs::directory_iterator entry(folder, failed);
  for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    const fs::path path = entry->path();
    const bool fits = lower_case(path.filename().string()) == wanted;
    if (fits && (!found || path < *found)) found = path;
  }
  return found;
}

/// Returns the path of the file at `relative` in `folder`. Capital letters are ignored where no
/// name matches exactly.
fs::path file_like(const fs::path& folder, const fs::path& relative) {
  std::error_code failed;
  fs::path path = folder;
  for (const fs::path& part : relative) {
    const fs::path exact = path / part;
    const bool exists = fs::exists(exact, failed);
    path = exists ? exact : entry_like(path, part.string()).value_or(exact);
  }
  return path;
}

}  // namespace

std::string bytes_of(const fs::path& file, std::uint64_t most) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) {
    throw Error(ErrorKind::io, fmt::format("{}: cannot be read: {}", file.string(),
                                           failed ? failed.message() : "it is not a regular file"));
  }
  const std::uint64_t size = fs::file_size(file, failed);
  if (!failed && size > most) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: the file has {} bytes, and at most {} are read", file.string(),
                            size, most));
  }
  std::string bytes(failed ? 0 : static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (failed || !stream) {
    throw Error(ErrorKind::io, fmt::format("{}: the file cannot be read", file.string()));
  }
  return bytes;
}

Files::Files(fs::path file, const ReadOptions& options)
    : beside_(file.parent_path().empty() ? fs::path(".") : file.parent_path()),
      root_(whole(options.folder.value_or(beside_))),
      allow_external_(options.allow_external),
      most_bytes_(options.limits.file_bytes) {}

fs::path Files::find(std::string_view reference) const {
  std::string text(reference);
  std::replace(text.begin(), text.end(), '\\', '/');
  const std::string shown = in_quotes(reference);
  if (text.empty() || text.find('\0') != std::string::npos) refuse(shown + " is not a file's name");
  const bool has_drive = text.size() > 1 && text[1] == ':' && is_letter(text[0]);
  if ((text[0] == '/' || has_drive) && !allow_external_) {
    refuse(shown + " is an absolute path, expected one that begins at the folder of the model");
  }
  const fs::path path = file_like(text[0] == '/' ? fs::path("/") : beside_,
                                  fs::path(text[0] == '/' ? text.substr(1) : text));
  if (!allow_external_ && !is_within(whole(path), root_)) {
    refuse(fmt::format("{} lies outside of the folder {}", shown, root_.string()));
  }
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) refuse(fmt::format("there is no file {}", shown));
  return path;
}

std::string Files::read(const fs::path& path) const {
  return bytes_of(path, most_bytes_);
}

bool has_scheme(std::string_view reference) {
  const std::size_t colon = reference.find(':');
  if (colon == std::string_view::npos || colon < 2 || !is_letter(reference[0])) return false;
  return std::all_of(
      reference.begin(), reference.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '.' || c == '-';
      });
}

std::string percent_decoded(std::string_view reference) {
  std::string result;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = reference.data() + i + 1;
    const bool is_code = reference[i] == '%' && i + 2 < reference.size() &&
                         std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    result += is_code ? static_cast<char>(byte) : reference[i];
    if (is_code) i += 2;
  }
  return result;
}

}  // namespace aerostat::asset

#include "artwork/svg.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>

#include <fmt/format.h>

#include "asset/files.hpp"
#include "core/child_process.hpp"
#include "core/error.hpp"

namespace aerostat::artwork {
namespace {

namespace fs = std::filesystem;

/// How much of a file is looked through for the first element of an SVG drawing.
constexpr std::size_t kStartBytes = 65536;
/// The names of the files in the folder of the program.
constexpr const char *kInput = "drawing.svg", *kOutput = "drawing.png", *kStyle = "style.css";

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw Error(ErrorKind::bad_data, fmt::format("{}: {}", file.string(), what));
}

/// Returns the files that the program may use: itself with its libraries, and fonts.
ReachableFiles files_for(const fs::path& program, const fs::path& folder) {
  ReachableFiles files = files_of_program(program, folder);
  files.readable.insert(files.readable.end(), {"/etc/fonts", "/var/cache/fontconfig"});
  return files;
}

void write(const fs::path& file, std::string_view bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw Error(ErrorKind::io, fmt::format("cannot write {}", file.string()));
}

/// Returns the command that draws a file in a folder of its own.
std::vector<std::string> command_for(const fs::path& program, const fs::path& folder,
                                     const DrawingSize& size) {
  std::vector<std::string> command{program.string(),
                                   "--format=png",
                                   fmt::format("--width={}", size.width),
                                   fmt::format("--height={}", size.height),
                                   "--stylesheet=" + (folder / kStyle).string(),
                                   "--output=" + (folder / kOutput).string()};
  if (size.keeps_proportions) command.emplace_back("--keep-aspect-ratio");
  command.push_back((folder / kInput).string());
  return command;
}

}  // namespace

bool is_svg(std::string_view bytes) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
  const std::string_view start = bytes.substr(0, kStartBytes);
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || start[first] != '<') return false;
  return start.find("<svg") != std::string_view::npos ||
         start.find(":svg") != std::string_view::npos;
}

std::optional<std::string> first_reference(std::string_view text) {
  constexpr std::string_view kKey = "href";
  for (std::size_t at = text.find(kKey); at != std::string_view::npos; at = text.find(kKey, at)) {
    at += kKey.size();
    const std::size_t mark = text.find_first_not_of(" \t\r\n=", at);
    if (mark == at || mark == std::string_view::npos) continue;
    if (text[mark] != '"' && text[mark] != '\'') continue;
    const std::size_t end = text.find(text[mark], mark + 1);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view value = text.substr(mark + 1, end - mark - 1);
    if (value.empty() || value[0] == '#' || value.starts_with("data:")) continue;
    // A link to a page is no picture.
    if (text.substr(text.rfind('<', at)).starts_with("<a ")) continue;
    return std::string(value.substr(0, 100));
  }
  return std::nullopt;
}

asset::Texture draw_svg(std::string_view bytes, const fs::path& file, const DrawingSize& size,
                        std::vector<std::string>& notes) {
  const fs::path program = find_program("rsvg-convert", "AEROSTAT_RSVG_CONVERT");
  if (program.empty()) {
    refuse(
        file,
        "this is an SVG drawing, which the program rsvg-convert of librsvg draws, and it was not "
        "found. Install it (on Debian and Ubuntu, the package librsvg2-bin), set "
        "AEROSTAT_RSVG_CONVERT to its path, or save the drawing as PNG");
  }
  if (const auto reference = first_reference(bytes)) {
    notes.push_back(
        fmt::format("The drawing refers to {}, which is not read. Pictures must be embedded in it.",
                    *reference));
  }
  // Nothing lies beside the copy in its folder, so that relative names lead nowhere.
  const PrivateFolder folder;
  const fs::path input = folder.path() / kInput;
  write(input, bytes);
  write(folder.path() / kStyle, fmt::format("#{} {{ display: none !important; }}\n", kGuidesId));
  ChildLimits limits;
  limits.memory_bytes = std::uint64_t{3} << 30;
  limits.file_bytes = std::uint64_t{1} << 30;
  limits.processor_s = 60;
  limits.waiting_s = 120;
  limits.files = files_for(program, folder.path());
  const std::string home = folder.path().string();
  const ChildResult result = run_limited(command_for(program, folder.path(), size),
                                         {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "HOME=" + home,
                                          "TMPDIR=" + home, "XDG_CACHE_HOME=" + home},
                                         limits);
  if (result.took_too_long) refuse(file, "drawing it took too long and was stopped");
  if (result.status != 0) {
    std::string complaint = complaint_of(result);
    // The name of the copy says nothing to the user.
    const std::size_t name = complaint.find(input.string());
    if (name != std::string::npos) complaint.replace(name, input.string().size(), "the drawing");
    refuse(file, fmt::format("rsvg-convert cannot draw it ({})", complaint));
  }
  return decode_picture(asset::bytes_of(folder.path() / kOutput, kMostPictureBytes), file);
}

}  // namespace aerostat::artwork

#include "opencl/program_seal.hpp"

#include <optional>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "core/checksum.hpp"
#include "opencl/kept_file.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKind = "aerostat seal ";
constexpr std::string_view kHead = "aerostat seal 1\n";
/// The length of the last line, which has 16 hexadecimal digits and a line end.
constexpr std::size_t kSumBytes = 17;

std::string sum_line(std::string_view text) {
  return fmt::format("{:016x}\n", checksum(text));
}

}  // namespace

SealState read_seal(const fs::path& folder, Seal& seal) {
  seal.clear();
  std::error_code ignored;
  const fs::path path = folder / kSealName;
  if (fs::symlink_status(path, ignored).type() == fs::file_type::not_found) return SealState::none;
  const auto text = read_kept_file(path);
  if (!text || text->size() < kHead.size() + kSumBytes) return SealState::damaged;
  const std::string_view body(text->data(), text->size() - kSumBytes);
  if (std::string_view(*text).substr(body.size()) != sum_line(body)) return SealState::damaged;
  if (!body.starts_with(kHead)) {
    return body.starts_with(kKind) ? SealState::none : SealState::damaged;
  }
  std::istringstream lines{std::string(body.substr(kHead.size()))};
  SealedFile file;
  std::string name;
  while (lines >> file.bytes >> file.inode >> file.modified_ns >> file.changed_ns >>
             file.checksum >> std::ws &&
         std::getline(lines, name)) {
    seal[name] = file;
  }
  return SealState::whole;
}

bool write_seal(const fs::path& folder, const Seal& seal) {
  std::string text(kHead);
  for (const auto& [name, file] : seal) {
    text += fmt::format("{} {} {} {} {} {}\n", file.bytes, file.inode, file.modified_ns,
                        file.changed_ns, file.checksum, name);
  }
  return write_kept_file(folder / kSealName, text + sum_line(text));
}

}  // namespace aerostat::opencl

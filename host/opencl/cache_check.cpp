#include "opencl/cache_check.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/checksum.hpp"
#include "core/error.hpp"
#include "opencl/cache_use.hpp"
#include "opencl/kept_file.hpp"
#include "opencl/program_seal.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

std::optional<SealedFile> numbers_of(const fs::path& path) {
  struct stat status = {};
  if (lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  const auto nanoseconds = [](const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  };
  return SealedFile{static_cast<std::uint64_t>(status.st_size), status.st_ino,
                    nanoseconds(status.st_mtim), nanoseconds(status.st_ctim), 0};
}

template <typename T>
T value_at(std::string_view bytes, std::size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// Returns whether a shared library is not cut off. A linker writes the section headers last, so a
/// file that contains them is whole.
bool is_whole_library(std::string_view bytes) {
  if (bytes.size() < sizeof(Elf64_Ehdr) || !bytes.starts_with(ELFMAG)) return false;
  const auto head = value_at<Elf64_Ehdr>(bytes, 0);
  if (head.e_ident[EI_CLASS] != ELFCLASS64) return true;
  const auto holds = [&](std::uint64_t offset, std::uint64_t count, std::uint64_t item) {
    return count > 0 && offset <= bytes.size() && count * item <= bytes.size() - offset;
  };
  return holds(head.e_shoff, head.e_shnum, head.e_shentsize) &&
         holds(head.e_phoff, head.e_phnum, head.e_phentsize);
}

/// Returns whether a file of LLVM bitcode is not cut off. Bitcode is a sequence of blocks that
/// state their lengths. Source: LLVM Bitcode File Format.
bool is_whole_bitcode(std::string_view bytes) {
  if (!bytes.starts_with("BC\xC0\xDE")) return false;
  std::size_t at = 4;
  while (bytes.size() - at >= 8) {
    const std::uint64_t block_bytes = std::uint64_t{value_at<std::uint32_t>(bytes, at + 4)} * 4;
    const bool is_block = (value_at<std::uint32_t>(bytes, at) & 3u) == 1u;
    if (!is_block || block_bytes > bytes.size() - at - 8) return false;
    at += 8 + block_bytes;
  }
  return at > 4 && at == bytes.size();
}

/// Returns whether PoCL loads files of this name as code.
bool is_code(const fs::path& path) {
  return path.extension() == ".so" || path.extension() == ".bc";
}

bool is_whole_code(const fs::path& path, std::string_view bytes) {
  return path.extension() == ".so" ? is_whole_library(bytes) : is_whole_bitcode(bytes);
}

bool is_sound_code(const fs::path& path, const SealedFile* sealed) {
  auto now = numbers_of(path);
  if (!now) return false;
  if (sealed != nullptr) {
    now->checksum = sealed->checksum;
    if (*now == *sealed) return true;
  }
  const auto bytes = read_kept_file(path);
  if (!bytes) return false;
  return sealed != nullptr ? checksum(*bytes) == sealed->checksum : is_whole_code(path, *bytes);
}

bool is_usable_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() == fs::file_type::directory &&
         access(path.c_str(), R_OK | W_OK | X_OK) == 0;
}

/// Calls `visit` with every entry of the folder, but not with those of its subfolders. Does nothing
/// if the folder cannot be read.
template <typename F>
void for_entries(const fs::path& folder, F&& visit) {
  std::error_code error;
  for (fs::directory_iterator entries(folder, error), end; !error && entries != end;
       entries.increment(error)) {
    visit(entries->path());
  }
}

/// Returns whether a path is named as a folder of a program, a kernel or a size. The names of these
/// folders contain no dot.
bool is_named_as_folder(const fs::path& path) {
  return !path.has_extension() && path.filename() != "last_accessed";
}

bool is_sound_folder(const fs::path& program, const fs::path& folder, const Seal& seal) {
  if (!is_usable_folder(folder)) return false;
  bool is_sound = true;
  for_entries(folder, [&](const fs::path& entry) {
    if (!is_sound) return;
    if (is_named_as_folder(entry)) {
      is_sound = is_sound_folder(program, entry, seal);
    } else if (is_code(entry)) {
      const auto sealed = seal.find(entry.lexically_relative(program).string());
      is_sound = is_sound_code(entry, sealed == seal.end() ? nullptr : &sealed->second);
    }
  });
  return is_sound;
}

bool is_sound_program(const fs::path& program) {
  if (!is_usable_folder(program)) return false;
  Seal seal;
  return read_seal(program, seal) != SealState::damaged && is_sound_folder(program, program, seal);
}

/// Returns whether PoCL names a folder of programs so. Such a name is two of the letters A to P. A
/// program's name is 37 of these letters.
bool is_named_as_group(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.size() == 2 && name.find_first_not_of("ABCDEFGHIJKLMNOP") == std::string::npos;
}

bool is_named_as_program(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.size() > 30 && name.find_first_not_of("ABCDEFGHIJKLMNOP") == std::string::npos;
}

std::vector<fs::path> entries_named(const fs::path& folder, bool (*is_named)(const fs::path&)) {
  std::vector<fs::path> found;
  for_entries(folder, [&](const fs::path& entry) {
    if (is_named(entry)) found.push_back(entry);
  });
  return found;
}

void remove_or_throw(const fs::path& path) {
  if (remove_kept(path)) return;
  throw Error(
      ErrorKind::io,
      fmt::format("{} is damaged or belongs to another user and cannot be removed; remove it",
                  path.string()));
}

/// Returns the folders of the programs that are damaged, or those of all groups of programs.
std::vector<fs::path> damaged_in(const fs::path& cache, bool all) {
  std::vector<fs::path> damaged;
  for (const auto& group : entries_named(cache, is_named_as_group)) {
    if (all || !is_usable_folder(group)) {
      damaged.push_back(group);
      continue;
    }
    for (const auto& program : entries_named(group, is_named_as_program)) {
      if (!is_sound_program(program)) damaged.push_back(program);
    }
  }
  return damaged;
}

/// Adds to the seal every file of code that is new or has changed. Returns whether there was one.
bool add_to_seal(const fs::path& program, Seal& seal) {
  bool is_new = false;
  std::error_code error;
  for (fs::recursive_directory_iterator entries(program, error), end; !error && entries != end;
       entries.increment(error)) {
    const fs::path& path = entries->path();
    auto now = is_code(path) ? numbers_of(path) : std::nullopt;
    if (!now) continue;
    auto& sealed = seal[path.lexically_relative(program).string()];
    now->checksum = sealed.checksum;
    if (*now == sealed) continue;
    const auto bytes = read_kept_file(path);
    if (!bytes) continue;
    now->checksum = checksum(*bytes);
    sealed = *now;
    is_new = true;
  }
  return is_new;
}

/// Writes the sealed files to the disk, because a seal must not outlast its files when the power
/// fails.
void put_on_disk(const fs::path& program, const Seal& seal) {
  for (const auto& [name, file] : seal) {
    const int descriptor = open((program / name).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) continue;
    fsync(descriptor);
    close(descriptor);
  }
}

}  // namespace

fs::path suspect_mark(const fs::path& cache) {
  return cache / "aerostat.suspect";
}

std::size_t remove_damaged_programs(const fs::path& cache) {
  const auto is_suspect = [&cache] {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(suspect_mark(cache), ignored));
  };
  if (!is_suspect() && damaged_in(cache, false).empty()) return 0;
  // Another process may have removed them while this one waited.
  const CacheUse alone(cache, CacheUse::Kind::alone);
  const bool all = is_suspect();
  const auto damaged = damaged_in(cache, all);
  for (const auto& path : damaged) remove_or_throw(path);
  if (all) remove_or_throw(suspect_mark(cache));
  return damaged.size();
}

void seal_programs(const fs::path& cache) {
  for (const auto& group : entries_named(cache, is_named_as_group)) {
    for (const auto& program : entries_named(group, is_named_as_program)) {
      Seal seal;
      read_seal(program, seal);
      if (!add_to_seal(program, seal)) continue;
      put_on_disk(program, seal);
      write_seal(program, seal);
    }
  }
}

}  // namespace aerostat::opencl

#include "core/leftovers.hpp"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <sys/types.h>
#include <unistd.h>

#include "core/checksum.hpp"

namespace aerostat {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFront = ".aerostat-";
constexpr std::string_view kBack = ".tmp";

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns a number for the system whose processes can be seen from here: of this start of the
/// machine and of this container. It is 0 if that cannot be told.
std::uint64_t system_number() {
  static const std::uint64_t number = [] {
    std::error_code error;
    const std::string boot = text_of("/proc/sys/kernel/random/boot_id");
    const fs::path space = fs::read_symlink("/proc/self/ns/pid", error);
    return boot.empty() || error ? 0 : checksum(boot + space.string());
  }();
  return number;
}

/// Returns when a process began, in ticks since the start of the machine, or 0 if there is none.
std::uint64_t start_of(std::int64_t process) {
  const std::string text = text_of(fmt::format("/proc/{}/stat", process));
  // The name of the program stands in brackets and may have blanks. The start is the 20th number
  // behind it.
  std::size_t at = text.rfind(')');
  for (int i = 0; i < 20 && at != std::string::npos; ++i) at = text.find(' ', at + 1);
  std::uint64_t start = 0;
  if (at == std::string::npos) return 0;
  std::from_chars(text.data() + at + 1, text.data() + text.size(), start);
  return start;
}

/// What the name of a temporary file tells. System and start are 0 if it does not tell them.
struct Owner {
  std::int64_t process = 0;
  std::uint64_t number = 0, system = 0, start = 0;
};

std::optional<Owner> owner_of(std::string_view name) {
  if (!name.starts_with(kFront) || !name.ends_with(kBack)) return std::nullopt;
  const char* at = name.data() + kFront.size();
  const char* const end = name.data() + name.size() - kBack.size();
  Owner owner;
  const auto take = [&at, end](auto& value, int base) {
    const auto [next, error] = std::from_chars(at, end, value, base);
    const bool is_good = error == std::errc{} && (next == end || *next == '-');
    at = is_good && next != end ? next + 1 : next;
    return is_good;
  };
  if (!take(owner.process, 10) || !take(owner.number, 10) || owner.process <= 0) {
    return std::nullopt;
  }
  if (at == end) return owner;
  if (!take(owner.system, 16) || !take(owner.start, 10) || at != end) return std::nullopt;
  return owner;
}

bool is_old(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  return !error && written < fs::file_time_type::clock::now() - std::chrono::hours(1);
}

bool is_gone(const Owner& owner) {
  return ::kill(static_cast<pid_t>(owner.process), 0) != 0 && errno == ESRCH;
}

bool is_leftover(const fs::path& file) {
  const auto owner = owner_of(file.filename().string());
  if (!owner) return false;
  if (owner->system != 0 && owner->system == system_number()) {
    return owner->start != start_of(owner->process);
  }
  return is_gone(*owner) && is_old(file);
}

}  // namespace

fs::path temporary_name(const fs::path& folder) {
  static std::atomic<unsigned> counter{0};
  const std::int64_t process = ::getpid();
  return folder / fmt::format("{}{}-{}-{:x}-{}{}", kFront, process, counter++, system_number(),
                              start_of(process), kBack);
}

void remove_leftovers(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (!is_leftover(at->path())) continue;
    std::error_code ignored;
    fs::remove(at->path(), ignored);
  }
}

}  // namespace aerostat

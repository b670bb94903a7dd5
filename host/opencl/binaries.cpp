#include "opencl/binaries.hpp"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/checksum.hpp"
#include "core/environment.hpp"
#include "core/error.hpp"
#include "opencl/cache.hpp"
#include "opencl/kept_file.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVariable = "AEROSTAT_KERNEL_BINARIES";
constexpr const char* kExtension = ".clbin";

/// Returns the first part of a file, in front of the binary and the checksum of both. Its length
/// depends only on the length of the key.
std::string head_of(const std::string& key, std::size_t bytes) {
  return fmt::format("aerostat binary 1\n{:020}\n{}\n", bytes, key);
}

std::string sum_of(std::string_view bytes) {
  return fmt::format("{:016x}", checksum(bytes));
}

constexpr std::size_t kSumBytes = 16;

}  // namespace

bool keeps_binaries(const std::string& platform) {
  const auto wanted = environment_variable(kVariable);
  if (!wanted) {
    return platform != "Portable Computing Language" && platform != "NVIDIA CUDA" &&
           platform != "rusticl";
  }
  if (*wanted != "on" && *wanted != "off") {
    throw Error(ErrorKind::usage,
                fmt::format("{} is \"{}\"; expected \"on\" or \"off\"", kVariable, *wanted));
  }
  return *wanted == "on";
}

std::string binary_key(const Device& device, std::string_view text, std::string_view options) {
  const auto line = [](std::string_view name, std::string_view value) {
    return fmt::format("{} {}\n", name, value);
  };
  return line("platform", device.platform) + line("version", device.platform_version) +
         line("device", device.name) + line("driver", device.driver) + line("options", options) +
         line("text", fmt::format("{} bytes, {:016x}", text.size(), checksum(text)));
}

BinaryStore::BinaryStore(std::optional<fs::path> folder, std::uint64_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {
  if (folder_ && make_private_folder(*folder_)) folder_ = std::nullopt;
}

BinaryStore BinaryStore::of_user() {
  const auto pocl = preferred_cache_path(CacheEnvironment::of_process());
  return BinaryStore(pocl ? std::optional(pocl->parent_path() / "binaries") : std::nullopt);
}

fs::path BinaryStore::file_of(const std::string& key) const {
  return *folder_ / (sum_of(key) + kExtension);
}

std::optional<std::string> BinaryStore::find(const std::string& key) const {
  if (!folder_) return std::nullopt;
  const fs::path file = file_of(key);
  auto bytes = read_kept_file(file);
  if (bytes && bytes->size() > kSumBytes) {
    const std::string_view body(bytes->data(), bytes->size() - kSumBytes);
    const std::size_t head_bytes = head_of(key, 0).size();
    const std::size_t binary_bytes = body.size() - std::min(body.size(), head_bytes);
    if (body.starts_with(head_of(key, binary_bytes)) &&
        std::string_view(*bytes).substr(body.size()) == sum_of(body)) {
      std::error_code ignored;
      fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
      return bytes->substr(head_bytes, binary_bytes);
    }
  }
  drop(key);
  return std::nullopt;
}

void BinaryStore::keep(const std::string& key, std::string_view binary) const {
  if (!folder_ || binary.empty() || binary.size() > most_bytes_) return;
  std::string bytes = head_of(key, binary.size());
  bytes += binary;
  bytes += sum_of(bytes);
  if (!write_kept_file(file_of(key), bytes)) return;
  remove_oldest();
}

void BinaryStore::drop(const std::string& key) const {
  if (folder_) remove_kept(file_of(key));
}

void BinaryStore::remove_oldest() const {
  struct Kept {
    fs::path path;
    fs::file_time_type used;
    std::uint64_t bytes;
  };
  std::vector<Kept> files;
  std::uint64_t sum = 0;
  std::error_code error;
  for (fs::directory_iterator entries(*folder_, error), end; !error && entries != end;
       entries.increment(error)) {
    if (entries->path().extension() != kExtension) continue;
    std::error_code gone;
    const Kept file{entries->path(), entries->last_write_time(gone), entries->file_size(gone)};
    if (gone) continue;
    files.push_back(file);
    sum += file.bytes;
  }
  std::sort(files.begin(), files.end(),
            [](const Kept& a, const Kept& b) { return a.used < b.used; });
  for (const Kept& file : files) {
    if (sum <= most_bytes_) return;
    remove_kept(file.path);
    sum -= file.bytes;
  }
}

}  // namespace aerostat::opencl

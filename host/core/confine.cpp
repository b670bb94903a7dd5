#include "core/confine.hpp"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/environment.hpp"

namespace aerostat {

std::vector<std::filesystem::path> system_folders() {
  return {"/usr/bin", "/usr/lib", "/usr/lib64", "/usr/share",      "/usr/local",
          "/bin",     "/lib",     "/lib64",     "/etc/ld.so.cache"};
}

std::vector<std::filesystem::path> folders_in_variable(const char* name) {
  std::vector<std::filesystem::path> folders;
  std::istringstream list(environment_variable(name).value_or(""));
  for (std::string each; std::getline(list, each, ':');) {
    if (std::filesystem::path(each).is_absolute()) folders.emplace_back(each);
  }
  return folders;
}

ReachableFiles files_of_program(const std::filesystem::path& program,
                                const std::filesystem::path& folder,
                                std::initializer_list<const char*> variables) {
  ReachableFiles files{system_folders(), {folder, "/dev/null"}};
  const auto prefix = program.parent_path().parent_path();
  for (const auto& path : {program.parent_path(), prefix / "lib", prefix / "share"}) {
    files.readable.push_back(path);
  }
  const auto add = [&](const char* variable) {
    for (auto& path : folders_in_variable(variable)) files.readable.push_back(std::move(path));
  };
  add("LD_LIBRARY_PATH");
  for (const char* variable : variables) add(variable);
  return files;
}

#if defined(SYS_landlock_create_ruleset)

namespace {

// The interface of the kernel, as <linux/landlock.h> has it; older systems lack parts of that
// header.
struct Ruleset {
  std::uint64_t files = 0, net = 0;
};
struct __attribute__((packed)) BeneathRule {
  std::uint64_t allowed = 0;
  std::int32_t parent = -1;
};
constexpr std::uint64_t kExecute = 1, kWriteFile = 2, kReadFile = 4, kReadFolder = 8;
constexpr std::uint64_t kAllOfFiles = (std::uint64_t{1} << 13) - 1;  // of the first version
constexpr std::uint64_t kAllOfTcp = 3;
constexpr unsigned kVersionFlag = 1;
constexpr int kRuleBeneath = 1;
constexpr long kVersionWithTcp = 4;

void allow(int ruleset, const std::filesystem::path& path, std::uint64_t accesses) {
  const int descriptor = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  const bool is_folder = ::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode);
  BeneathRule rule;
  rule.allowed = is_folder ? accesses : accesses & (kExecute | kWriteFile | kReadFile);
  rule.parent = descriptor;
  ::syscall(SYS_landlock_add_rule, ruleset, kRuleBeneath, &rule, 0u);
  ::close(descriptor);
}

}  // namespace

bool confine_this_thread(const ReachableFiles& files) {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0ul, kVersionFlag);
  if (version < 1) return false;
  const Ruleset all{kAllOfFiles, version >= kVersionWithTcp ? kAllOfTcp : 0};
  const std::size_t size = version >= kVersionWithTcp ? sizeof all : sizeof all.files;
  const int ruleset = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, size, 0u));
  if (ruleset < 0) return false;
  for (const auto& path : files.readable) allow(ruleset, path, kExecute | kReadFile | kReadFolder);
  for (const auto& path : files.writable) allow(ruleset, path, kAllOfFiles);
  const bool confined = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                        ::syscall(SYS_landlock_restrict_self, ruleset, 0u) == 0;
  ::close(ruleset);
  return confined;
}

#else

bool confine_this_thread(const ReachableFiles&) {
  return false;
}

#endif

}  // namespace aerostat

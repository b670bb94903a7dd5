#include "core/confine.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
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
  std::uint64_t files = 0, net = 0, scoped = 0;
};
struct __attribute__((packed)) BeneathRule {
  std::uint64_t allowed = 0;
  std::int32_t parent = -1;
};
constexpr std::uint64_t kExecute = 1, kWriteFile = 2, kReadFile = 4, kReadFolder = 8;
constexpr std::uint64_t kAllOfFiles = (std::uint64_t{1} << 13) - 1;  // of the first version
constexpr std::uint64_t kRename = std::uint64_t{1} << 13, kTruncate = std::uint64_t{1} << 14;
constexpr std::uint64_t kAllOfTcp = 3, kAllOutside = 3;
constexpr unsigned kVersionFlag = 1;
constexpr int kRuleBeneath = 1;
constexpr long kVersionWithRename = 2, kVersionWithTruncate = 3, kVersionWithTcp = 4;
constexpr long kVersionWithScopes = 6;

long landlock_version() {
  return ::syscall(SYS_landlock_create_ruleset, nullptr, 0ul, kVersionFlag);
}

/// Returns all that a version can take away.
Ruleset all_of(long version) {
  Ruleset all{kAllOfFiles, 0, 0};
  if (version >= kVersionWithRename) all.files |= kRename;
  if (version >= kVersionWithTruncate) all.files |= kTruncate;
  if (version >= kVersionWithTcp) all.net = kAllOfTcp;
  if (version >= kVersionWithScopes) all.scoped = kAllOutside;
  return all;
}

/// Returns the bytes of a ruleset that a version knows.
std::size_t size_of_ruleset(long version) {
  return (version >= kVersionWithScopes ? 3
          : version >= kVersionWithTcp  ? 2
                                        : 1) *
         sizeof(std::uint64_t);
}

void allow(int ruleset, const std::filesystem::path& path, std::uint64_t accesses) {
  const int descriptor = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  const bool is_folder = ::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode);
  BeneathRule rule;
  constexpr std::uint64_t kOfFiles = kExecute | kWriteFile | kReadFile | kTruncate;
  rule.allowed = is_folder ? accesses : accesses & kOfFiles;
  rule.parent = descriptor;
  ::syscall(SYS_landlock_add_rule, ruleset, kRuleBeneath, &rule, 0u);
  ::close(descriptor);
}

}  // namespace

bool confine_this_thread(const ReachableFiles& files) {
  const long version = landlock_version();
  if (version < 1) return false;
  const Ruleset all = all_of(version);
  const int ruleset =
      static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, size_of_ruleset(version), 0u));
  if (ruleset < 0) return false;
  for (const auto& path : files.readable) allow(ruleset, path, kExecute | kReadFile | kReadFolder);
  for (const auto& path : files.writable) allow(ruleset, path, all.files);
  const bool confined = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                        ::syscall(SYS_landlock_restrict_self, ruleset, 0u) == 0;
  ::close(ruleset);
  return confined;
}

bool can_rename_confined() {
  return landlock_version() >= kVersionWithRename;
}

#else

bool confine_this_thread(const ReachableFiles&) {
  return false;
}

bool can_rename_confined() {
  return false;
}

#endif

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))

bool refuse_connections() {
#if defined(__x86_64__)
  constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#else
  constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#endif
  // Calls of other kinds, those of 32-bit programs, have other numbers.
  constexpr std::uint32_t kOtherCalls = 0x40000000;
  constexpr std::uint32_t kRefuse = SECCOMP_RET_ERRNO | EACCES;
  constexpr std::uint16_t kLoad = BPF_LD | BPF_W | BPF_ABS, kReturn = BPF_RET | BPF_K;
  constexpr std::uint16_t kIfEqual = BPF_JMP | BPF_JEQ | BPF_K,
                          kIfNotLess = BPF_JMP | BPF_JGE | BPF_K;
  // Each instruction has its kind, how many are skipped if it holds and if it does not, and a
  // number. The first argument of socket() is the kind of its addresses.
  std::array<sock_filter, 10> program{{
      {kLoad, 0, 0, offsetof(seccomp_data, arch)},
      {kIfEqual, 0, 7, kMachine},
      {kLoad, 0, 0, offsetof(seccomp_data, nr)},
      {kIfNotLess, 5, 0, kOtherCalls},
      {kIfEqual, 4, 0, SYS_io_uring_setup},
      {kIfEqual, 0, 2, SYS_socket},
      {kLoad, 0, 0, offsetof(seccomp_data, args)},
      {kIfEqual, 0, 1, AF_UNIX},
      {kReturn, 0, 0, SECCOMP_RET_ALLOW},
      {kReturn, 0, 0, kRefuse},
  }};
  const sock_fprog filter{program.size(), program.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

#else

bool refuse_connections() {
  return false;
}

#endif

}  // namespace aerostat

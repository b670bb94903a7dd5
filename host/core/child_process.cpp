#include "core/child_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <future>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/environment.hpp"
#include "core/error.hpp"

namespace aerostat {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kMostOutput = std::size_t{1} << 20;

[[noreturn]] void fail(const std::string& program, int code) {
  throw Error(ErrorKind::io, fmt::format("cannot run {}: {}", program, std::strerror(code)));
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Returns the command of a shell that sets the limits and then becomes the program. A limit that
/// cannot be set is one that is lower already.
std::vector<std::string> with_limits(const std::vector<std::string>& command,
                                     const ChildLimits& limits) {
  // The shell counts memory in KiB and, as POSIX wants it, files in blocks of 512 bytes.
  std::vector<std::string> result{
      "/bin/sh", "-c",
      fmt::format("ulimit -v {} 2>/dev/null; ulimit -t {} 2>/dev/null; ulimit -f {} 2>/dev/null; "
                  "ulimit -c 0 2>/dev/null; exec \"$@\"",
                  limits.memory_bytes / 1024, limits.processor_s, limits.file_bytes / 512),
      "sh"};
  result.insert(result.end(), command.begin(), command.end());
  return result;
}

pid_t start(std::vector<std::string> command, std::vector<std::string> environment, int output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = -1;
  const int code = posix_spawn(&child, command.front().c_str(), &actions, &attributes,
                               pointers_to(command).data(), pointers_to(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (code != 0) fail(command.front(), code);
  return child;
}

/// Starts a program from a new thread. The limits of a thread hold until it ends, and the calling
/// thread must not keep them.
pid_t start_confined(const std::vector<std::string>& command,
                     const std::vector<std::string>& environment, const ChildLimits& limits,
                     int output) {
  return std::async(std::launch::async,
                    [&] {
                      if (limits.files) confine_this_thread(*limits.files);
                      return start(with_limits(command, limits), environment, output);
                    })
      .get();
}

/// Reads what a program writes, until it ends or the time is up. Returns whether it ended.
bool read_output(int input, Clock::time_point deadline, std::string& output) {
  std::array<char, 4096> buffer{};
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return false;
    pollfd wait{input, POLLIN, 0};
    const int ready = ::poll(&wait, 1, static_cast<int>(left.count()));
    if (ready < 0 && errno != EINTR) return false;
    if (ready <= 0) continue;
    const ssize_t got = ::read(input, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    const std::size_t room = kMostOutput - output.size();
    output.append(buffer.data(), std::min(room, static_cast<std::size_t>(got)));
  }
}

/// Waits for the end of a program. When the time is up, it is killed.
ChildResult wait_for(pid_t child, Clock::time_point deadline, std::string output) {
  ChildResult result;
  result.output = std::move(output);
  int status = 0;
  while (true) {
    const pid_t ended = ::waitpid(child, &status, result.took_too_long ? 0 : WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) break;
    if (Clock::now() >= deadline) {
      ::kill(child, SIGKILL);
      result.took_too_long = true;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace

ChildResult run_limited(const std::vector<std::string>& command,
                        const std::vector<std::string>& environment, const ChildLimits& limits) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail(command.front(), errno);
  const auto deadline = Clock::now() + std::chrono::seconds(limits.waiting_s);
  pid_t child = -1;
  try {
    child = start_confined(command, environment, limits, pipe[1]);
  } catch (...) {
    ::close(pipe[0]);
    ::close(pipe[1]);
    throw;
  }
  ::close(pipe[1]);
  std::string output;
  const bool ended = read_output(pipe[0], deadline, output);
  ::close(pipe[0]);
  return wait_for(child, ended ? deadline : Clock::now(), std::move(output));
}

bool is_program(const std::filesystem::path& file) {
  std::error_code code;
  return std::filesystem::is_regular_file(file, code) && ::access(file.c_str(), X_OK) == 0;
}

std::filesystem::path find_program(const char* name, const char* variable) {
  if (const auto chosen = environment_variable(variable)) {
    std::error_code code;
    const std::filesystem::path program = std::filesystem::absolute(*chosen, code);
    return is_program(program) ? program : std::filesystem::path();
  }
  std::istringstream folders(environment_variable("PATH").value_or("/usr/local/bin:/usr/bin:/bin"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder) / name;
    if (program.is_absolute() && is_program(program)) return program;
  }
  return {};
}

std::string complaint_of(const ChildResult& result) {
  std::string complaint = result.output.substr(0, result.output.find('\n')).substr(0, 300);
  std::replace_if(
      complaint.begin(), complaint.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return complaint.empty() ? fmt::format("it ended with {}", result.status) : complaint;
}

PrivateFolder::PrivateFolder() {
  std::error_code code;
  path_ = std::filesystem::temp_directory_path(code);
  std::string name = ((code ? std::filesystem::path("/tmp") : path_) / "aerostat-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw Error(ErrorKind::io,
                fmt::format("cannot make a temporary folder {}: {}", name, std::strerror(errno)));
  }
  path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace aerostat

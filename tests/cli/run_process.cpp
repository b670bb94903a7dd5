#include "run_process.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace aerostat::test {

namespace fs = std::filesystem;

namespace {

// Turns the child process into the program. It must be called only in the child, and it ends the
// process on failure.
[[noreturn]] void become(const std::vector<std::string>& arguments, const fs::path& folder,
                         const Environment& environment, const std::vector<Limit>& limits,
                         const fs::path& out, const fs::path& err) {
  for (const std::string& entry : environment) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos) {
      ::unsetenv(entry.c_str());
    } else {
      ::setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
    }
  }
  for (const Limit& limit : limits) {
    const rlimit value{limit.most, limit.most};
    if (::setrlimit(static_cast<__rlimit_resource>(limit.resource), &value) != 0) ::_exit(126);
  }
  const int out_fd = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_fd = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int in_fd = ::open("/dev/null", O_RDONLY);
  ::dup2(in_fd, STDIN_FILENO);
  ::dup2(out_fd, STDOUT_FILENO);
  ::dup2(err_fd, STDERR_FILENO);
  std::vector<char*> argv{const_cast<char*>("aerostat")};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  if (::chdir(folder.c_str()) == 0) ::execv(AEROSTAT_BINARY, argv.data());
  ::_exit(127);
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const fs::path& folder,
                 const Environment& environment, const std::vector<Limit>& limits)
    : out_(folder.string() + ".out"), err_(folder.string() + ".err") {
  pid_ = ::fork();
  if (pid_ == 0) become(arguments, folder, environment, limits, out_, err_);
}

void Process::send(int signal) const {
  ::kill(pid_, signal);
}

Outcome Process::wait() {
  int status = 0;
  rusage usage{};
  ::wait4(pid_, &status, 0, &usage);
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                  read_bytes(out_), read_bytes(err_),
                  static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u};
  fs::remove(out_);
  fs::remove(err_);
  return outcome;
}

Outcome CliTest::run(const std::vector<std::string>& arguments, const Environment& environment,
                     const std::vector<Limit>& limits) const {
  return Process(arguments, folder_, environment, limits).wait();
}

std::string CliTest::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return name;
}

std::vector<std::string> CliTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string scene_path(const std::string& name) {
  return std::string(AEROSTAT_SOURCE_DIR) + "/scenes/" + name + ".json";
}

std::vector<std::string> small_render(const std::string& scene,
                                      const std::vector<std::string>& more) {
  std::vector<std::string> arguments{
      "render", scene_path(scene), "--set", "/terrain/cells=64", "--width", "32", "--height", "18"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::pair<unsigned, unsigned> png_size(const std::string& png) {
  if (png.size() < 24 || png.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) return {0, 0};
  const auto number = [&png](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value << 8 | static_cast<unsigned char>(png[i]);
    return value;
  };
  return {number(16), number(20)};
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no \"" << part << "\" in:\n" << text;
}

}  // namespace aerostat::test

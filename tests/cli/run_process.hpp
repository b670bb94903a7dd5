#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

/// Running the program as a user does.
namespace aerostat::test {

struct Outcome {
  int code = -1;  // exit code; 128 + signal if one ended it
  std::string out;
  std::string err;
  std::uint64_t peak_bytes = 0;  // of memory that was resident
};

/// What of the environment differs from this process: "NAME=VALUE", or "NAME" to take it away.
using Environment = std::vector<std::string>;

/// A limit that the program runs under, as the shell's `ulimit` sets it: RLIMIT_STACK and bytes.
struct Limit {
  int resource = 0;
  rlim_t most = RLIM_INFINITY;
};

/// A program that was started and not yet waited for. Its stdout and stderr go to files.
class Process {
 public:
  Process(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
          const Environment& environment, const std::vector<Limit>& limits = {});

  void send(int signal) const;
  Outcome wait();

 private:
  std::filesystem::path out_, err_;
  int pid_ = -1;
};

/// A test with an empty folder of its own, which is also the program's current folder.
class CliTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Runs `aerostat` with these arguments to its end.
  Outcome run(const std::vector<std::string>& arguments, const Environment& environment = {},
              const std::vector<Limit>& limits = {}) const;

  /// Writes a file into the folder and returns its name.
  std::string write(const std::string& name, const std::string& text) const;

  /// The names in the folder.
  std::vector<std::string> files() const;

  std::filesystem::path folder_;
};

/// A scene of the repository, such as "snow".
std::string scene_path(const std::string& name);

/// Arguments that make a render of `scene` small enough for a test, 32 x 18 pixels by default.
std::vector<std::string> small_render(const std::string& scene,
                                      const std::vector<std::string>& more = {});

std::string read_bytes(const std::filesystem::path& path);

/// Width and height in a PNG's header; zeros if it is none.
std::pair<unsigned, unsigned> png_size(const std::string& png);

/// Whether `text` has `part`, and what it has if not.
testing::AssertionResult contains(const std::string& text, const std::string& part);

}  // namespace aerostat::test

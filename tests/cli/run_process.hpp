#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "support/temporary_folder.hpp"

/// Runs the program as a user does.
namespace aerostat::test {

struct Outcome {
  /// The exit code, or 128 + signal if a signal ended the process.
  int code = -1;
  std::string out;
  std::string err;
  /// The largest amount of resident memory in bytes.
  std::uint64_t peak_bytes = 0;
};

/// The differences from the environment of this process: "NAME=VALUE" sets a variable, and "NAME"
/// removes it.
using Environment = std::vector<std::string>;

/// A limit for the program, as the shell's `ulimit` sets it. `resource` is a constant such as
/// RLIMIT_STACK, and `most` is in its unit, such as bytes.
struct Limit {
  int resource = 0;
  rlim_t most = RLIM_INFINITY;
};

/// A program that was started and that nobody has waited for yet. Its stdout and stderr go to
/// files.
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

/// A test with an empty folder of its own, which is also the current folder of the program.
class CliTest : public testing::Test {
 protected:
  /// Runs `aerostat` with these arguments to its end.
  Outcome run(const std::vector<std::string>& arguments, const Environment& environment = {},
              const std::vector<Limit>& limits = {}) const;

  /// Writes a file into the folder and returns its name.
  std::string write(const std::string& name, const std::string& text) const;

  /// Returns the names in the folder.
  std::vector<std::string> files() const;

  const TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
};

/// Returns the path of a scene of the repository, such as "snow".
std::string scene_path(const std::string& name);

/// Returns arguments that make a render of `scene` small enough for a test. It has 32 x 18 pixels
/// by default.
std::vector<std::string> small_render(const std::string& scene,
                                      const std::vector<std::string>& more = {});

std::string read_bytes(const std::filesystem::path& path);

/// Returns the width and height in a PNG's header, or zeros if the text is not a PNG.
std::pair<unsigned, unsigned> png_size(const std::string& png);

/// Returns whether `text` contains `part`. If it does not, the message shows the text.
testing::AssertionResult contains(const std::string& text, const std::string& part);

}  // namespace aerostat::test

// Tests "-" for scenes from standard input and files to standard output.
#include <cstdlib>
#include <string>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

class Pipe : public CliTest {
 protected:
  /// Runs a line of the shell in the test's folder. $A is the program and $S the folder of the
  /// scenes.
  Outcome shell(const std::string& line) const {
    const std::string set_up = "cd '" + folder_.string() +
                               "' && A='" AEROSTAT_BINARY "' S='" AEROSTAT_SOURCE_DIR
                               "/scenes' && ";
    const std::string all = set_up + "{ " + line + "\n} >out 2>err </dev/null";
    const int status = std::system(all.c_str());
    return {WEXITSTATUS(status), read_bytes(folder_ / "out"), read_bytes(folder_ / "err")};
  }
};

const std::string kSmall = " --set /terrain/cells=64 --width 32 --height 18 --spp 1 --quiet";

TEST_F(Pipe, ASceneComesFromStandardInput) {
  const Outcome checked = shell("\"$A\" check - <$S/snow.json");
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_EQ(checked.err, "standard input: ok\n");
  const Outcome dumped = shell("\"$A\" dump - --set /terrain/seed=9 <$S/snow.json");
  EXPECT_EQ(dumped.out, shell("\"$A\" dump $S/snow.json --set /terrain/seed=9").out);
  const Outcome wrong = shell("printf '{\"version\": 1,\\n \"a\": 1}' | \"$A\" dump -");
  EXPECT_EQ(wrong.code, 65);
  EXPECT_EQ(wrong.err.rfind("aerostat: standard input:2:2: /a: found an unknown key", 0), 0u)
      << wrong.err;
  EXPECT_EQ(shell("\"$A\" check - <&-").code, 74);
}

TEST_F(Pipe, EveryCommandNamesStandardInputWhereASceneCannotStand) {
  // Counted from the ground, the balloon would be more than 1000 km up.
  const std::string far =
      " --set /balloon/height_above=ground --set '/balloon/position=[0,1000000,0]'"
      " --set /terrain/cells=64 <$S/snow.json";
  for (const char* command : {"check -", "render - -o x.png", "contact-sheet - -o x.png"}) {
    const Outcome outcome = shell(std::string("\"$A\" ") + command + far);
    EXPECT_EQ(outcome.code, 65) << command << ": " << outcome.err;
    EXPECT_NE(outcome.err.find("aerostat: standard input: /balloon/position/1: found "),
              std::string::npos)
        << command << ": " << outcome.err;
  }
}

TEST_F(Pipe, APictureGoesToStandardOutput) {
  const Outcome piped = shell("\"$A\" render - -o -" + kSmall + " <$S/snow.json");
  ASSERT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(png_size(piped.out), (std::pair{32u, 18u}));
  ASSERT_EQ(shell("\"$A\" render $S/snow.json -o file.png" + kSmall).code, 0);
  EXPECT_TRUE(piped.out == read_bytes(folder_ / "file.png"));
  const Outcome layers = shell("\"$A\" render $S/snow.json -o - --format exr" + kSmall);
  EXPECT_EQ(layers.out.rfind("\x76\x2f\x31\x01", 0), 0u) << "no EXR";
  const Outcome named = shell("\"$A\" render $S/snow.json -o picture --format png" + kSmall);
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_TRUE(read_bytes(folder_ / "picture") == piped.out) << "the format wins over the name";
}

TEST_F(Pipe, SheetsAndMeshesGoToStandardOutput) {
  const Outcome sheet = shell(
      "\"$A\" contact-sheet - -o - --seeds 1 --tile-width 32 --quality draft --quiet "
      "--set /terrain/cells=64 <$S/snow.json");
  EXPECT_EQ(sheet.out.substr(1, 3), "PNG") << sheet.err;
  const std::string flat = " --set /terrain/cells=4";
  EXPECT_EQ(shell("\"$A\" export - -o -" + flat + " <$S/snow.json").out.rfind("ply\n", 0), 0u);
  const Outcome mesh = shell("\"$A\" export $S/snow.json -o - --format obj" + flat);
  EXPECT_EQ(mesh.code, 0) << mesh.err;
  EXPECT_TRUE(contains(mesh.out, "\nv "));
}

TEST_F(Pipe, WhatHasNoNameIsAskedForOne) {
  for (const char* command : {"render", "contact-sheet"}) {
    const Outcome outcome = shell(std::string("\"$A\" ") + command + " - <$S/snow.json");
    EXPECT_EQ(outcome.code, 64);
    EXPECT_TRUE(contains(outcome.err, "standard input gives the picture no name"));
  }
}

/// Returns the exit code of a command whose standard output is a terminal.
int code_in_terminal(const std::string& command) {
  int master = -1;
  const pid_t child = ::forkpty(&master, nullptr, nullptr, nullptr);
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  char chunk[4096];
  while (::read(master, chunk, sizeof chunk) > 0) {
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(master);
  return WEXITSTATUS(status);
}

TEST_F(Pipe, NothingBinaryGoesToATerminal) {
  const std::string program = "'" AEROSTAT_BINARY "' ",
                    scene = std::string("'").append(scene_path("snow")).append("'");
  for (const std::string name : {"-", "/dev/stdout --format png"}) {
    EXPECT_EQ(code_in_terminal(program + "render " + scene + " -o " + name + kSmall), 64) << name;
  }
  EXPECT_EQ(code_in_terminal(program + "contact-sheet " + scene + " -o -"), 64);
  EXPECT_EQ(code_in_terminal(program + "export " + scene + " -o -"), 64);
  EXPECT_EQ(
      code_in_terminal(program + "export " + scene + " -o - --format obj --set /terrain/cells=4"),
      0)
      << "text may be shown";
}

}  // namespace
}  // namespace aerostat::test

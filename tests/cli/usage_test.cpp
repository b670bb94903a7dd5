// Tests help, versions, devices, and wrong command lines.

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using Usage = CliTest;

TEST_F(Usage, EveryCommandHelpsWithExamples) {
  for (const std::string command : {"", "render", "contact-sheet", "film", "scenes", "devices",
                                    "check", "dump", "export", "artwork"}) {
    std::vector<std::string> arguments;
    if (!command.empty()) arguments.push_back(command);
    arguments.push_back("--help");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_EQ(outcome.err, "") << command;
    EXPECT_TRUE(contains(outcome.out, "Examples:\n  aerostat " + command)) << command;
  }
}

TEST_F(Usage, HelpNamesEveryOptionOfRender) {
  const Outcome outcome = run({"render", "--help"});
  for (const char* option :
       {"SCENE", "--output", "--width", "--height", "--spp", "--quality", "--seed", "--device",
        "--lanes", "--set", "--crop", "--memory-limit", "--quiet", "--stats"}) {
    EXPECT_TRUE(contains(outcome.out, option));
  }
}

/// Returns the words of a text without the backslashes of examples that continue on the next line.
std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  words.erase(std::remove(words.begin(), words.end(), "\\"), words.end());
  return words;
}

TEST_F(Usage, HelpFitsTheTerminal) {
  for (const std::string command : {"", "render", "contact-sheet", "film", "scenes", "devices",
                                    "check", "dump", "export", "artwork"}) {
    std::vector<std::string> arguments;
    if (!command.empty()) arguments.push_back(command);
    arguments.push_back("--help");
    const auto words = words_of(run(arguments, {"COLUMNS=100"}).out);
    for (const std::string columns : {"", "40", "60", "80", "100", "200", "none"}) {
      const std::string help = run(arguments, {"COLUMNS=" + columns}).out;
      EXPECT_EQ(words_of(help), words) << command << " at " << columns;
      const bool is_usual = columns.empty() || columns == "none";
      const std::size_t most = is_usual ? 80 : std::min(std::stoi(columns), 100);
      std::istringstream lines(help);
      for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), most) << command << " at " << columns << ": " << line;
      }
    }
  }
}

TEST_F(Usage, TellsItsVersion) {
  const Outcome outcome = run({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.rfind("aerostat ", 0), 0u) << outcome.out;
  EXPECT_EQ(outcome.out.back(), '\n');
}

struct Mistake {
  std::vector<std::string> arguments;
  /// A part of the message.
  std::string part;
};

TEST_F(Usage, MistakesAreOneClearLineAndCode64) {
  const std::string scene = scene_path("snow");
  const Mistake mistakes[] = {
      {{}, "no command"},
      {{"frob"}, "'frob'"},
      {{"render"}, "SCENE is required"},
      {{"render", scene, "--frob"}, "--frob"},
      {{"render", scene, "--width", "0"}, "--width: Value 0 not in range 1 to 32768"},
      {{"render", scene, "--width", "-5"}, "--width: Value -5 not in range 1 to 32768"},
      {{"render", scene, "--height", "32769"}, "--height: Value 32769"},
      {{"render", scene, "--width", "12.5"}, "--width: Value 12.5 not in range 1 to 32768"},
      {{"render", scene, "--width", "0x10"}, "--width: Value 0x10 not in range 1 to 32768"},
      {{"render", scene, "--width", "99999999999999999999"}, "not in range 1 to 32768"},
      {{"render", scene, "--spp", "none"}, "--spp: Value none not in range 1 to 65536"},
      {{"render", scene, "--quality", "best"}, "--quality: best not in {draft,standard,final}"},
      {{"render", scene, "--seed", "-1"}, "--seed: Value -1 not in range 0 to 4294967295"},
      {{"render", scene, "--lanes", "3"}, "--lanes: 3 not in {1,4,8,16}"},
      {{"render", scene, "--crop", "1,2,3"}, "--crop: '1,2,3'"},
      {{"render", scene, "--crop", "5,5,5,9"}, "is empty"},
      {{"render", scene, "--crop", "0,0,99999,9"}, "reaches beyond the image"},
      {{"render", scene, "--memory-limit", "much"}, "--memory-limit: 'much'"},
      {{"render", scene, "--memory-limit", "1.5"}, "such as 1.5G"},
      {{"render", scene, "-o", "x.jpg"}, ".png"},
      {{"render", scene, "-o", "x.jpg"}, ".exr"},
      {{"render", scene, "-o", "picture"}, "'picture'"},
      {{"render", scene, "--set", "nothing"}, "nothing"},
      {{"render", scene, "--width", "32768", "--height", "32768"}, "too many for a PNG"},
      {{"export", scene}, "--output is required"},
      {{"export", scene, "-o", "x.stl"}, ".ply"},
      {{"export", scene, "-o", "-", "--format", "gltf"}, "expected glb"},
      {{"artwork", "-o", "x.svg"}, "--template is required"},
      {{"artwork", "--template", "-o", "x.png"}, ".svg"},
      {{"artwork", scene, "--template", "--balloon", "1", "-o", "x.svg"}, "at most 0"},
      {{"devices", "--json", "more"}, "more"},
      {{"render", scene, "--device", "cpu,cpu"}, "same compute units"},
      {{"render", scene, "--device", "cpu,"}, "before or after a comma"},
      {{"render", scene, "--device", "cpu/2.2"}, "from 0 to N - 1"},
  };
  for (const Mistake& mistake : mistakes) {
    const Outcome outcome = run(mistake.arguments);
    EXPECT_EQ(outcome.code, 64) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("aerostat: ", 0), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, mistake.part));
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(Usage, DevicesAreListed) {
  const Outcome text = run({"devices"}, {"AEROSTAT_DEVICE"});
  EXPECT_EQ(text.code, 0);
  EXPECT_TRUE(contains(text.out, "* "));
  const Outcome outcome = run({"devices", "--json"}, {"AEROSTAT_DEVICE"});
  EXPECT_EQ(outcome.code, 0);
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_FALSE(json.at("devices").empty());
  int chosen = 0;
  for (const auto& device : json.at("devices")) {
    EXPECT_TRUE(contains(text.out, device.at("selector")));
    EXPECT_TRUE(contains(text.out, device.at("name")));
    EXPECT_GT(device.at("memory_bytes").get<std::uint64_t>(), 0u);
    EXPECT_GE(device.at("compute_units").get<int>(), 1);
    EXPECT_GE(device.at("lanes").get<int>(), 1);
    chosen += device.at("chosen").get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(chosen, 1);
  EXPECT_TRUE(json.at("problems").is_array());
}

TEST_F(Usage, DevicesTellWhatCanBeCut) {
  const Environment two_units{"POCL_MAX_PTHREAD_COUNT=2", "AEROSTAT_DEVICE=portable/2"};
  const Outcome text = run({"devices"}, two_units);
  EXPECT_TRUE(contains(text.out, "up to 2 parts"));
  EXPECT_TRUE(contains(text.out, "/2.0,"));
  const auto json = nlohmann::json::parse(run({"devices", "--json"}, two_units).out);
  int chosen = 0;
  for (const auto& device : json.at("devices")) {
    if (!device.at("chosen").get<bool>()) continue;
    ++chosen;
    EXPECT_EQ(device.at("most_parts"), 2);
  }
  EXPECT_EQ(chosen, 1) << "the device whose parts they are";
  const Outcome many = run(small_render("snow", {"--device", "portable/3"}), two_units);
  EXPECT_EQ(many.code, 69);
  EXPECT_TRUE(contains(many.err, "cannot be cut into 3 parts: at most 2 are possible"));
}

TEST_F(Usage, WithoutPlatformsThereIsNoDevice) {
  const Environment no_platforms{"OCL_ICD_VENDORS=" + folder_.string() + "/none"};
  const Outcome outcome = run(small_render("snow"), no_platforms);
  EXPECT_EQ(outcome.code, 69) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "pocl-opencl-icd"));
  EXPECT_EQ(run({"devices"}, no_platforms).code, 69);
  EXPECT_TRUE(files().empty());
}

TEST_F(Usage, ADriverThatCannotBeLoadedIsNamed) {
  const std::string icd = (folder_ / "gone.icd").string();
  std::ofstream(icd) << "libgone.so\n";
  const Environment gone{"OCL_ICD_VENDORS=" + icd};
  const Outcome outcome = run(small_render("snow"), gone);
  EXPECT_EQ(outcome.code, 69);
  EXPECT_TRUE(contains(outcome.err, "the driver libgone.so, which " + icd + " registers"));
  EXPECT_TRUE(contains(outcome.err, "repair the driver that is registered"));
  const Outcome devices = run({"devices"}, gone);
  EXPECT_EQ(devices.code, 69);
  EXPECT_TRUE(contains(devices.out, "! the driver libgone.so, which " + icd + " registers"));
}

TEST_F(Usage, TooLittleMemoryIsToldAsSuch) {
  // Processes that this one starts inherit its limits. 400000 KiB are too little for a driver.
  rlimit former = {};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &former), 0);
  const rlimit little{400000u * 1024u, former.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_AS, &little), 0);
  const Outcome outcome = run(small_render("snow"));
  const Outcome devices = run({"devices"});
  ASSERT_EQ(setrlimit(RLIMIT_AS, &former), 0);
  EXPECT_EQ(outcome.code, 75) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "limited to 390 MiB (ulimit -v)")) << outcome.err;
  EXPECT_FALSE(contains(outcome.err, "install")) << outcome.err;
  EXPECT_EQ(devices.code, 75);
  EXPECT_TRUE(contains(devices.out, "limited to 390 MiB (ulimit -v)")) << devices.out;
}

TEST_F(Usage, AnUnknownDeviceListsWhatThereIs) {
  const auto json = nlohmann::json::parse(run({"devices", "--json"}).out);
  const std::string name = json.at("devices").at(0).at("name");
  const Outcome by_option = run(small_render("snow", {"--device", "no such device"}));
  const Outcome by_environment = run(small_render("snow"), {"AEROSTAT_DEVICE=9:9"});
  EXPECT_TRUE(contains(by_option.err, "no such device"));
  EXPECT_TRUE(contains(by_environment.err, "9:9"));
  for (const Outcome& outcome : {by_option, by_environment}) {
    EXPECT_EQ(outcome.code, 69);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(contains(outcome.err, name));
  }
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace aerostat::test

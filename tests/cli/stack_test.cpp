// Tests the commands with small stacks of threads. glibc gives threads the system's limit of the
// stack, and 2 MiB if that is "unlimited".

#include "run_process.hpp"

namespace aerostat::test {
namespace {

const std::vector<Limit> kOneMebibyte{{RLIMIT_STACK, rlim_t{1} << 20}};
const std::vector<Limit> kUnlimited{{RLIMIT_STACK, RLIM_INFINITY}};

class SmallStacks : public CliTest {
 protected:
  void expect_done(const std::vector<std::string>& arguments, const std::vector<Limit>& limits) {
    const Environment scenes{"AEROSTAT_SCENE_DIR=" AEROSTAT_SOURCE_DIR "/scenes"};
    const Outcome outcome = run(arguments, scenes, limits);
    EXPECT_EQ(outcome.code, 0) << testing::PrintToString(arguments) << ": " << outcome.err;
  }
};

TEST_F(SmallStacks, RenderInEveryQuality) {
  for (const char* quality : {"draft", "standard", "final"}) {
    expect_done(small_render("snow", {"--quality", quality, "-o", "x.exr"}), kOneMebibyte);
  }
}

TEST_F(SmallStacks, RenderEveryBiomeWithAllThereIs) {
  for (const char* scene : {"snow", "tropical-basket", "sand"}) {
    for (const auto& limits : {kOneMebibyte, kUnlimited}) {
      expect_done(small_render(scene, {"--spp", "1", "--set", "/fog/enabled=true", "--set",
                                       "/sky/cumulus/cover=0.3"}),
                  limits);
    }
  }
}

TEST_F(SmallStacks, EveryOtherCommand) {
  const std::string scene = scene_path("tropical");
  expect_done({"contact-sheet", scene, "--set", "/terrain/cells=64", "--set", "/image/spp=1",
               "--tile-width", "32", "--seeds", "1-3"},
              kOneMebibyte);
  for (const char* name : {"world.ply", "world.obj"}) {
    expect_done({"export", scene, "--set", "/terrain/cells=64", "-o", name}, kOneMebibyte);
  }
  for (const char* command : {"check", "dump"}) expect_done({command, scene}, kOneMebibyte);
  for (const char* command : {"devices", "scenes", "--help", "--version"}) {
    expect_done({command}, kOneMebibyte);
  }
}

/// Tests files that are as deep as they may be. Recursive functions must end before the stack does.
TEST_F(SmallStacks, DeepFiles) {
  const std::string deep = std::string(100000, '[');
  EXPECT_EQ(run({"check", write("deep.json", deep)}, {}, kOneMebibyte).code, 65);
  const std::string allowed = std::string(62, '[') + std::string(62, ']');
  const std::string scene = R"({"version":1,"biome":"snow","balloons":)" + allowed + "}";
  EXPECT_EQ(run({"check", write("allowed.json", scene)}, {}, kOneMebibyte).code, 65);
}

}  // namespace
}  // namespace aerostat::test

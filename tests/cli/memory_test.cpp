// Tests that memory is summed before it is allocated, and that a lack of it is said.

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using Memory = CliTest;

TEST_F(Memory, CheckPrintsTheSumAndWhatTheDeviceHas) {
  const Outcome small = run({"check", scene_path("snow"), "--device", "cpu", "--set",
                             "/terrain/cells=64", "--set", "/vegetation/enabled=false"});
  EXPECT_EQ(small.code, 0) << small.err;
  EXPECT_TRUE(contains(small.out, "memory    "));
  EXPECT_TRUE(contains(small.out, "MiB on each device\n"));
  EXPECT_TRUE(contains(small.out, "film"));
  EXPECT_TRUE(contains(small.out, "less with a smaller /terrain/cells"));
  EXPECT_TRUE(contains(small.out, "device    0:0 "));
  const Outcome huge = run({"check", scene_path("snow"), "--device", "cpu", "--set",
                            "/terrain/cells=64", "--set", "/vegetation/enabled=false", "--set",
                            "/image/width=32768", "--set", "/image/height=32768"});
  EXPECT_EQ(huge.code, 75) << huge.err;
  EXPECT_TRUE(contains(huge.err, "the render needs 40.0 GiB"));
  EXPECT_TRUE(contains(huge.err, "film 40.0 GiB (less with a smaller picture, or a --crop)"));
  EXPECT_EQ(run({"check", scene_path("snow"), "--device", "no such"}).code, 69);
}

TEST_F(Memory, ALimitNamesTheLargestItemsAndWhatMakesThemSmaller) {
  const Outcome outcome = run(small_render(
      "snow", {"--width", "640", "--height", "480", "--memory-limit", "10M", "-o", "x.png"}));
  EXPECT_EQ(outcome.code, 75) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "10.0 MiB are allowed (--memory-limit changes that): "));
  EXPECT_TRUE(contains(outcome.err, "film 11.7 MiB (less with a smaller picture, or a --crop)"));
  EXPECT_TRUE(files().empty());
}

TEST_F(Memory, ADriverThatRefusesBuffersOfLaunchesGetsSmallerOnes) {
  const auto with = [this](const std::string& faults, const std::string& name) {
    return run(small_render("snow", {"--width", "320", "--height", "180", "--spp", "16",
                                     "--skip-self-test", "-o", name}),
               {"OCL_ICD_VENDORS=" AEROSTAT_FAKE_OPENCL_DIR, "FAKE_CL_FAULTS=" + faults});
  };
  const Outcome whole = with("", "a.png");
  ASSERT_EQ(whole.code, 0) << whole.err;
  // The tables, the geometry and the film come first, and then the buffers of launches.
  int halved = 0;
  for (int call = 14; call < 22; ++call) {
    const Outcome outcome = with("clCreateBuffer:" + std::to_string(call) + ":-4", "b.png");
    if (outcome.code != 0) continue;
    EXPECT_TRUE(read_bytes(folder_ / "a.png") == read_bytes(folder_ / "b.png"));
    ++halved;
  }
  EXPECT_GT(halved, 0);
}

}  // namespace
}  // namespace aerostat::test

// Tests that a device that computes wrong results is refused by name, with the driver of
// tests/fake_opencl.

#include <cstdlib>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

class SelfTest : public CliTest {
 protected:
  /// Runs a small render with the fake driver and an empty memory of devices that passed. Compiled
  /// kernels are those of other runs.
  Outcome render(const std::string& faults, const std::vector<std::string>& more = {},
                 const char* pocl_devices = "pthread", const Environment& surroundings = {}) const {
    Environment all{"OCL_ICD_VENDORS=" AEROSTAT_FAKE_OPENCL_DIR, "FAKE_CL_FAULTS=" + faults,
                    "XDG_CACHE_HOME=" + cache_.path().string(),
                    "POCL_CACHE_DIR=" + compiled_kernels(),
                    std::string("POCL_DEVICES=") + pocl_devices};
    all.insert(all.end(), surroundings.begin(), surroundings.end());
    return run(small_render("sand-empty", more), all);
  }

  static std::string compiled_kernels() {
    const auto value = [](const char* name) {
      const char* const text = std::getenv(name);
      return fs::path(text == nullptr ? "" : text);
    };
    if (!value("POCL_CACHE_DIR").empty()) return value("POCL_CACHE_DIR").string();
    const fs::path cache =
        value("XDG_CACHE_HOME").empty() ? value("HOME") / ".cache" : value("XDG_CACHE_HOME");
    return (cache / "aerostat/pocl").string();
  }

  const TemporaryFolder cache_;
};

TEST_F(SelfTest, IsMadeOnceForADevice) {
  const std::string fault = "clEnqueueNDRangeKernel@trace_shadow_rays:1+:skip";
  const Outcome first = render("");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_FALSE(fs::is_empty(cache_.path() / "aerostat/binaries"));
  const Outcome second = render(fault, {"--device", "0:0"});
  EXPECT_EQ(second.code, 0) << "a device that passed is not tested again\n" << second.err;
  fs::remove_all(cache_.path() / "aerostat/binaries");
  EXPECT_EQ(render(fault, {"--device", "0:0"}).code, 69);
}

TEST_F(SelfTest, ADeviceThatComputesWronglyIsRefusedByName) {
  for (const char* kernel :
       {"trace_camera_rays", "trace_shadow_rays", "shade_hits", "clear_film"}) {
    const std::string fault = std::string("clEnqueueNDRangeKernel@") + kernel + ":1+:skip";
    for (const char* selector : {"0:0", "auto"}) {
      const Outcome outcome = render(fault, {"--device", selector});
      EXPECT_EQ(outcome.code, 69) << kernel << "\n" << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "the device 0:0 "));
      EXPECT_TRUE(contains(outcome.err, " computes wrong results: of "));
      EXPECT_TRUE(contains(outcome.err, "--skip-self-test"));
      EXPECT_TRUE(files().empty());
    }
  }
  EXPECT_EQ(render("clEnqueueNDRangeKernel@trace_shadow_rays:1+:skip", {"--skip-self-test"}).code,
            0);
  EXPECT_EQ(files(), std::vector<std::string>{"sand-empty.png"});
}

TEST_F(SelfTest, KernelsOfAFolderAreNamed) {
  const std::string folder = AEROSTAT_SOURCE_DIR "/kernels";
  for (const char* selector : {"0:0", "auto"}) {
    const Outcome outcome =
        render("clEnqueueNDRangeKernel@shade_hits:1+:skip", {"--device", selector},
               "pthread pthread", {"AEROSTAT_KERNEL_DIR=" + folder});
    EXPECT_EQ(outcome.code, 65) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "the kernels in " + folder + " (AEROSTAT_KERNEL_DIR)"));
    EXPECT_EQ(outcome.err.find("the next device is taken"), std::string::npos) << outcome.err;
    EXPECT_TRUE(files().empty());
  }
}

TEST_F(SelfTest, AutoTakesTheNextDevice) {
  const Outcome outcome = render("clEnqueueNDRangeKernel@device0:1+:skip", {}, "pthread pthread");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "the device 0:0 "));
  EXPECT_TRUE(contains(outcome.err, "the next device is taken"));
  EXPECT_EQ(files(), std::vector<std::string>{"sand-empty.png"});
  fs::remove_all(cache_.path());
  const Outcome broken =
      render("clEnqueueNDRangeKernel@device0:1+:-5", {"-o", "y.png"}, "pthread pthread");
  EXPECT_EQ(broken.code, 0) << broken.err;
  fs::remove_all(cache_.path());
  const Outcome all = render("clEnqueueNDRangeKernel:1+:skip", {"-o", "z.png"}, "pthread pthread");
  EXPECT_EQ(all.code, 69) << all.err;
  EXPECT_TRUE(contains(all.err, "the device 0:0 "));
  EXPECT_FALSE(fs::exists(folder_ / "z.png"));
}

}  // namespace
}  // namespace aerostat::test

// Tests that a driver that fails at any of its calls ends in a message and the right exit code, and
// leaves no part of an output. The driver is tests/fake_opencl.

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <thread>

#include "fake_opencl/functions.hpp"
#include "run_process.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;

using Counts = std::map<std::string, std::uint64_t>;

class DriverFaults : public CliTest {
 protected:
  /// Runs a small render with the fake driver.
  Outcome render(const std::string& faults, const std::vector<std::string>& more = {}) const {
    return run(arguments(more), environment(faults));
  }

  static std::vector<std::string> arguments(const std::vector<std::string>& more) {
    // 20 samples take several passes. The ambient occlusion and the lamp are there for their
    // kernels. A small world is built in a moment, and calls all functions as well.
    std::vector<std::string> all{"--spp", "20", "-o", "x.png", "--skip-self-test"};
    for (const char* change :
         {"/sky/ambient_occlusion=true", "/terrain/cells=16", "/vegetation/enabled=false"}) {
      all.insert(all.end(), {"--set", change});
    }
    all.insert(all.end(), more.begin(), more.end());
    return small_render("snow", all);
  }

  Environment environment(const std::string& faults) const {
    return {"OCL_ICD_VENDORS=" AEROSTAT_FAKE_OPENCL_DIR, "FAKE_CL_FAULTS=" + faults,
            "FAKE_CL_COUNTS=" + (folder_ / "counts").string()};
  }

  Counts counts() const {
    const std::string bytes = read_bytes(folder_ / "counts");
    Counts counts;
    for (std::size_t i = 0; i < kFakedFunctions.size() && 8 * (i + 1) <= bytes.size(); ++i) {
      std::uint64_t count = 0;
      std::memcpy(&count, bytes.data() + 8 * i, sizeof(count));
      counts[kFakedFunctions[i]] = count;
    }
    return counts;
  }

  void forget() const {
    fs::remove(folder_ / "counts");
    fs::remove(folder_ / "x.png");
  }
};

/// The functions by which an object or memory is given back. A render does not look at what they
/// return.
bool gives_back(const std::string& function) {
  return function.starts_with("clRelease") || function == "clEnqueueUnmapMemObject";
}

int status_of(const std::string& function) {
  if (function == "clBuildProgram") return -11;      // CL_BUILD_PROGRAM_FAILURE
  if (function == "clCreateBuffer") return -4;       // CL_MEM_OBJECT_ALLOCATION_FAILURE
  if (function == "clEnqueueMapBuffer") return -12;  // CL_MAP_FAILURE
  if (function == "clWaitForEvents") return -14;     // CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST
  if (function == "clGetDeviceIDs") return -1;       // CL_DEVICE_NOT_FOUND
  if (function == "clCreateKernel") return -46;      // CL_INVALID_KERNEL_NAME
  return -5;                                         // CL_OUT_OF_RESOURCES
}

/// The functions that a render calls.
constexpr std::array kCalled{"clGetPlatformInfo",
                             "clGetDeviceIDs",
                             "clGetDeviceInfo",
                             "clRetainDevice",
                             "clReleaseDevice",
                             "clCreateContext",
                             "clCreateCommandQueue",
                             "clCreateBuffer",
                             "clReleaseMemObject",
                             "clCreateProgramWithSource",
                             "clBuildProgram",
                             "clReleaseProgram",
                             "clCreateKernel",
                             "clSetKernelArg",
                             "clWaitForEvents",
                             "clGetEventProfilingInfo",
                             "clReleaseEvent",
                             "clFlush",
                             "clFinish",
                             "clEnqueueWriteBuffer",
                             "clEnqueueFillBuffer",
                             "clEnqueueMapBuffer",
                             "clEnqueueUnmapMemObject",
                             "clEnqueueNDRangeKernel"};

class AtEachCall : public DriverFaults, public testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Functions, AtEachCall, testing::ValuesIn(kCalled),
                         [](const auto& each) { return std::string(each.param); });

TEST_F(DriverFaults, AreTestedOfAllFunctionsThatARenderCalls) {
  ASSERT_EQ(render("").code, 0);
  for (const auto& [function, count] : counts()) {
    const bool is_tested = std::find(kCalled.begin(), kCalled.end(), function) != kCalled.end();
    EXPECT_EQ(count > 0, is_tested) << function;
  }
}

TEST_P(AtEachCall, AFailureIsSaidAndLeavesNothing) {
  const std::string function = GetParam();
  const Outcome good = render("");
  ASSERT_EQ(good.code, 0) << good.err;
  const std::string picture = read_bytes(folder_ / "x.png");
  const std::uint64_t calls = counts()[function];
  ASSERT_GT(calls, 0u) << "a render does not call it";
  for (const std::uint64_t number : std::set<std::uint64_t>{1, 2, calls / 2, calls}) {
    if (number == 0 || number > calls) continue;
    forget();
    const std::string fault =
        function + ":" + std::to_string(number) + ":" + std::to_string(status_of(function));
    const Outcome outcome = render(fault);
    if (outcome.code == 0) {
      EXPECT_TRUE(read_bytes(folder_ / "x.png") == picture) << fault << ": another picture";
      continue;
    }
    const std::set<int> codes{69, 70, 75};
    EXPECT_TRUE(codes.contains(outcome.code)) << fault << ": code " << outcome.code << "\n"
                                              << outcome.err;
    EXPECT_NE(outcome.err.find("aerostat: "), std::string::npos) << fault << "\n" << outcome.err;
    EXPECT_EQ(outcome.err.find("internal error"), std::string::npos)
        << fault << " is told without a word on what was being done\n"
        << outcome.err;
    EXPECT_EQ(outcome.err.find("fake OpenCL"), std::string::npos) << outcome.err;
    EXPECT_EQ(files(), std::vector<std::string>{"counts"}) << fault << " left a part of an output";
  }
  if (gives_back(function)) {
    forget();
    EXPECT_EQ(render(function + ":1+:-5").code, 0) << "what is given back does not matter";
  }
}

TEST_F(DriverFaults, OfEachKindHaveTheirCodeAndWords) {
  const struct {
    const char* fault;
    int code;
    const char* words;
  } faults[] = {{"clGetDeviceIDs:1+:-1", 69, "there is no OpenCL device"},
                {"clGetPlatformInfo:1+:-5", 69, "not usable"},
                {"clCreateContext:1+:-2", 69, "opening the device"},
                {"clBuildProgram:1+:-11", 70, "the kernels of render.cl do not build"},
                {"clBuildProgram:1+:-6", 75, "there is not enough memory"},
                {"clCreateBuffer:1+:-4", 75, "there is not enough memory"},
                {"clEnqueueNDRangeKernel@shade_hits:1:-5", 75, "starting the kernel shade_hits"},
                {"clWaitForEvents:2:-14", 75, "an earlier command on the device failed"},
                {"clWaitForEvents:2:-2", 75, "the device was lost"},
                {"clFinish:1+:-36", 70, "CL_INVALID_COMMAND_QUEUE"},
                {"clEnqueueMapBuffer:1+:-12", 75, "reading the film from the device"}};
  for (const auto& fault : faults) {
    const Outcome outcome = render(fault.fault);
    EXPECT_EQ(outcome.code, fault.code) << fault.fault << "\n" << outcome.err;
    EXPECT_TRUE(contains(outcome.err, fault.words)) << fault.fault;
    EXPECT_EQ(files(), std::vector<std::string>{"counts"}) << fault.fault;
    forget();
  }
}

TEST_F(DriverFaults, KernelsAreBuiltOnceMore) {
  // PoCL fails so if another process removes its files while it compiles.
  ASSERT_EQ(render("").code, 0);
  const std::string picture = read_bytes(folder_ / "x.png");
  forget();
  for (const char* fault : {"clBuildProgram:1:-11", "clCreateKernel:2:-46", "clFinish:1:-36"}) {
    const Outcome outcome = render(fault);
    EXPECT_EQ(outcome.code, 0) << fault << "\n" << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "the kernels are built once more"));
    EXPECT_TRUE(read_bytes(folder_ / "x.png") == picture) << fault;
    forget();
  }
  const Outcome always = render("clBuildProgram:1+:-11");
  EXPECT_EQ(always.code, 70);
  EXPECT_TRUE(contains(always.err, "the kernels are built once more"));
  EXPECT_EQ(counts()["clBuildProgram"], 2u);
  forget();
  // Kernels of a folder are not tried again, because they are most likely at fault themselves.
  Environment surroundings = environment("clBuildProgram:1:-11");
  surroundings.emplace_back("AEROSTAT_KERNEL_DIR=" AEROSTAT_SOURCE_DIR "/kernels");
  const Outcome folder = run(arguments({}), surroundings);
  EXPECT_EQ(folder.code, 70) << folder.err;
  EXPECT_TRUE(
      contains(folder.err, AEROSTAT_SOURCE_DIR "/kernels (AEROSTAT_KERNEL_DIR) do not build"));
}

TEST_F(DriverFaults, ACallThatHangsIsInterruptedWithinASecond) {
  for (const char* function :
       {"clWaitForEvents:3:hang", "clFinish:5:hang", "clEnqueueMapBuffer:1:hang"}) {
    Process process(arguments({}), folder_, environment(function));
    std::this_thread::sleep_for(std::chrono::seconds(3));
    const auto sent = std::chrono::steady_clock::now();
    process.send(SIGINT);
    const Outcome outcome = process.wait();
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - sent;
    EXPECT_EQ(outcome.code, 130) << function << "\n" << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "aerostat: interrupted"));
    EXPECT_LT(waited.count(), 3.0) << function;
    EXPECT_FALSE(fs::exists(folder_ / "x.png"));
    forget();
  }
}

TEST_F(DriverFaults, ADeviceThatHangsIsGivenUp) {
  Environment surroundings = environment("clWaitForEvents:3:hang");
  surroundings.emplace_back("AEROSTAT_DEVICE_TIMEOUT=2");
  const Outcome outcome = run(arguments({}), surroundings);
  EXPECT_EQ(outcome.code, 75) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "the device has not answered for 2 s and is given up"));
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
}

TEST_F(DriverFaults, ALostDeviceLeavesACheckpointFromWhichAnotherGoesOn) {
  const std::vector<std::string> saving{"--checkpoint", "x.ckpt", "--checkpoint-every", "0.001",
                                        "--width",      "320",    "--height",           "180"};
  const Outcome whole = render("", {"--width", "320", "--height", "180"});
  ASSERT_EQ(whole.code, 0) << whole.err;
  const std::string picture = read_bytes(folder_ / "x.png");
  forget();
  // How often a render waits depends on the speed of the machine. Therefore the device is lost when
  // the first checkpoint has been written, which is before the last pass.
  const Outcome lost = render("clWaitForEvents:" + (folder_ / "x.ckpt").string() + ":-2", saving);
  EXPECT_EQ(lost.code, 75) << lost.err;
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
  ASSERT_TRUE(fs::exists(folder_ / "x.ckpt"));
  const Outcome rest = render("", saving);
  EXPECT_EQ(rest.code, 0) << rest.err;
  EXPECT_TRUE(contains(rest.err, "going on from"));
  EXPECT_TRUE(read_bytes(folder_ / "x.png") == picture);
}

}  // namespace
}  // namespace aerostat::test

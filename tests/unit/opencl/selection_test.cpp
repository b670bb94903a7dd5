// Tests which devices a selector names, first with made-up devices, then with parts of a real one.
#include <cstdlib>
#include <numeric>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "opencl/buffer.hpp"
#include "opencl/cl.hpp"
#include "opencl/launch.hpp"
#include "opencl/partition.hpp"
#include "support/error_of.hpp"

namespace aerostat::opencl {
namespace {

using test::error_of;

/// Gives PoCL's device three compute units, however many cores there are. It must be set before the
/// first call of OpenCL.
class ThreeComputeUnits : public testing::Environment {
 public:
  void SetUp() override { ::setenv("POCL_MAX_PTHREAD_COUNT", "3", 1); }
};
const auto* const kThreeUnits = testing::AddGlobalTestEnvironment(new ThreeComputeUnits);

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Returns the selectors of devices, such as "0:0 1:1/2.0".
std::string selectors(const std::vector<Device>& devices) {
  std::string text;
  for (const Device& device : devices) {
    if (!text.empty()) text += ' ';
    text += device.selector();
  }
  return text;
}

Device made_up(int platform, int index, const char* name, DeviceType type) {
  Device device;
  device.platform_index = platform;
  device.device_index = index;
  device.platform = platform == 0 ? "Portable Computing Language" : "NVIDIA CUDA";
  device.name = name;
  device.type = type;
  return device;
}

DeviceList three_devices() {
  DeviceList list;
  list.devices = {made_up(0, 0, "pthread-haswell", DeviceType::cpu),
                  made_up(1, 0, "GeForce One", DeviceType::gpu),
                  made_up(1, 1, "GeForce Two", DeviceType::gpu)};
  return list;
}

TEST(Pick, FollowsTheSelector) {
  const auto list = three_devices();
  const auto picked = [&](const char* selector) { return selectors(pick(list, selector)); };
  EXPECT_EQ(picked(""), "1:0");
  EXPECT_EQ(picked("auto"), "1:0");
  EXPECT_EQ(picked("cpu"), "0:0");
  EXPECT_EQ(picked("GPU"), "1:0");
  EXPECT_EQ(picked("1:1"), "1:1");
  EXPECT_EQ(picked("geforce two"), "1:1");
  EXPECT_EQ(picked("portable"), "0:0");
  EXPECT_EQ(picked("nvidia"), "1:0");
}

TEST(Pick, AutoTakesTheCpuWhereThereIsNoGpu) {
  DeviceList list;
  list.devices = {made_up(0, 0, "dsp", DeviceType::other), made_up(0, 1, "x", DeviceType::cpu)};
  EXPECT_EQ(selectors(pick(list, "auto")), "0:1");
  list.devices.pop_back();
  EXPECT_EQ(selectors(pick(list, "auto")), "0:0");
}

TEST(Pick, ListsWhatThereIs) {
  auto list = three_devices();
  list.problems = {"platform 2 (Broken): it has no devices"};
  for (const char* selector : {"2:0", "1:2", "99999999999999999999:0", "radeon"}) {
    const auto error = error_of([&] { pick(list, selector); });
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    const std::string message = error.what();
    EXPECT_TRUE(contains(message, selector)) << message;
    EXPECT_TRUE(contains(message, "\n  0:0  pthread-haswell (cpu)\n")) << message;
    EXPECT_TRUE(contains(message, "\n  1:1  GeForce Two (gpu)")) << message;
    EXPECT_TRUE(contains(message, "platform 2 (Broken)")) << message;
  }
}

TEST(Pick, TellsWhatToInstallOrMend) {
  DeviceList list;
  list.problems = {"no OpenCL platform is installed"};
  const auto none = error_of([&] { pick(list, "auto"); });
  EXPECT_EQ(none.kind(), ErrorKind::no_device);
  EXPECT_TRUE(contains(none.what(), "pocl-opencl-icd")) << none.what();
  list.cache_problem = "POCL_CACHE_DIR names /nowhere";
  const auto cache = error_of([&] { pick(list, "auto"); });
  EXPECT_EQ(cache.kind(), ErrorKind::io);
  EXPECT_STREQ(cache.what(), "POCL_CACHE_DIR names /nowhere");
}

TEST(Selector, ComesFromOptionThenVariable) {
  setenv("AEROSTAT_DEVICE", "gpu", 1);
  EXPECT_EQ(effective_selector("0:0"), "0:0");
  EXPECT_EQ(effective_selector(""), "gpu");
  unsetenv("AEROSTAT_DEVICE");
  EXPECT_EQ(effective_selector(""), "auto");
}

TEST(Pick, TakesListsInTheirOrder) {
  const auto list = three_devices();
  const auto picked = [&](const char* selector) { return selectors(pick(list, selector)); };
  EXPECT_EQ(picked("1:1,0:0"), "1:1 0:0");
  EXPECT_EQ(picked("gpu,cpu"), "1:0 0:0");
  EXPECT_EQ(picked("geforce two,1:0,Portable"), "1:1 1:0 0:0");
  EXPECT_EQ(picked("all"), "0:0 1:0 1:1");
  EXPECT_EQ(picked("ALL"), "0:0 1:0 1:1");
}

TEST(Pick, TakesNoComputeUnitTwice) {
  const auto list = three_devices();
  for (const char* selector : {"0:0,0:0", "gpu,1:0", "all,cpu", "1:1,geforce two"}) {
    const auto error = error_of([&] { pick(list, selector); });
    EXPECT_EQ(error.kind(), ErrorKind::usage) << selector;
    EXPECT_TRUE(contains(error.what(), "the same compute units")) << error.what();
  }
}

TEST(Pick, RefusesMalformedLists) {
  const auto list = three_devices();
  for (const char* selector : {",", "0:0,", ",0:0", "0:0,,1:0"}) {
    EXPECT_EQ(error_of([&] { pick(list, selector); }).kind(), ErrorKind::usage) << selector;
  }
  for (const char* selector : {"0:0/0", "0:0/2.2", "0:0/2.", "0:0/.1", "0:0/2.0.1", "0:0/0.0",
                               "cpu/99999999999", "0:0/2.99999999999", "1:0,0:0/1.1"}) {
    const auto error = error_of([&] { pick(list, selector); });
    EXPECT_EQ(error.kind(), ErrorKind::usage) << selector;
    EXPECT_TRUE(contains(error.what(), "DEVICE/N.K")) << error.what();
  }
}

TEST(Pick, FindsNamesWithSlashesAndNoneThatIsNotThere) {
  auto list = three_devices();
  list.devices.push_back(made_up(1, 2, "Radeon 7/8 XT", DeviceType::gpu));
  EXPECT_EQ(selectors(pick(list, "7/8 xt")), "1:2");
  for (const char* selector : {"0:0,2:0", "2:0,0:0", "2:0/2", "0:0/half"}) {
    EXPECT_EQ(error_of([&] { pick(list, selector); }).kind(), ErrorKind::no_device) << selector;
  }
  EXPECT_EQ(error_of([] { pick({}, "all"); }).kind(), ErrorKind::no_device);
}

TEST(Pick, CutsOnlyWhatItsDriverCuts) {
  auto list = three_devices();
  list.devices[0].most_parts = 4;
  const auto whole = error_of([&] { pick(list, "gpu/2"); });
  EXPECT_EQ(whole.kind(), ErrorKind::no_device);
  EXPECT_TRUE(contains(whole.what(), "1:0  GeForce One (gpu) cannot be cut")) << whole.what();
  const auto many = error_of([&] { pick(list, "cpu/5"); });
  EXPECT_EQ(many.kind(), ErrorKind::no_device);
  EXPECT_TRUE(contains(many.what(), "into 5 parts: at most 4 are possible")) << many.what();
}

TEST(Shares, AreEvenAndLeaveNothing) {
  EXPECT_EQ(even_shares(8, 2), (std::vector<unsigned>{4, 4}));
  EXPECT_EQ(even_shares(8, 3), (std::vector<unsigned>{3, 3, 2}));
  EXPECT_EQ(even_shares(3, 3), (std::vector<unsigned>{1, 1, 1}));
  EXPECT_EQ(even_shares(7, 1), (std::vector<unsigned>{7}));
}

/// The platform whose device can be cut and has three compute units here. Other drivers for a CPU
/// need not have these properties.
const std::string kPocl = "Portable Computing Language";

Device whole_pocl() {
  return pick(list_devices(), kPocl).front();
}

TEST(Parts, ShareOutTheComputeUnits) {
  const Device whole = whole_pocl();
  ASSERT_GE(whole.most_parts, 2u);
  const auto parts = cut(whole, 2);
  ASSERT_EQ(parts.size(), 2u);
  unsigned units = 0;
  for (const Device& part : parts) {
    EXPECT_EQ(part.handle->getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>(), part.compute_units);
    EXPECT_EQ(part.lanes, whole.lanes);
    EXPECT_EQ(part.most_parts, 0u);
    units += part.compute_units;
  }
  EXPECT_EQ(units, whole.compute_units);
}

TEST(Parts, AreNamedByTheirSelectors) {
  const std::string whole = whole_pocl().selector();
  const auto list = list_devices();
  EXPECT_EQ(selectors(pick(list, kPocl + "/2")), whole + "/2.0 " + whole + "/2.1");
  EXPECT_EQ(selectors(pick(list, kPocl + "/2.1")), whole + "/2.1");
  EXPECT_EQ(selectors(pick(list, whole + "/2.1," + whole + "/2.0")),
            whole + "/2.1 " + whole + "/2.0");
  EXPECT_EQ(selectors(pick(list, kPocl + "/1")), whole + "/1.0");
  for (const auto& [one, other] :
       {std::pair{"", "/2"}, {"/2", ""}, {"/2", "/2.1"}, {"/2.0", "/3.2"}}) {
    const auto selector = kPocl + one + "," + kPocl + other;
    EXPECT_EQ(error_of([&] { pick(list, selector); }).kind(), ErrorKind::usage) << selector;
  }
}

TEST(Parts, EachComputeByThemselves) {
  const SourceTree tree{{"a.cl", "kernel void give(global int* out, int v) { out[0] = v; }\n"}};
  int value = 40;
  for (const Device& part : cut(whole_pocl(), 2)) {
    const Context context(part);
    auto kernel = Program(context, tree, "a.cl", 1).kernel("give");
    const Buffer<int> out(context, {}, 1, "the answer");
    launch(context, kernel, 1, out, ++value);
    EXPECT_EQ(out.read(), std::vector<int>{value}) << part.selector();
  }
}

TEST(Select, OneDeviceIsOne) {
  EXPECT_EQ(select_device(kPocl + "/2.1").part, 1u);
  EXPECT_EQ(error_of([] { select_device(kPocl + "/2"); }).kind(), ErrorKind::usage);
}

}  // namespace
}  // namespace aerostat::opencl

// Tests the explanations of why a registered driver is not among the platforms.
#include "opencl/registered.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "opencl/device.hpp"
#include "support/error_of.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Registered : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"system", "mine"}) fs::create_directory(root_ / folder);
    environment_.system_folder = root_ / "system";
  }

  fs::path write(const char* name, const std::string& text) const {
    std::ofstream(root_ / name) << text;
    return root_ / name;
  }

  /// Returns the drivers in the form "library (file), library (file)".
  std::string found() const {
    std::string text;
    for (const auto& driver : registered_drivers(environment_)) {
      if (!text.empty()) text += ", ";
      text += driver.library + " (" + driver.file.lexically_relative(root_).string() + ")";
    }
    return text;
  }

  const test::TemporaryFolder folder_;
  const fs::path root_ = folder_.path();
  VendorEnvironment environment_;
};

TEST_F(Registered, AreWhereTheLoaderLooks) {
  EXPECT_EQ(found(), "");
  write("system/b.icd", "libb.so\n");
  write("system/a.icd", "/opt/liba.so \r\n");
  write("system/README", "liba.so\n");
  write("mine/c.icd", "libc.so\n");
  EXPECT_EQ(found(), "/opt/liba.so (system/a.icd), libb.so (system/b.icd)");
  environment_.opencl_vendor_path = (root_ / "mine").string();
  EXPECT_EQ(found(), "libc.so (mine/c.icd)");
  environment_.ocl_icd_vendors = (root_ / "system").string() + "/";
  EXPECT_EQ(found(), "/opt/liba.so (system/a.icd), libb.so (system/b.icd)");
  environment_.ocl_icd_vendors = (root_ / "system/b.icd").string();
  EXPECT_EQ(found(), "libb.so (system/b.icd)");
  environment_.ocl_icd_vendors = "c.icd";
  EXPECT_EQ(found(), "libc.so (mine/c.icd)");
  environment_.ocl_icd_vendors = "/opt/libd.so";
  ASSERT_EQ(registered_drivers(environment_).size(), 1u);
  EXPECT_EQ(registered_drivers(environment_)[0].library, "/opt/libd.so");
  EXPECT_EQ(registered_drivers(environment_)[0].file, "");
}

TEST_F(Registered, AreNamedWithTheReason) {
  const auto text_of = [](const RegisteredDriver& driver) {
    const auto problems = problems_of({driver}, true);
    EXPECT_EQ(problems.texts.size(), 1u);
    EXPECT_FALSE(problems.lack_memory);
    return problems.texts.empty() ? "" : problems.texts.front();
  };
  const fs::path icd = write("system/x.icd", "libnothere.so.7\n");
  const auto missing = text_of({"libnothere.so.7", icd});
  EXPECT_TRUE(
      contains(missing, "the driver libnothere.so.7, which " + icd.string() + " registers"));
  EXPECT_TRUE(contains(missing, "cannot open shared object file")) << missing;
  const auto direct = text_of({"libnothere.so.7"});
  EXPECT_TRUE(contains(direct, "which OCL_ICD_VENDORS registers")) << direct;
  const fs::path text = write("driver.so",
                              "no library, but a text that is long enough for a header, "
                              "which a library begins with");
  EXPECT_TRUE(contains(text_of({text.string(), icd}), "invalid ELF header"));
  EXPECT_TRUE(contains(text_of({"", icd}), "the file names no library"));
  EXPECT_TRUE(contains(text_of({"", root_ / "gone.icd"}), "the file cannot be read"));
  EXPECT_TRUE(contains(text_of({"libanl.so.1", icd}), "it is not an OpenCL driver"));
}

TEST(Memory, IsNamedByLoaders) {
  EXPECT_TRUE(speaks_of_memory("libLLVM-15.so.1: cannot map zero-fill pages"));
  EXPECT_TRUE(speaks_of_memory("libx.so: failed to map segment from shared object"));
  EXPECT_TRUE(speaks_of_memory("cannot create shared object descriptor: Cannot allocate memory"));
  EXPECT_TRUE(speaks_of_memory("std::bad_alloc"));
  EXPECT_FALSE(speaks_of_memory("libx.so: cannot open shared object file: No such file"));
}

TEST(Advice, FitsTheCause) {
  DeviceList list;
  EXPECT_TRUE(contains(advice_without_devices(list), "install pocl-opencl-icd"));
  list.has_drivers = true;
  EXPECT_TRUE(contains(advice_without_devices(list), "repair the driver that is registered"));
  list.lacks_memory = true;
  EXPECT_FALSE(contains(advice_without_devices(list), "install"));
  EXPECT_TRUE(contains(advice_without_devices(list), "ulimit -v"));
  EXPECT_EQ(test::error_of([&] { pick(list, "auto"); }).kind(), ErrorKind::exhausted);
}

}  // namespace
}  // namespace aerostat::opencl

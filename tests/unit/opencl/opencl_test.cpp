// Tests sources, includes and options, which need no device.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "opencl/embedded.hpp"
#include "opencl/program.hpp"
#include "opencl/status.hpp"
#include "support/error_of.hpp"

namespace aerostat::opencl {
namespace {

using test::error_of;

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Embedded, EqualsTheFilesOnDisk) {
  const fs::path root = fs::path(AEROSTAT_SOURCE_DIR) / "kernels";
  std::size_t files = 0;
  for (const auto& item : fs::recursive_directory_iterator(root)) {
    const auto extension = item.path().extension();
    if (extension != ".h" && extension != ".clh" && extension != ".cl") continue;
    ++files;
    const auto name = item.path().lexically_relative(root).generic_string();
    const auto embedded = embedded_files();
    const auto found = std::find_if(embedded.begin(), embedded.end(),
                                    [&](const EmbeddedFile& file) { return file.path == name; });
    ASSERT_NE(found, embedded.end()) << name;
    EXPECT_EQ(found->text, text_of(item.path())) << name;
  }
  EXPECT_EQ(files, embedded_files().size());
  EXPECT_GT(files, 0u);
}

TEST(KernelSources, ComeFromTheFolderOfTheVariable) {
  const fs::path folder = fs::path(testing::TempDir()) / "aerostat_kernels";
  fs::remove_all(folder);
  fs::create_directories(folder / "device");
  std::ofstream(folder / "device" / "a.clh") << "int a;\n";
  std::ofstream(folder / "notes.txt") << "no kernel\n";
  setenv("AEROSTAT_KERNEL_DIR", folder.c_str(), 1);
  const auto tree = kernel_sources();
  EXPECT_EQ(tree, (SourceTree{{"device/a.clh", "int a;\n"}}));

  fs::remove(folder / "device" / "a.clh");
  const auto empty = error_of([] { kernel_sources(); });
  EXPECT_EQ(empty.kind(), ErrorKind::io);
  EXPECT_TRUE(contains(empty.what(), "AEROSTAT_KERNEL_DIR")) << empty.what();

  fs::remove_all(folder);
  EXPECT_EQ(error_of([] { kernel_sources(); }).kind(), ErrorKind::io);
  unsetenv("AEROSTAT_KERNEL_DIR");
  EXPECT_EQ(kernel_sources().size(), embedded_files().size());
}

TEST(Flatten, ReplacesNestedIncludesOnceEach) {
  const SourceTree tree{{"render.cl", "#include \"a.clh\"\n#include \"shared/s.h\"\nint render;\n"},
                        {"device/a.clh", "#pragma once\n#include \"b.clh\"\nint a;\n"},
                        {"device/b.clh", "#include \"s.h\"\n#include \"../shared/s.h\"\nint b;\n"},
                        {"shared/s.h", "int s;"}};
  const auto text = flatten(tree, "render.cl");
  for (const char* line : {"int s;", "int a;", "int b;", "int render;"}) {
    EXPECT_EQ(occurrences(text, line), 1) << line;
  }
  EXPECT_LT(text.find("int s;"), text.find("int b;"));
  EXPECT_LT(text.find("int b;"), text.find("int a;"));
  EXPECT_FALSE(contains(text, "#include"));
  EXPECT_FALSE(contains(text, "#pragma once"));
}

TEST(Flatten, PrefersTheNeighbour) {
  const SourceTree tree{{"render.cl", "#include \"device/user.clh\"\n"},
                        {"device/user.clh", "#include \"x.h\"\n"},
                        {"device/x.h", "near\n"},
                        {"shared/x.h", "far\n"}};
  const auto text = flatten(tree, "render.cl");
  EXPECT_TRUE(contains(text, "near"));
  EXPECT_FALSE(contains(text, "far"));
}

TEST(Flatten, MarksLinesSoThatMessagesStayTrue) {
  const SourceTree tree{{"render.cl", "one\n#include \"a.clh\"\nthree\n"},
                        {"device/a.clh", "first\nsecond\n"}};
  EXPECT_EQ(flatten(tree, "render.cl"),
            "#line 1 \"render.cl\"\none\n"
            "#line 1 \"device/a.clh\"\nfirst\nsecond\n"
            "#line 2 \"render.cl\"\n\nthree\n");
}

TEST(Flatten, LeavesSystemIncludesAndCommentsAlone) {
  const std::string source =
      "#ifndef __OPENCL_VERSION__\n#include <stdint.h>\n#endif\n"
      "// #include \"gone.h\"\n/* text\n#include \"gone.h\"\n*/\nint x;\n";
  EXPECT_EQ(flatten({{"a.cl", source}}, "a.cl"), "#line 1 \"a.cl\"\n" + source);
}

TEST(Flatten, NamesTheIncluderOfAMissingFile) {
  const auto error = error_of([] { flatten({{"a.cl", "\n#include \"gone.clh\"\n"}}, "a.cl"); });
  EXPECT_EQ(error.kind(), ErrorKind::internal);
  EXPECT_TRUE(contains(error.what(), "a.cl:2")) << error.what();
  EXPECT_TRUE(contains(error.what(), "gone.clh")) << error.what();
  EXPECT_EQ(error_of([] { flatten({}, "b.cl"); }).kind(), ErrorKind::internal);
}

TEST(Flatten, RefusesAFileThatAConditionMayHide) {
  SourceTree tree{{"a.cl", "#if LANES == 1\n#include \"x.h\"\n#endif\n#include \"x.h\"\n"},
                  {"shared/x.h", "#ifndef X\n#define X\n#include \"y.h\"\n#endif\n"},
                  {"shared/y.h", "int y;\n"}};
  EXPECT_EQ(error_of([&] { flatten(tree, "a.cl"); }).kind(), ErrorKind::internal);
  // A guard around a whole header does not count as a condition.
  tree["a.cl"] = "#include \"x.h\"\n#include \"y.h\"\n";
  EXPECT_EQ(occurrences(flatten(tree, "a.cl"), "int y;"), 1);
}

TEST(Flatten, TakesEveryEntryOfTheProduct) {
  const auto tree = kernel_sources();
  for (const auto& [path, text] : tree) EXPECT_NO_THROW(flatten(tree, path)) << path;
}

TEST(Options, NameTheLanguageAndTheLanes) {
  EXPECT_TRUE(contains(build_options(8), "-cl-std=CL1.2"));
  EXPECT_TRUE(contains(build_options(8), "-DLANES=8"));
  EXPECT_EQ(error_of([] { build_options(3); }).kind(), ErrorKind::usage);
}

TEST(Lanes, FollowTheDevice) {
  EXPECT_EQ(lanes_for(DeviceType::gpu, 4, 4), 1);
  EXPECT_EQ(lanes_for(DeviceType::other, 8, 8), 1);
  EXPECT_EQ(lanes_for(DeviceType::cpu, 16, 1), 16);
  EXPECT_EQ(lanes_for(DeviceType::cpu, 8, 16), 8);
  EXPECT_EQ(lanes_for(DeviceType::cpu, 0, 8), 8);
  EXPECT_EQ(lanes_for(DeviceType::cpu, 1, 1), 4);
  EXPECT_EQ(lanes_for(DeviceType::cpu, 64, 64), 16);
}

TEST(Status, IsNamedAndSorted) {
  EXPECT_EQ(status_name(CL_OUT_OF_RESOURCES), "CL_OUT_OF_RESOURCES");
  EXPECT_TRUE(contains(status_name(-12345), "-12345"));
  const auto kind_of = [](int status) {
    return error_of([&] { guarded("testing", [&] { throw cl::Error(status, "clCall"); }); }).kind();
  };
  for (const int status : {CL_MEM_OBJECT_ALLOCATION_FAILURE, CL_OUT_OF_HOST_MEMORY,
                           CL_OUT_OF_RESOURCES, CL_DEVICE_NOT_AVAILABLE, -9999}) {
    EXPECT_EQ(kind_of(status), ErrorKind::exhausted) << status;
  }
  EXPECT_EQ(kind_of(CL_INVALID_VALUE), ErrorKind::internal);
  const auto error = error_of([] { rethrow("drawing", cl::Error(CL_INVALID_VALUE, "clCall")); });
  for (const char* part : {"drawing", "CL_INVALID_VALUE", "clCall"}) {
    EXPECT_TRUE(contains(error.what(), part)) << error.what();
  }
}

}  // namespace
}  // namespace aerostat::opencl

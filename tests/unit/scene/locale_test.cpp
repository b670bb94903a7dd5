// Tests that scene files mean the same in every locale of the process.
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "scene/source.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::scene {
namespace {

namespace fs = std::filesystem;

/// The name of a locale whose decimal mark has two bytes. The test compiles it if the system has
/// its source. On other systems the test does nothing.
const std::string kName = "ps_AF";

class SceneLocale : public testing::Test {
 protected:
  void SetUp() override {
    const std::string path = (folder_ / (kName + ".UTF-8")).string();
    const std::string command =
        "localedef -i " + kName + " -f UTF-8 '" + path + "' >/dev/null 2>&1";
    [[maybe_unused]] const int result = std::system(command.c_str());
    ::setenv("LOCPATH", folder_.c_str(), 1);
  }
  void TearDown() override {
    std::setlocale(LC_ALL, "C");
    ::unsetenv("LOCPATH");
  }

  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(SceneLocale, NumbersAreReadAndWrittenWithADot) {
  const auto text = [] {
    return SceneSource()
        .with({{"/terrain/fractal/gain", "0.6"}, {"/camera/fov_y_deg", "35.25"}})
        .text();
  };
  const std::string expected = text();
  ASSERT_NE(expected.find("0.6"), std::string::npos);
  if (std::setlocale(LC_ALL, (kName + ".UTF-8").c_str()) == nullptr) {
    std::puts("there is no source of the locale here");
    return;
  }
  const std::string mark = std::localeconv()->decimal_point;
  EXPECT_NE(mark, ".");
  EXPECT_EQ(text(), expected);
  EXPECT_EQ(std::localeconv()->decimal_point, mark) << "the locale was not given back";
}

}  // namespace
}  // namespace aerostat::scene

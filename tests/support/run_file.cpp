#include <iostream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace {

bool is_of_file(const testing::TestInfo& test, const std::string& name) {
  return std::string_view(test.file()).ends_with("/" + name + ".cpp");
}

/// Returns a filter for the tests of the source file `name`. It is empty if there are none.
std::string filter_for(const std::string& name) {
  const auto& all = *testing::UnitTest::GetInstance();
  std::string filter;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (is_of_file(test, name)) filter += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  return filter;
}

}  // namespace

/// Runs all tests of the program, or those of one source file: `image_test --file=golden_test`.
/// Tests of one file share worlds and programs, which take longer to build than to use.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const std::string_view option = "--file=";
  if (argc == 2 && std::string_view(argv[1]).starts_with(option)) {
    const std::string name = argv[1] + option.size();
    const std::string filter = filter_for(name);
    if (filter.empty()) {
      std::cerr << "there are no tests in " << name << ".cpp\n";
      return 1;
    }
    GTEST_FLAG_SET(filter, filter);
  }
  return RUN_ALL_TESTS();
}

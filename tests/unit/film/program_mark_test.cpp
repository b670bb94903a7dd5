// Tests which programs count as the same in the marks of frames.
#include "film/program_mark.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include <gtest/gtest.h>

#include "film/sources_hash.hpp"
#include "opencl/program.hpp"

namespace aerostat::film {
namespace {

TEST(ProgramMark, TellsEveryKernelFile) {
  const opencl::SourceTree kernels = opencl::kernel_sources();
  const std::string mark = program_mark(kernels);
  EXPECT_EQ(program_mark(kernels), mark);
  for (const auto& [path, text] : kernels) {
    opencl::SourceTree changed = kernels;
    changed[path] += "\n";
    EXPECT_NE(program_mark(changed), mark) << path;
    opencl::SourceTree renamed = kernels;
    renamed.erase(path);
    EXPECT_NE(program_mark(renamed), mark) << path;
    renamed.emplace(path + "x", text);
    EXPECT_NE(program_mark(renamed), mark) << path;
  }
}

TEST(ProgramMark, TellsTheSourcesOfTheHost) {
  const std::string hash(sources_hash());
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_TRUE(std::all_of(hash.begin(), hash.end(), [](unsigned char digit) {
    return std::isxdigit(digit) != 0;
  })) << hash;
  // SHA-256 of an empty text begins with these digits, so that they would mean that no file was
  // read.
  EXPECT_NE(hash, "e3b0c44298fc1c14");
}

}  // namespace
}  // namespace aerostat::film

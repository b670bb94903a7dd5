// Tests renders of parts of pictures.
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using Crop = CliTest;

std::vector<std::string> huge_render(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"--quality", "draft",
                                     "--width",   "30000",
                                     "--height",  "30000",
                                     "--crop",    "15000,14000,15064,14036",
                                     "--set",     "/vegetation/enabled=false"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return small_render("snow", arguments);
}

TEST_F(Crop, OfAHugePictureTakesLittleMemory) {
  const Outcome outcome = run(huge_render({}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(png_size(read_bytes(folder_ / "snow.png")), (std::pair{64u, 36u}));
  EXPECT_LT(outcome.peak_bytes, std::uint64_t{1} << 30) << "the whole film alone has 44 GiB";
}

TEST_F(Crop, CountsItsOwnFilmAgainstTheMemoryLimit) {
  const Outcome outcome = run(huge_render({"--memory-limit", "64M"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(Crop, AsAnExrSaysWhereItBelongs) {
  const Outcome outcome = run(huge_render({"-o", "x.exr"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  Imf::InputFile file((folder_ / "x.exr").c_str());
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({15000, 14000}, {15063, 14035}));
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {29999, 29999}));
}

}  // namespace
}  // namespace aerostat::test

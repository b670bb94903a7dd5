// Tests --denoise with a library of the tests in place of Open Image Denoise. It adds 10 times the
// albedo and 100 times the normal to the radiance.
#include <filesystem>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "run_process.hpp"

namespace aerostat::test {
namespace {

using Denoising = CliTest;

std::vector<float> channel(const std::filesystem::path& path, const char* name) {
  Imf::InputFile file(path.c_str());
  const auto window = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  std::vector<float> values(width * static_cast<std::size_t>(window.max.y - window.min.y + 1));
  Imf::FrameBuffer frame;
  frame.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float)));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return values;
}

std::vector<std::string> small(const std::string& scene, const std::string& output,
                               const std::string& more = "") {
  std::vector<std::string> arguments{"render",           scene, "-o",       output, "-q",
                                     "--width",          "24",  "--height", "16",   "--set",
                                     "/terrain/cells=32"};
  if (!more.empty()) arguments.push_back(more);
  return arguments;
}

TEST_F(Denoising, GoesByTheLibraryBeforeTheFileIsWritten) {
  const std::string scene = scene_path("sand-empty");
  const Environment fake{"AEROSTAT_OIDN_DIR=" AEROSTAT_FAKE_OIDN_DIR};
  ASSERT_EQ(run(small(scene, "noisy.exr")).code, 0);
  const Outcome outcome = run(small(scene, "clean.exr", "--denoise"), fake);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto noisy = channel(folder_ / "noisy.exr", "G"),
             clean = channel(folder_ / "clean.exr", "G");
  const auto albedo = channel(folder_ / "noisy.exr", "albedo.G");
  const auto normal = channel(folder_ / "noisy.exr", "N.Y");
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    ASSERT_NEAR(clean[i], noisy[i] + 10.0f * albedo[i] + 100.0f * normal[i], 1e-4f) << i;
  }
  EXPECT_EQ(channel(folder_ / "clean.exr", "albedo.G"), albedo);
}

TEST_F(Denoising, ChangesAPng) {
  const std::string scene = scene_path("sand-empty");
  const Environment fake{"AEROSTAT_OIDN_DIR=" AEROSTAT_FAKE_OIDN_DIR};
  ASSERT_EQ(run(small(scene, "noisy.png")).code, 0);
  ASSERT_EQ(run(small(scene, "clean.png", "--denoise"), fake).code, 0);
  EXPECT_NE(read_bytes(folder_ / "noisy.png"), read_bytes(folder_ / "clean.png"));
}

TEST_F(Denoising, WithoutTheLibraryIsRefusedBeforeAnythingIsRendered) {
  const Outcome outcome =
      run(small(scene_path("sand-empty"), "x.png", "--denoise"), {"AEROSTAT_OIDN_DIR=/nowhere"});
  EXPECT_EQ(outcome.code, 69);
  EXPECT_NE(outcome.err.find("AEROSTAT_OIDN_DIR"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.png"));
}

}  // namespace
}  // namespace aerostat::test

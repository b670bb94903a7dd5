// Tests how files become pictures: drawings, what they may not reach, and faults.
#include "artwork/picture.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "artwork/template.hpp"
#include "core/child_process.hpp"
#include "core/confine.hpp"
#include "core/error.hpp"
#include "support/error_of.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::artwork {
namespace {

namespace fs = std::filesystem;
using test::error_of;

constexpr const char* kHead =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" "
    "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
    "width=\"40\" height=\"20\" viewBox=\"0 0 40 20\">";

/// Sets an environment variable until the end of a scope.
class Setting {
 public:
  Setting(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Setting() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

class PictureTest : public testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
    return folder_.path() / name;
  }

  static std::array<int, 4> pixel(const asset::Texture& texture, std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* at = &texture.rgba[std::size_t{4} * (y * texture.width + x)];
    return {at[0], at[1], at[2], at[3]};
  }

  /// Whether this system can draw SVG files.
  static bool can_draw() { return !find_program("rsvg-convert", "AEROSTAT_RSVG_CONVERT").empty(); }

  test::TemporaryFolder folder_;
};

TEST_F(PictureTest, DrawingsBecomePixels) {
  if (!can_draw()) GTEST_SKIP() << "rsvg-convert of librsvg is not installed";
  const auto file = write(
      "a.svg", std::string(kHead) + "<rect width=\"20\" height=\"20\" fill=\"#ff8000\"/></svg>");
  const Picture kept = read_picture(file, {400, 400, true});
  EXPECT_TRUE(kept.is_drawing);
  EXPECT_TRUE(kept.notes.empty());
  ASSERT_EQ(kept.texture.width, 400u);
  ASSERT_EQ(kept.texture.height, 200u) << "it keeps its proportions";
  EXPECT_EQ(pixel(kept.texture, 100, 100), (std::array{255, 128, 0, 255}));
  EXPECT_EQ(pixel(kept.texture, 300, 100)[3], 0);
  const Picture stretched = read_picture(file, {100, 100, false});
  EXPECT_EQ(stretched.texture.width, 100u);
  EXPECT_EQ(stretched.texture.height, 100u);
  EXPECT_EQ(pixel(stretched.texture, 40, 90), (std::array{255, 128, 0, 255}));
}

TEST_F(PictureTest, GuidesOfTheTemplateAreNotDrawn) {
  if (!can_draw()) GTEST_SKIP() << "rsvg-convert of librsvg is not installed";
  std::string svg = gores_template({});
  const Picture bare = read_picture(write("bare.svg", svg), {300, 150, false});
  for (std::size_t i = 3; i < bare.texture.rgba.size(); i += 4) {
    ASSERT_EQ(bare.texture.rgba[i], 0) << i;
  }
  const std::string place = "<g id=\"artwork\">\n";
  svg.insert(svg.find(place) + place.size(), "<rect width=\"100%\" height=\"100%\" fill=\"red\"/>");
  const Picture drawn = read_picture(write("drawn.svg", svg), {300, 150, false});
  EXPECT_EQ(pixel(drawn.texture, 150, 75), (std::array{255, 0, 0, 255}));
}

TEST_F(PictureTest, DrawingsReadNoOtherFiles) {
  if (!can_draw()) GTEST_SKIP() << "rsvg-convert of librsvg is not installed";
  const auto other = write(
      "other.svg", std::string(kHead) + "<rect width=\"40\" height=\"20\" fill=\"red\"/></svg>");
  for (const std::string& name : {std::string("other.svg"), "file://" + other.string()}) {
    const Picture picture = read_picture(
        write("a.svg", std::string(kHead) + "<image width=\"40\" height=\"20\" xlink:href=\"" +
                           name + "\"/></svg>"),
        {64, 64, true});
    EXPECT_EQ(pixel(picture.texture, 32, 16)[3], 0) << name;
    ASSERT_EQ(picture.notes.size(), 1u);
    EXPECT_NE(picture.notes[0].find(name), std::string::npos);
    EXPECT_NE(picture.notes[0].find("not read"), std::string::npos);
  }
  // An entity that would put the text of a file into the picture is refused or stays empty.
  const auto secret = write("secret", "MMMMMMMM");
  const auto entity =
      write("b.svg", "<!DOCTYPE svg [<!ENTITY x SYSTEM \"file://" + secret.string() + "\">]>" +
                         kHead + "<text y=\"18\" font-size=\"20\">&x;</text></svg>");
  try {
    const Picture picture = read_picture(entity, {64, 64, true});
    for (std::size_t i = 3; i < picture.texture.rgba.size(); i += 4) {
      ASSERT_EQ(picture.texture.rgba[i], 0);
    }
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
  }
}

/// A program in place of rsvg-convert shows what the child process may reach.
TEST_F(PictureTest, TheProgramReachesNothingElse) {
  const test::TemporaryFolder elsewhere;
  const auto secret = elsewhere.path() / "secret";
  std::ofstream(secret) << "secret";
  const auto program =
      write("rsvg-convert", "#!/bin/sh\ncat " + secret.string() +
                                " 2>/dev/null || echo nothing; echo \"$AEROSTAT_X\"; exit 3\n");
  fs::permissions(program, fs::perms::owner_all);
  const Setting chosen("AEROSTAT_RSVG_CONVERT", program.string());
  const Setting variable("AEROSTAT_X", "secret");
  const auto file = write("a.svg", std::string(kHead) + "</svg>");
  bool can_confine = false;
  std::thread([&] { can_confine = confine_this_thread({}); }).join();
  if (!can_confine) GTEST_SKIP() << "this system has no Landlock";
  const Error error = error_of([&] { read_picture(file, {}); });
  EXPECT_NE(std::string(error.what()).find("cannot draw it (nothing)"), std::string::npos)
      << error.what();
}

TEST_F(PictureTest, FaultsAreSaid) {
  const auto says = [](const Error& error, const std::string& part) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  };
  const auto drawing = write("a.svg", std::string(kHead) + "</svg>");
  {
    const Setting missing("AEROSTAT_RSVG_CONVERT", "/no/such/program");
    says(error_of([&] { read_picture(drawing, {}); }), "librsvg2-bin");
  }
  says(error_of([&] { read_picture(write("a.gif", "GIF89a"), {}); }), "PNG, JPEG or SVG");
  says(error_of([&] { read_picture(write("b.svg", "<html></html>"), {}); }), "PNG, JPEG or SVG");
  EXPECT_EQ(error_of([&] { read_picture(folder_.path() / "none.png", {}); }).kind(), ErrorKind::io);
  if (!can_draw()) return;
  says(error_of([&] { read_picture(write("c.svg", std::string(kHead) + "<g></svg>"), {}); }),
       "rsvg-convert cannot draw it");
}

}  // namespace
}  // namespace aerostat::artwork

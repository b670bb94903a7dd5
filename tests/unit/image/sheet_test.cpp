// Tests sheets of tiles.

#include "image/sheet.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace aerostat::image {
namespace {

Pixels plain(int width, int height, std::uint8_t value) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), value)};
}

std::uint8_t red(const Pixels& pixels, int x, int y) {
  return pixels.rgb[static_cast<std::size_t>(3 * (y * pixels.width + x))];
}

TEST(SheetLayout, ChoosesColumns) {
  EXPECT_EQ(layout_sheet(12, 320, 180).columns, 4);
  EXPECT_EQ(layout_sheet(1, 320, 180).columns, 1);
  EXPECT_EQ(layout_sheet(9, 320, 180).columns, 3);
  EXPECT_EQ(layout_sheet(6, 100, 1000).columns, 6) << "tall tiles stand in one row";
  EXPECT_EQ(layout_sheet(6, 1000, 50).columns, 1) << "flat ones lie in one column";
  EXPECT_EQ(layout_sheet(12, 320, 180, 5).columns, 5);
  EXPECT_EQ(layout_sheet(12, 320, 180, 5).rows(), 3);
  EXPECT_EQ(layout_sheet(3, 320, 180, 100).columns, 3);
}

TEST(SheetLayout, TilesAndLabelsLieInsideAndApart) {
  for (const int width : {1, 159, 320, 5000}) {
    const SheetLayout layout = layout_sheet(7, width, 30, 3);
    EXPECT_EQ(layout.tile_x(2) + width + layout.margin, layout.width());
    EXPECT_EQ(layout.tile_y(6) + 30 + layout.label_height() + layout.margin, layout.height());
    EXPECT_EQ(layout.tile_x(1) - layout.tile_x(0), width + layout.margin);
    EXPECT_EQ(layout.tile_y(3) - layout.tile_y(0), 30 + layout.label_height() + layout.margin);
    EXPECT_EQ(layout.tile_x(3), layout.tile_x(0));
  }
}

TEST(Sheet, HoldsEachTileInItsPlaceAndNothingElse) {
  const SheetLayout layout = layout_sheet(5, 40, 20, 3);
  Sheet sheet(layout);
  const std::uint8_t paper = red(sheet.pixels(), 0, 0);
  for (int i = 0; i < 5; ++i) sheet.place(i, plain(40, 20, static_cast<std::uint8_t>(100 + i)), "");
  for (int y = 0; y < layout.height(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      int expected = paper;
      for (int i = 0; i < 5; ++i) {
        const int dx = x - layout.tile_x(i), dy = y - layout.tile_y(i);
        if (dx >= 0 && dx < 40 && dy >= 0 && dy < 20) expected = 100 + i;
      }
      ASSERT_EQ(red(sheet.pixels(), x, y), expected) << x << ", " << y;
    }
  }
}

TEST(Sheet, LabelsStandInTheMiddleBelow) {
  const SheetLayout layout = layout_sheet(2, 41, 20, 2);
  Sheet sheet(layout);
  const std::uint8_t paper = red(sheet.pixels(), 0, 0);
  sheet.place(1, plain(41, 20, 0), "8");
  // The digit 8 is seven rows high and reaches as far to the left of the tile's middle as to the
  // right.
  const int middle = layout.tile_x(1) + 20, below = layout.tile_y(1) + 20;
  int inked = 0;
  for (int y = below; y < layout.height(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      if (red(sheet.pixels(), x, y) == paper) continue;
      ++inked;
      EXPECT_LE(std::abs(x - middle), 2);
      EXPECT_LT(y, below + layout.label_height());
      EXPECT_NE(red(sheet.pixels(), 2 * middle - x, y), paper);
    }
  }
  EXPECT_EQ(inked, 17);
}

TEST(Sheet, RefusesOtherSizesAndPlaces) {
  Sheet sheet(layout_sheet(2, 40, 20));
  EXPECT_THROW(sheet.place(0, plain(40, 21, 0), ""), Error);
  EXPECT_THROW(sheet.place(0, plain(41, 20, 0), ""), Error);
  EXPECT_THROW(sheet.place(2, plain(40, 20, 0), ""), Error);
  EXPECT_THROW(sheet.place(-1, plain(40, 20, 0), ""), Error);
}

TEST(SheetText, EveryDigitLooksDifferent) {
  std::vector<Pixels> drawn;
  for (const char digit : std::string_view("0123456789x")) {
    Pixels pixels = plain(10, 14, 0);
    draw_text(pixels, 0, 0, 2, {&digit, 1});
    for (const Pixels& other : drawn) EXPECT_NE(pixels.rgb, other.rgb) << digit;
    drawn.push_back(pixels);
  }
  EXPECT_EQ(text_columns(""), 0);
  EXPECT_EQ(text_columns("12"), 11);
}

TEST(SheetText, IsCutOffAtTheEdges) {
  Pixels pixels = plain(6, 4, 0);
  draw_text(pixels, -3, -2, 1, "888");
  EXPECT_EQ(pixels.rgb.size(), 72u);
  EXPECT_NE(pixels.rgb, plain(6, 4, 0).rgb);
}

}  // namespace
}  // namespace aerostat::image

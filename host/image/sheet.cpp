#include "image/sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::image {

namespace {

constexpr std::uint8_t kPaper = 24, kInk = 226;
constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

// Each row of a glyph is five bits, of which the highest is the leftmost.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;
constexpr Glyph kBox{0b11111, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11111};
constexpr std::array<Glyph, 10> kDigits{{
    {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110},
    {0b00100, 0b01100, 0b10100, 0b00100, 0b00100, 0b00100, 0b11111},
    {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111},
    {0b01110, 0b10001, 0b00001, 0b00110, 0b00001, 0b10001, 0b01110},
    {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010},
    {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110},
    {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110},
    {0b11111, 0b00001, 0b00010, 0b00010, 0b00100, 0b00100, 0b00100},
    {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110},
    {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100},
}};

const Glyph& glyph_of(char character) {
  const bool is_digit = character >= '0' && character <= '9';
  return is_digit ? kDigits[static_cast<std::size_t>(character - '0')] : kBox;
}

void fill(Pixels& pixels, int x0, int y0, int side) {
  for (int y = std::max(y0, 0); y < std::min(y0 + side, pixels.height); ++y) {
    for (int x = std::max(x0, 0); x < std::min(x0 + side, pixels.width); ++x) {
      const auto first = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                              static_cast<std::size_t>(x));
      std::fill_n(pixels.rgb.begin() + static_cast<std::ptrdiff_t>(first), 3, kInk);
    }
  }
}

/// Returns how far a sheet is from the ideal: the absolute logarithm of its shape against 16:9,
/// plus the share of places without a tile.
double flaw_of(const SheetLayout& layout) {
  const double shape = static_cast<double>(layout.width()) / layout.height();
  const int places = layout.columns * layout.rows();
  return std::abs(std::log(shape * 9.0 / 16.0)) +
         static_cast<double>(places - layout.count) / places;
}

}  // namespace

int SheetLayout::label_height() const {
  return (kGlyphHeight + 4) * letter;
}

int SheetLayout::width() const {
  return margin + columns * (tile_width + margin);
}

int SheetLayout::height() const {
  return margin + rows() * (tile_height + label_height() + margin);
}

int SheetLayout::tile_x(int index) const {
  return margin + index % columns * (tile_width + margin);
}

int SheetLayout::tile_y(int index) const {
  return margin + index / columns * (tile_height + label_height() + margin);
}

SheetLayout layout_sheet(int count, int tile_width, int tile_height, int columns) {
  SheetLayout layout{tile_width, tile_height, count, std::min(columns, count), 0, 1};
  layout.letter = std::clamp(tile_width / 160, 1, 8);
  layout.margin = 4 * layout.letter;
  if (columns > 0) return layout;
  SheetLayout best = layout;
  best.columns = 1;
  for (layout.columns = 2; layout.columns <= count; ++layout.columns) {
    if (flaw_of(layout) < flaw_of(best)) best = layout;
  }
  return best;
}

int text_columns(std::string_view text) {
  return text.empty() ? 0 : static_cast<int>(text.size()) * (kGlyphWidth + 1) - 1;
}

void draw_text(Pixels& pixels, int x, int y, int letter, std::string_view text) {
  for (const char character : text) {
    const Glyph& glyph = glyph_of(character);
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        const int bit = glyph[static_cast<std::size_t>(row)] >> (kGlyphWidth - 1 - column) & 1;
        if (bit != 0) fill(pixels, x + column * letter, y + row * letter, letter);
      }
    }
    x += (kGlyphWidth + 1) * letter;
  }
}

Sheet::Sheet(const SheetLayout& layout)
    : layout_(layout), pixels_{layout.width(), layout.height(), {}} {
  pixels_.rgb.assign(
      3 * static_cast<std::size_t>(pixels_.width) * static_cast<std::size_t>(pixels_.height),
      kPaper);
}

void Sheet::place(int index, const Pixels& tile, std::string_view label) {
  if (index < 0 || index >= layout_.count || tile.width != layout_.tile_width ||
      tile.height != layout_.tile_height) {
    throw Error(ErrorKind::internal, fmt::format("placing a tile of {} x {} pixels as number {} of "
                                                 "a sheet of {} of {} x {}",
                                                 tile.width, tile.height, index, layout_.count,
                                                 layout_.tile_width, layout_.tile_height));
  }
  const int x0 = layout_.tile_x(index), y0 = layout_.tile_y(index);
  const auto row_bytes = 3 * static_cast<std::size_t>(tile.width);
  for (int y = 0; y < tile.height; ++y) {
    const auto from = row_bytes * static_cast<std::size_t>(y);
    const auto to =
        3 * (static_cast<std::size_t>(y0 + y) * static_cast<std::size_t>(pixels_.width) +
             static_cast<std::size_t>(x0));
    std::copy_n(tile.rgb.begin() + static_cast<std::ptrdiff_t>(from), row_bytes,
                pixels_.rgb.begin() + static_cast<std::ptrdiff_t>(to));
  }
  const int label_x = x0 + (tile.width - text_columns(label) * layout_.letter) / 2;
  draw_text(pixels_, label_x, y0 + tile.height + 2 * layout_.letter, layout_.letter, label);
}

}  // namespace aerostat::image

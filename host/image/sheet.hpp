#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "image/write.hpp"

/// A sheet is one picture of many small ones, each with a label below it.
namespace aerostat::image {

/// The places of the tiles of a sheet. Lengths are in pixels. Tiles fill rows from the top left.
struct SheetLayout {
  int tile_width = 0, tile_height = 0;
  int count = 0;    // number of tiles
  int columns = 1;  // tiles across
  int margin = 0;   // width around and between tiles
  int letter = 1;   // side of a font pixel, in pixels

  int rows() const { return (count + columns - 1) / columns; }
  int label_height() const;
  int width() const;
  int height() const;
  /// These functions return the top left pixel of tile `index`. Its label fills label_height()
  /// rows under it.
  int tile_x(int index) const;
  int tile_y(int index) const;
};

/// Returns a layout for `count` tiles of the given size, all >= 1. If `columns` is 0, the number
/// of columns brings the sheet near 16:9 and leaves few places empty. There are never more
/// columns than tiles.
SheetLayout layout_sheet(int count, int tile_width, int tile_height, int columns = 0);

/// Returns the width of a text in font pixels: five for each character and one between
/// characters.
int text_columns(std::string_view text);

/// Draws the text with its top left corner at (x, y). A font pixel is `letter` pixels wide. Text
/// outside the picture is cut off. The font has digits only, and draws any other character as a
/// box.
void draw_text(Pixels& pixels, int x, int y, int letter, std::string_view text);

/// A sheet that is filled tile by tile.
class Sheet {
 public:
  explicit Sheet(const SheetLayout& layout);

  /// Puts a tile in its place and its label in the middle below. Throws Error{internal} if there
  /// is no such place or if the tile has another size.
  void place(int index, const Pixels& tile, std::string_view label);

  const Pixels& pixels() const { return pixels_; }

 private:
  SheetLayout layout_;
  Pixels pixels_;
};

}  // namespace aerostat::image

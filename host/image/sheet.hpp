#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "image/write.hpp"

/// Many small pictures on one, each with a label below.
namespace aerostat::image {

/// Where the tiles of a sheet lie. Lengths are pixels; tiles fill rows from the top left.
struct SheetLayout {
  int tile_width = 0, tile_height = 0;
  int count = 0;    // tiles
  int columns = 1;  // tiles across
  int margin = 0;   // around and between
  int letter = 1;   // side of a font pixel

  int rows() const { return (count + columns - 1) / columns; }
  int label_height() const;
  int width() const;
  int height() const;
  /// The top left pixel of tile `index`; its label fills label_height() rows under it.
  int tile_x(int index) const;
  int tile_y(int index) const;
};

/// A layout for `count` tiles of that size, all >= 1. `columns` 0 chooses as many as bring the
/// sheet near 16:9 with few places left empty; more columns than tiles are as many as tiles.
SheetLayout layout_sheet(int count, int tile_width, int tile_height, int columns = 0);

/// Columns that a text takes in font pixels: five a character, one between.
int text_columns(std::string_view text);

/// Draws the text with its top left corner at (x, y), a font pixel being `letter` pixels wide; what
/// leaves the picture is cut off. The font has digits; another character is a box.
void draw_text(Pixels& pixels, int x, int y, int letter, std::string_view text);

/// A sheet that is filled tile by tile.
class Sheet {
 public:
  explicit Sheet(const SheetLayout& layout);

  /// Puts a tile in its place, its label in the middle below. Throws Error{internal} if there is no
  /// such place or the tile has another size.
  void place(int index, const Pixels& tile, std::string_view label);

  const Pixels& pixels() const { return pixels_; }

 private:
  SheetLayout layout_;
  Pixels pixels_;
};

}  // namespace aerostat::image

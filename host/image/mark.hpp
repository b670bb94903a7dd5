#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Marks are short texts in picture files that say what a picture was made from.
namespace aerostat::image {

/// What a picture file tells about itself.
struct MarkedFile {
  bool is_whole = false;  // false: the file is damaged, cut off or no picture of this kind
  std::string mark;       // empty if the file has none
};

/// Puts a mark into a PNG file, as a tEXt chunk with the keyword "aerostat". The mark must be
/// ASCII. Throws Error{internal} if the bytes are no PNG.
void mark_png(std::vector<std::uint8_t>& png, const std::string& mark);

/// Reads the mark of a PNG file, and checks the checksums of all of its chunks.
MarkedFile mark_of_png(std::span<const std::uint8_t> png);

/// Reads the mark of an OpenEXR file that encode_exr wrote, and decodes all of its pixels to see
/// that they are whole.
MarkedFile mark_of_exr(std::span<const std::uint8_t> exr);

}  // namespace aerostat::image

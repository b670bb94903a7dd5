#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "asset/model.hpp"

namespace aerostat::artwork {

/// The size at which a drawing (SVG) becomes pixels. Pictures of pixels keep their own size.
struct DrawingSize {
  std::uint32_t width = 4096, height = 4096;
  /// Whether the drawing keeps its proportions within this size. Otherwise, it is stretched to it.
  bool keeps_proportions = true;

  auto operator<=>(const DrawingSize&) const = default;
};

/// The most pixels along a side of a picture, and the most bytes of its file.
inline constexpr std::uint32_t kMostPictureSide = 16'384;
inline constexpr std::uint64_t kMostPictureBytes = std::uint64_t{1} << 28;

/// A picture, and what its reader has to say.
struct Picture {
  asset::Texture texture;
  bool is_drawing = false;  // it was drawn from an SVG file
  std::vector<std::string> notes;
};

/// Reads a PNG, JPEG or SVG file. Throws Error{io} if it cannot be read, and Error{bad_data} with
/// its name if it is none of these, is damaged, or is larger than the limits. SVG files are drawn
/// by the program rsvg-convert of librsvg, which must be installed.
Picture read_picture(const std::filesystem::path& file, const DrawingSize& size);

}  // namespace aerostat::artwork

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "elevation/tiff_handle.hpp"
#include "elevation/tiff_samples.hpp"

namespace aerostat::elevation {

/// How the samples of a directory of a TIFF file are stored.
struct TiffLayout {
  int width = 0, height = 0;
  TiffSample sample = TiffSample::uint8;
  int bands = 1;
  int opacity = 0;           // the number of the band that tells what is transparent; 0: none
  bool bands_apart = false;  // each band has blocks of its own
  bool tiled = false;
  int block_width = 0, block_height = 0;  // of strips and tiles
  std::uint64_t block_bytes = 0;          // of a whole block, decoded
  int compression = 1;
  int photometric = 1;
  std::uint32_t subfile = 0;  // FILETYPE_ bits

  int blocks_across() const { return (width + block_width - 1) / block_width; }
  int blocks_down() const { return (height + block_height - 1) / block_height; }
  /// Samples from one of the first band to the next in a block.
  int stride() const { return bands_apart ? 1 : bands; }
};

/// Returns the layout of the directory of a handle. If it cannot be read, returns nothing and sets
/// `why` to the reason. Nothing that is read here depends on the size of the raster.
std::optional<TiffLayout> layout_of(const TiffHandle& handle, std::string& why);

/// Returns why samples of a layout cannot be heights, or an empty text.
std::string refusal_of_heights(const TiffLayout& layout);

/// Returns why samples of a layout cannot be codes of classes, or an empty text.
std::string refusal_of_codes(const TiffLayout& layout);

}  // namespace aerostat::elevation

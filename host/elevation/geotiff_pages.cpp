// The directories of a GeoTIFF file.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "elevation/geotiff_info.hpp"
#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

/// The most directories that are looked at. More levels of detail than that make no sense.
constexpr int kMostDirectories = 64;

/// Returns whether a page is the first one in fewer samples.
bool is_overview(const TiffLayout& page, const TiffLayout& main) {
  if (page.width >= main.width || page.height > main.height || page.bands != main.bands ||
      page.sample != main.sample) {
    return false;
  }
  // Writers round sizes up or down.
  const double across = static_cast<double>(main.width) / page.width;
  const double down = static_cast<double>(main.height) / page.height;
  return std::abs(main.width / down - page.width) <= 1.0 ||
         std::abs(main.height / across - page.height) <= 1.0;
}

void sort_in(const TiffHandle& handle, std::uint64_t directory, bool is_subfile, TiffPages& pages) {
  std::string why;
  const std::optional<TiffLayout> layout = layout_of(handle, why);
  if (!layout) return;
  const bool is_mask = (layout->subfile & FILETYPE_MASK) != 0;
  const bool is_reduced = is_subfile || (layout->subfile & FILETYPE_REDUCEDIMAGE) != 0;
  if (is_mask) {
    pages.masks.push_back({*layout, directory});
  } else if (is_reduced) {
    if (is_overview(*layout, pages.main.layout)) pages.overviews.push_back({*layout, directory});
  } else {
    ++pages.others;
  }
}

}  // namespace

TiffPages pages_of(TiffHandle& handle, std::string (*refusal)(const TiffLayout& layout)) {
  std::string why;
  const std::optional<TiffLayout> main = layout_of(handle, why);
  if (!main) refuse(handle.path(), why);
  const std::string reason = refusal(*main);
  if (!reason.empty()) refuse(handle.path(), reason);
  TIFF* const tiff = handle.get();
  TiffPages pages;
  pages.main = {*main, TIFFCurrentDirOffset(tiff)};
  std::vector<std::uint64_t> subfiles;
  std::uint16_t count = 0;
  std::uint64_t* offsets = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_SUBIFD, &count, &offsets) != 0 && offsets != nullptr) {
    subfiles.assign(offsets, offsets + std::min<int>(count, kMostDirectories));
  }
  for (int i = 1; i < kMostDirectories && TIFFReadDirectory(tiff) != 0; ++i) {
    sort_in(handle, TIFFCurrentDirOffset(tiff), false, pages);
  }
  for (const std::uint64_t offset : subfiles) {
    if (TIFFSetSubDirectory(tiff, offset) != 0) sort_in(handle, offset, true, pages);
  }
  std::sort(pages.overviews.begin(), pages.overviews.end(),
            [](const TiffPage& a, const TiffPage& b) { return a.layout.width > b.layout.width; });
  const auto same_width = [](const TiffPage& a, const TiffPage& b) {
    return a.layout.width == b.layout.width;
  };
  pages.overviews.erase(std::unique(pages.overviews.begin(), pages.overviews.end(), same_width),
                        pages.overviews.end());
  if (TIFFSetSubDirectory(tiff, pages.main.directory) == 0) {
    refuse(handle.path(), "the TIFF file is damaged: its first directory cannot be read again");
  }
  return pages;
}

}  // namespace aerostat::elevation

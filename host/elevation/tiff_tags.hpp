#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elevation/tiff_handle.hpp"

namespace aerostat::elevation {

/// The tags of GeoTIFF and of GDAL, which libtiff does not know by name.
inline constexpr std::uint32_t kTagPixelScale = 33550;
inline constexpr std::uint32_t kTagTiepoints = 33922;
inline constexpr std::uint32_t kTagTransformation = 34264;
inline constexpr std::uint32_t kTagGeoKeys = 34735;
inline constexpr std::uint32_t kTagGeoDoubles = 34736;
inline constexpr std::uint32_t kTagGeoTexts = 34737;
inline constexpr std::uint32_t kTagGdalMetadata = 42112;
inline constexpr std::uint32_t kTagGdalNodata = 42113;

/// Returns the numbers of a tag, or none if the file lacks it or it is of another type.
std::vector<double> doubles_of(const TiffHandle& handle, std::uint32_t tag);
std::vector<std::uint16_t> shorts_of(const TiffHandle& handle, std::uint32_t tag);
/// Returns the text of a tag, at most 1 MiB of it.
std::string text_of(const TiffHandle& handle, std::uint32_t tag);

}  // namespace aerostat::elevation

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elevation/raster.hpp"

namespace aerostat::elevation {

/// The layout of a file that holds nothing but samples.
struct RawLayout {
  int width = 0, height = 0;  // samples; 0: a square file
  std::string sample_type;    // "uint8", "int16", "uint16", "float32"...; empty: by the file's name
  bool big_endian = false;
  std::uint64_t header_bytes = 0;

  bool operator==(const RawLayout&) const = default;
};

/// What a user says of a file. It wins over what the file says.
struct OpenOptions {
  std::string crs;  // empty: as the file says
  std::optional<double> metres_per_unit;
  std::optional<double> nodata;  // as stored, before scale and unit
  /// The heights in metres of the lowest and the highest value that an image can store.
  std::optional<std::array<double, 2>> image_heights_m;
  std::optional<double> cell_m;  // distance of samples, for files that do not give a place
  std::string encoding;          // "", "terrarium" or "terrain-rgb" for images of tiles
  std::string variable;          // of a file that holds several rasters; empty: by its name
  RawLayout raw;
  bool codes = false;  // samples are codes of classes: palettes are read, units and scales are not

  bool operator==(const OpenOptions&) const = default;
};

/// The most samples along a side, and the most of all, that a raster may have.
inline constexpr int kMostSamplesASide = 1 << 20;
inline constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 34;
/// The most samples of a file that has to be read as a whole.
inline constexpr std::uint64_t kMostSamplesInMemory = std::uint64_t{1} << 28;

/// Returns whether a file looks like one of heights. Folders do, and files that cannot be read do
/// not.
bool is_elevation(const std::filesystem::path& path);

/// Opens a file of heights. Its content decides of which format it is, apart from formats without
/// any mark, which its name decides. Throws Error{io} if the file cannot be read, and
/// Error{bad_data} with the file's name, what was found and which option helps.
std::unique_ptr<Raster> open(const std::filesystem::path& path, const OpenOptions& options = {});

/// Returns the files of a folder whose names end as files of heights do, sorted by name. Only
/// regular files count, and folders in it are left aside. Images count only if there is nothing
/// else, because they may be previews. Throws Error{io} if the folder cannot be read, and
/// Error{bad_data} if it has none or more than 4096.
std::vector<std::filesystem::path> elevation_files_in(const std::filesystem::path& folder);

}  // namespace aerostat::elevation

#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/math.hpp"

/// Rasters of heights from files.
namespace aerostat::elevation {

/// Where the samples of a raster lie. The centre of the sample in column i and row j is at
/// origin + i * per_column + j * per_row, as (east, north) or (longitude, latitude) in the units of
/// the coordinate reference system.
struct Georeference {
  std::string crs;  // a text for geo::crs_info, or empty if the file does not say
  dvec2 origin{0.0};
  dvec2 per_column{1.0, 0.0};
  dvec2 per_row{0.0, -1.0};
};

/// What is known of a raster before its samples are read.
struct RasterInfo {
  std::filesystem::path path;
  std::string format;       // for messages, for example "GeoTIFF"
  std::string sample_type;  // of the file, for example "int16"
  int width = 0;            // samples along a row
  int height = 0;           // rows
  /// Missing if the file says nothing of its place, and nothing could be told from its name.
  std::optional<Georeference> georeference;
  std::string vertical_datum;    // for messages, for example "EGM96 height"; empty if unknown
  double metres_per_unit = 1.0;  // of the heights in the file
  std::string unit = "metre";    // name of that unit
  /// Whole sentences for the user: what was guessed, and what was mended.
  std::vector<std::string> notes;
};

/// A rectangle of samples.
struct Window {
  int column = 0, row = 0;  // of its first sample
  int width = 0, height = 0;
};

/// A raster of heights in a file. It is read part by part, so that a large file costs no more
/// memory than what is asked for. It may be used from any thread.
class Raster {
 public:
  virtual ~Raster() = default;

  const RasterInfo& info() const { return info_; }

  /// Returns the factors by which the file's reduced versions (overviews) are coarser than the
  /// raster, finest first. It is empty if there is none.
  virtual std::vector<double> overview_factors() const { return {}; }

  /// Reads the heights of a window in metres, row by row. A sample without a height (a void) is
  /// NaN. The window must lie in the raster. Throws Error{bad_data} with the file's name if the
  /// file is damaged.
  virtual void read(const Window& window, float* heights) const = 0;

  /// Reads a window of the overview of a number in overview_factors(). The window counts in samples
  /// of the overview.
  virtual void read_overview(int overview, const Window& window, float* heights) const;

  /// Returns the width and height in samples of an overview.
  virtual std::array<int, 2> overview_size(int overview) const;

 protected:
  explicit Raster(RasterInfo info) : info_(std::move(info)) {}
  RasterInfo info_;
};

/// A raster whose heights are all in memory. Simple formats are read as a whole.
class MemoryRaster final : public Raster {
 public:
  /// Takes info.width * info.height heights in metres, row by row; voids are NaN.
  MemoryRaster(RasterInfo info, std::vector<float> heights);

  void read(const Window& window, float* heights) const override;

 private:
  std::vector<float> heights_;
};

}  // namespace aerostat::elevation

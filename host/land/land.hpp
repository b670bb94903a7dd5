#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "elevation/open.hpp"
#include "geo/place.hpp"
#include "land/mosaic.hpp"
#include "land/pyramid.hpp"

/// Real land: the heights of one or more files, and where they lie.
namespace aerostat::land {

/// What is asked of the files.
struct LandOptions {
  std::vector<std::filesystem::path> sources;  // files, and folders of them
  elevation::OpenOptions open;
  float sea_depth_m = 0.0f;  // see PyramidOptions
  bool inland_water = true;  // whether level areas are lakes and rivers

  bool operator==(const LandOptions&) const = default;
};

/// A point by its place on the Earth, or by coordinates of the files' own system.
struct LandPoint {
  std::optional<geo::Place> place;
  dvec2 own{0.0};  // easting and northing, or columns and rows without a georeference

  bool operator==(const LandPoint&) const = default;
};

/// Some samples along the way of a local frame.
struct LandSamples {
  std::span<const float> east_m, south_m;  // from the middle of the frame
  std::span<const float> spacing_m;        // distance to neighbouring samples
  std::span<float> height_m;               // over the files' zero, without curvature
  std::span<float> slope_east, slope_south;
  std::span<float> outside_m = {};  // distance from the nearest file, 0 inside; may be left out
};

/// Places in a local frame, and the water there.
struct WaterSamples {
  std::span<const float> east_m, south_m;  // from the middle of the frame
  std::span<const float> spacing_m;        // distance to neighbouring samples
  std::span<float> level_m;                // height of the nearest water, NaN if none is near
  std::span<float> shore_m;  // distance from its shore: positive on water, negative on land
};

/// A lake or a reach of a river.
struct InlandWater {
  float level_m = 0.0f;
  double area_m2 = 0.0;
};

class LocalLand;

/// The files of a scene. It never changes and may be used from any thread.
class Land {
 public:
  /// Opens the files. Throws the errors of open(), and Error{bad_data} if the files cannot be used
  /// together.
  explicit Land(const LandOptions& options);
  ~Land();

  /// Whole sentences for the user: what was guessed, mended or stands out.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The rasters, of which each may join several files.
  const std::vector<std::unique_ptr<Pyramid>>& pyramids() const { return pyramids_; }
  const std::vector<elevation::RasterInfo>& files() const { return files_; }

  /// Returns whether the files say where on the Earth they lie.
  bool has_place() const { return has_place_; }

  /// The middle of the first raster.
  const LandPoint& middle() const { return middle_; }

  /// The width and height of the area of all rasters in metres, about.
  const dvec2& size_m() const { return size_m_; }

  /// The distance of samples of the first raster in metres.
  double cell_m() const { return cell_m_; }

  float lowest_m() const { return lowest_m_; }
  float highest_m() const { return highest_m_; }

  /// Returns whether a sea at 0 m is in the files: much of their area is at 0 m or below it, but
  /// not all of it.
  bool has_sea() const { return has_sea_; }

  /// The lakes and reaches of rivers that were found.
  const std::vector<InlandWater>& waters() const { return waters_; }

  /// Returns the land around a point, in a local frame that reaches `reach_m` from it. The land
  /// must live as long as the result.
  std::shared_ptr<const LocalLand> around(const LandPoint& point, double reach_m) const;

 private:
  void find_extent();
  void add_waters(const Pyramid& pyramid, double sample_m2);
  void find_sea();
  void tell_what_stands_out();

  std::vector<std::string> notes_;
  std::vector<elevation::RasterInfo> files_;
  std::vector<std::unique_ptr<Pyramid>> pyramids_;
  std::vector<InlandWater> waters_;
  LandPoint middle_;
  dvec2 size_m_{0.0};
  double cell_m_ = 1.0;
  float lowest_m_ = 0.0f, highest_m_ = 0.0f;
  bool has_place_ = false, has_sea_ = false;
};

/// Land in a local frame: metres to the east and to the south of a point.
class LocalLand {
 public:
  LocalLand(const Land& land, const LandPoint& point, double reach_m);
  ~LocalLand();

  /// Computes heights and slopes without detail that is finer than the spacing of the samples.
  void sample(const LandSamples& samples) const;

  /// Returns whether there are lakes or rivers.
  bool has_water() const;

  /// Finds lakes and rivers, without detail that is finer than the spacing of the samples.
  void find_water(const WaterSamples& samples) const;

  /// Returns whether a file has a height at a point of the frame.
  bool is_known(double east_m, double south_m) const;

 private:
  class Lattice;

  std::vector<std::unique_ptr<Lattice>> lattices_;
};

}  // namespace aerostat::land

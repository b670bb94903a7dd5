#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/land_cover.hpp"
#include "land/cover_codes.hpp"
#include "land/land.hpp"
#include "land/nested_levels.hpp"

/// Land cover over the land.
namespace aerostat::land {

/// The least and the most texels along a side of a level, and the most levels. Together they bound
/// the memory of land cover, whatever the size of its file: 48 MiB, and as much for water.
inline constexpr int kLeastCoverSide = 256, kMostCoverSide = 1024, kMostCoverLevels = 12;

/// What is asked of land cover.
struct CoverOptions {
  std::filesystem::path file;
  std::string crs;  // empty: as the file says
  CoverScheme scheme = CoverScheme::automatic;
  CoverCodes classes;    // of codes that the scheme does not know
  LandPoint middle;      // the middle of the local frame
  double reach_m = 0.0;  // half of the side of the square around it that is looked at

  bool operator==(const CoverOptions&) const = default;
};

/// A raster of classes in the local frame. Codes are never averaged: a texel holds the shares of
/// the classes among the raster's cells. It never changes and may be used from any thread.
class Cover {
 public:
  /// Reads the raster as far as it lies within reach. Throws the errors of elevation::open(), and
  /// Error{bad_data} if it lies elsewhere, its system is unknown or a code has no class.
  explicit Cover(const CoverOptions& options);

  /// The shares of the classes of ground. A texel has four bits for each class, that of woods the
  /// lowest ones, which count 15ths. Water counts as wetland, because that is how water looks that
  /// is too narrow to be shown.
  const NestedLevels& ground() const { return ground_; }

  /// Returns the shares at a point of the local frame, filtered over a footprint in metres.
  CoverShares at(double east_m, double south_m, double footprint_m) const;

  /// Returns whether there is water.
  bool has_water() const { return !water_.texels.empty(); }

  /// Returns the share of water at a point, filtered over a footprint. There must be water.
  float water_at(double east_m, double south_m, double footprint_m) const;

  /// Whole sentences for the user.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  NestedLevels ground_, water_;
  std::vector<std::string> notes_;
};

/// Returns the shares in a texel.
CoverShares shares_of_texel(std::uint32_t texel);
/// Returns the texel of shares.
std::uint32_t packed_shares(const CoverShares& shares);

}  // namespace aerostat::land

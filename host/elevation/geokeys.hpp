#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aerostat::elevation {

/// Numbers of keys, as in OGC 19-008 (GeoTIFF 1.1).
enum GeoKey : std::uint16_t {
  kModelType = 1024,
  kRasterType = 1025,
  kCitation = 1026,
  kGeographicType = 2048,
  kGeogCitation = 2049,
  kGeodeticDatum = 2050,
  kPrimeMeridian = 2051,
  kAngularUnits = 2054,
  kAngularUnitSize = 2055,
  kEllipsoid = 2056,
  kSemiMajorAxis = 2057,
  kSemiMinorAxis = 2058,
  kInverseFlattening = 2059,
  kPrimeMeridianLongitude = 2061,
  kToWgs84 = 2062,
  kProjectedType = 3072,
  kProjectedCitation = 3073,
  kProjection = 3074,
  kMethod = 3075,
  kLinearUnits = 3076,
  kLinearUnitSize = 3077,
  kParallel1 = 3078,
  kParallel2 = 3079,
  kAzimuth = 3094,
  kRectifiedAngle = 3096,
  kVerticalType = 4096,
  kVerticalCitation = 4097,
  kVerticalUnits = 4099
};
/// The code of a key for something that other keys describe.
inline constexpr int kUserDefined = 32767;

/// The keys by which a GeoTIFF file describes its coordinate reference system.
class GeoKeys {
 public:
  GeoKeys() = default;
  /// Takes the contents of the three tags. Keys that do not lie in them are left out.
  GeoKeys(const std::vector<std::uint16_t>& directory, const std::vector<double>& doubles,
          const std::string& texts);

  bool empty() const { return numbers_.empty() && texts_.empty(); }
  /// Returns the code of a key, or 0 if it is missing or undefined.
  int code(std::uint16_t key) const;
  /// Returns the number of the first of some keys that is there.
  std::optional<double> number(std::initializer_list<std::uint16_t> keys) const;
  std::vector<double> numbers(std::uint16_t key) const;
  /// Returns a text without the bar that ends it, or an empty one.
  std::string text(std::uint16_t key) const;

 private:
  std::map<std::uint16_t, std::vector<double>> numbers_;
  std::map<std::uint16_t, std::string> texts_;
};

/// The coordinate reference system and the level of heights that geokeys name.
struct GeoKeyCrs {
  std::string crs;  // a text that geo::crs_info understands, or empty
  /// What to multiply coordinates by, for files whose coordinates are in another unit than their
  /// system's.
  double coordinate_factor = 1.0;
  bool pixel_is_point = false;
  std::string vertical_datum;      // name, or empty
  double metres_per_unit = 0.0;    // of the vertical system; 0: not said
  std::vector<std::string> notes;  // whole sentences
};
GeoKeyCrs crs_of(const GeoKeys& keys);

/// Returns WKT of the system that keys describe by parameters, or an empty text if they describe
/// none that is known.
std::string wkt_of(const GeoKeys& keys);

/// Returns the length in metres of a unit with a code of EPSG, or 0 if it is unknown.
double metres_of_unit_code(int code);

}  // namespace aerostat::elevation

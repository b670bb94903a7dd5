#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/math.hpp"
#include "geo/place.hpp"

/// Coordinates on the Earth, by the library PROJ. It uses neither the network nor grids that are
/// not installed.
namespace aerostat::geo {

/// What is known of a coordinate reference system.
struct CrsInfo {
  std::string name;                       // for messages, for example "WGS 84 / UTM zone 32N"
  bool geographic = false;                // coordinates are degrees
  double metres_per_unit = 1.0;           // of projected coordinates
  std::string vertical_name;              // of a compound system, else empty
  double vertical_metres_per_unit = 0.0;  // 0 if there is no vertical system
};

/// Returns what is known of a coordinate reference system. `crs` is a code such as "EPSG:32632",
/// WKT or a PROJ string such as "+proj=utm +zone=32". Throws Error{bad_data} with `crs` (shortened)
/// and the reason if PROJ does not know it, or if it is neither geographic nor projected. Names of
/// files and URLs are refused.
CrsInfo crs_info(const std::string& crs);

/// Returns the WKT 1 of a geographic system, as other WKT can contain it. Throws Error{bad_data} as
/// crs_info() does, or if `crs` is not geographic.
std::string geographic_wkt(const std::string& crs);

/// Returns the EPSG code of the geographic or projected system that `crs` is or contains, or 0 if
/// it has none. Throws Error{bad_data} as crs_info() does.
int epsg_code(const std::string& crs);

/// Returns that system as WKT of ESRI's kind, which a .prj file holds. Throws Error{bad_data} as
/// crs_info() does, or if it cannot be written so.
std::string esri_wkt(const std::string& crs);

/// Transforms coordinates between a coordinate reference system and the local frame of a scene. The
/// local frame is a transverse Mercator projection on WGS 84 that is true to scale at `middle`:
/// x is metres to the east and y is metres to the south. Horizontal coordinates of any system come
/// as (east, north), or as (longitude, latitude) in degrees, whatever order its authority gives
/// them. An object may be used by one thread at a time; copies may not share a thread's work, so
/// each thread makes its own.
class Transform {
 public:
  /// Throws Error{bad_data} as crs_info() does, or if PROJ knows no way between the system and
  /// `middle`. Of several ways, it takes one for all points: the best one at `middle` whose grids
  /// are installed.
  Transform(const std::string& crs, const Place& middle);
  ~Transform();
  Transform(Transform&&) noexcept;
  Transform& operator=(Transform&&) noexcept;

  /// Turns points of the system into points of the local frame. Points that have no counterpart
  /// become NaN.
  void to_local(std::span<dvec2> points) const;

  /// Turns points of the local frame into points of the system. Points that have no counterpart
  /// become NaN. Longitudes are within 180 degrees of that of `middle`, so that they do not jump
  /// where the Earth's longitudes begin again.
  void from_local(std::span<dvec2> points) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the place of a point of a coordinate reference system. Its longitude is between -180 and
/// 180 degrees. Throws Error{bad_data} if the point has no place.
Place place_of(const std::string& crs, const dvec2& point);

/// Returns the point of the local frame around `middle` that a place has, x to the east and y to
/// the south in metres.
dvec2 local_point(const Place& middle, const Place& place);

/// Returns the place of a point of the local frame around `middle`.
Place place_of_local(const Place& middle, const dvec2& point);

/// Returns by how many metres the ground lies below the plane that touches the Earth `distance_m`
/// away, as light shows it: d^2 (1 - k) / 2 R with kRefraction and kEarthRadius_m.
double curvature_drop(double distance_m);

}  // namespace aerostat::geo

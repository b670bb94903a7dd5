#include <cstddef>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geo/proj_objects.hpp"
#include "geo/transform.hpp"

namespace aerostat::geo {
namespace {

std::string name_of(const PJ* object) {
  const char* name = object == nullptr ? nullptr : proj_get_name(object);
  return name == nullptr ? "" : name;
}

/// Returns the system of which a bound one consists, apart from its shift of datum.
ProjObject unbound(PJ_CONTEXT* context, ProjObject crs) {
  while (crs && proj_get_type(crs.get()) == PJ_TYPE_BOUND_CRS) {
    crs.reset(proj_get_source_crs(context, crs.get()));
  }
  return crs;
}

/// Returns the size of the unit of an axis in metres, or in radians for angles, or 0.
double unit_of_axis(PJ_CONTEXT* context, const PJ* crs, int axis) {
  const ProjObject system(proj_crs_get_coordinate_system(context, crs));
  double unit = 0.0;
  if (!system || proj_cs_get_axis_info(context, system.get(), axis, nullptr, nullptr, nullptr,
                                       &unit, nullptr, nullptr, nullptr) == 0) {
    return 0.0;
  }
  return unit;
}

CrsInfo look_up(const std::string& crs) {
  const ProjContext context;
  const ProjObject whole = context.crs(crs);
  const ProjObject plane = unbound(context.get(), context.horizontal(whole, crs));
  CrsInfo info;
  info.name = name_of(plane.get());
  info.geographic = proj_get_type(plane.get()) != PJ_TYPE_PROJECTED_CRS;
  if (!info.geographic) info.metres_per_unit = unit_of_axis(context.get(), plane.get(), 0);
  if (!(info.metres_per_unit > 0.0)) info.metres_per_unit = 1.0;
  const ProjObject body =
      unbound(context.get(), ProjObject(proj_clone(context.get(), whole.get())));
  const PJ_TYPE type = proj_get_type(body.get());
  if (type == PJ_TYPE_COMPOUND_CRS) {
    const ProjObject heights =
        unbound(context.get(), ProjObject(proj_crs_get_sub_crs(context.get(), body.get(), 1)));
    info.vertical_name = name_of(heights.get());
    info.vertical_metres_per_unit = unit_of_axis(context.get(), heights.get(), 0);
  } else if (const double unit = unit_of_axis(context.get(), body.get(), 2); unit > 0.0) {
    info.vertical_name = "ellipsoidal height of " + info.name;
    info.vertical_metres_per_unit = unit;
  }
  return info;
}

}  // namespace

CrsInfo crs_info(const std::string& crs) {
  // Rasters of one scene share a few systems, and each look-up opens the database of PROJ.
  constexpr std::size_t kMostKept = 64;
  static std::mutex mutex;
  static std::map<std::string, CrsInfo> kept;
  {
    const std::lock_guard lock(mutex);
    if (const auto at = kept.find(crs); at != kept.end()) return at->second;
  }
  CrsInfo info = look_up(crs);
  const std::lock_guard lock(mutex);
  if (kept.size() >= kMostKept) kept.clear();
  kept[crs] = info;
  return info;
}

std::string geographic_wkt(const std::string& crs) {
  const ProjContext context;
  const ProjObject whole = context.crs(crs);
  const ProjObject plane = context.horizontal(whole, crs);
  const char* const wkt = crs_info(crs).geographic
                              ? proj_as_wkt(context.get(), plane.get(), PJ_WKT1_GDAL, nullptr)
                              : nullptr;
  if (wkt == nullptr) {
    throw Error(
        ErrorKind::bad_data,
        fmt::format("the coordinate reference system \"{}\" is not geographic", shortened(crs)));
  }
  return wkt;
}

int epsg_code(const std::string& crs) {
  const ProjContext context;
  const ProjObject whole = context.crs(crs);
  const ProjObject plane = unbound(context.get(), context.horizontal(whole, crs));
  const char* const authority = proj_get_id_auth_name(plane.get(), 0);
  const char* const code = proj_get_id_code(plane.get(), 0);
  if (authority == nullptr || code == nullptr || std::string(authority) != "EPSG") return 0;
  return std::atoi(code);
}

std::string esri_wkt(const std::string& crs) {
  const ProjContext context;
  const ProjObject whole = context.crs(crs);
  const ProjObject plane = unbound(context.get(), context.horizontal(whole, crs));
  const char* const options[] = {"MULTILINE=NO", nullptr};
  const char* const wkt = proj_as_wkt(context.get(), plane.get(), PJ_WKT1_ESRI, options);
  if (wkt == nullptr) {
    throw Error(ErrorKind::bad_data,
                fmt::format("the coordinate reference system \"{}\" has no form as ESRI's WKT",
                            shortened(crs)));
  }
  return wkt;
}

}  // namespace aerostat::geo

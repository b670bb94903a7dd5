// WKT of coordinate reference systems that geokeys describe by parameters.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/geokeys.hpp"
#include "geo/transform.hpp"

namespace aerostat::elevation {
namespace {

/// A method of projection. The names are those of WKT 1 as GDAL writes it, null for parameters that
/// a method does not have.
struct Method {
  int code;  // of the key kMethod
  const char* name;
  const char* latitude;   // of the origin
  const char* longitude;  // of the origin
  const char* scale;
  int parallels;  // number of standard parallels
  bool azimuth;
};

constexpr const char* kLatitude0 = "latitude_of_origin";
constexpr const char* kLatitudeC = "latitude_of_center";
constexpr const char* kMeridian = "central_meridian";
constexpr const char* kLongitudeC = "longitude_of_center";
constexpr const char* kScale = "scale_factor";

constexpr std::array kMethods{
    Method{1, "Transverse_Mercator", kLatitude0, kMeridian, kScale, 0, false},
    Method{3, "Hotine_Oblique_Mercator", kLatitudeC, kLongitudeC, kScale, 0, true},
    Method{5, "Hotine_Oblique_Mercator_Azimuth_Center", kLatitudeC, kLongitudeC, kScale, 0, true},
    Method{9815, "Hotine_Oblique_Mercator_Azimuth_Center", kLatitudeC, kLongitudeC, kScale, 0,
           true},
    Method{7, "Mercator_1SP", kLatitude0, kMeridian, kScale, 0, false},
    Method{8, "Lambert_Conformal_Conic_2SP", kLatitude0, kMeridian, nullptr, 2, false},
    Method{9, "Lambert_Conformal_Conic_1SP", kLatitude0, kMeridian, kScale, 0, false},
    Method{10, "Lambert_Azimuthal_Equal_Area", kLatitudeC, kLongitudeC, nullptr, 0, false},
    Method{11, "Albers_Conic_Equal_Area", kLatitudeC, kLongitudeC, nullptr, 2, false},
    Method{12, "Azimuthal_Equidistant", kLatitudeC, kLongitudeC, nullptr, 0, false},
    Method{13, "Equidistant_Conic", kLatitudeC, kLongitudeC, nullptr, 2, false},
    Method{14, "Stereographic", kLatitude0, kMeridian, kScale, 0, false},
    Method{15, "Polar_Stereographic", kLatitude0, kMeridian, kScale, 0, false},
    Method{16, "Oblique_Stereographic", kLatitude0, kMeridian, kScale, 0, false},
    Method{17, "Equirectangular", kLatitude0, kMeridian, nullptr, 1, false},
    Method{18, "Cassini_Soldner", kLatitude0, kMeridian, nullptr, 0, false},
    Method{19, "Gnomonic", kLatitude0, kMeridian, nullptr, 0, false},
    Method{20, "Miller_Cylindrical", kLatitudeC, kLongitudeC, nullptr, 0, false},
    Method{21, "Orthographic", kLatitude0, kMeridian, nullptr, 0, false},
    Method{22, "Polyconic", kLatitude0, kMeridian, nullptr, 0, false},
    Method{23, "Robinson", nullptr, kLongitudeC, nullptr, 0, false},
    Method{24, "Sinusoidal", nullptr, kLongitudeC, nullptr, 0, false},
    Method{25, "VanDerGrinten", nullptr, kMeridian, nullptr, 0, false},
    Method{26, "New_Zealand_Map_Grid", kLatitude0, kMeridian, nullptr, 0, false},
    Method{27, "Transverse_Mercator_South_Orientated", kLatitude0, kMeridian, kScale, 0, false},
    Method{28, "Cylindrical_Equal_Area", nullptr, kMeridian, nullptr, 1, false},
};

struct Ellipsoid {
  int code;
  const char* name;
  double semi_major_m, inverse_flattening;
};
constexpr std::array kEllipsoids{
    Ellipsoid{7030, "WGS 84", 6378137.0, 298.257223563},
    Ellipsoid{7019, "GRS 1980", 6378137.0, 298.257222101},
    Ellipsoid{7043, "WGS 72", 6378135.0, 298.26},
    Ellipsoid{7004, "Bessel 1841", 6377397.155, 299.1528128},
    Ellipsoid{7022, "International 1924", 6378388.0, 297.0},
    Ellipsoid{7008, "Clarke 1866", 6378206.4, 294.978698213898},
    Ellipsoid{7012, "Clarke 1880 (RGS)", 6378249.145, 293.465},
    Ellipsoid{7011, "Clarke 1880 (IGN)", 6378249.2, 293.466021293627},
    Ellipsoid{7001, "Airy 1830", 6377563.396, 299.3249646},
    Ellipsoid{7002, "Airy Modified 1849", 6377340.189, 299.3249646},
    Ellipsoid{7024, "Krassowsky 1940", 6378245.0, 298.3},
    Ellipsoid{7003, "Australian National Spheroid", 6378160.0, 298.25},
    Ellipsoid{7036, "GRS 1967", 6378160.0, 298.247167427},
    Ellipsoid{7048, "GRS 1980 Authalic Sphere", 6371007.0, 0.0},
};

/// Returns a text of a file without what would end a text of WKT.
std::string plain(std::string text, const char* otherwise) {
  text.resize(std::min<std::size_t>(text.size(), 60));
  text.erase(std::remove_if(text.begin(), text.end(),
                            [](char c) { return c == '"' || c < ' ' || c > '~'; }),
             text.end());
  return text.empty() ? otherwise : text;
}

/// Returns the WKT of a geographic system with a code, or an empty text if PROJ does not know it.
std::string geographic_of_code(int code) {
  try {
    return geo::geographic_wkt(fmt::format("EPSG:{}", code));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) throw;
    return "";
  }
}

/// Returns the WKT of the ellipsoid that keys describe. Without any, it is that of WGS 84.
std::string spheroid_of(const GeoKeys& keys) {
  Ellipsoid ellipsoid = kEllipsoids.front();
  const int code = keys.code(kEllipsoid);
  for (const Ellipsoid& known : kEllipsoids) {
    if (known.code == code) ellipsoid = known;
  }
  const std::optional<double> a = keys.number({kSemiMajorAxis});
  const std::optional<double> b = keys.number({kSemiMinorAxis});
  const std::optional<double> rf = keys.number({kInverseFlattening});
  if (a && (rf || b)) {
    ellipsoid.semi_major_m = *a;
    ellipsoid.inverse_flattening = rf.value_or(*a == b.value_or(*a) ? 0.0 : *a / (*a - *b));
    ellipsoid.name = "unnamed";
    for (const Ellipsoid& known : kEllipsoids) {
      if (std::abs(known.semi_major_m - *a) < 1e-3 &&
          std::abs(known.inverse_flattening - ellipsoid.inverse_flattening) < 1e-6) {
        ellipsoid = known;
      }
    }
  }
  return fmt::format("SPHEROID[\"{}\",{:.17g},{:.17g}]", ellipsoid.name, ellipsoid.semi_major_m,
                     ellipsoid.inverse_flattening);
}

std::string geographic_wkt_of(const GeoKeys& keys) {
  const int type = keys.code(kGeographicType), datum = keys.code(kGeodeticDatum);
  // The geographic system of a datum of EPSG has the code of the datum less 2000.
  for (const int code : {type, datum >= 6001 && datum < kUserDefined ? datum - 2000 : 0}) {
    if (code <= 0 || code == kUserDefined) continue;
    std::string wkt = geographic_of_code(code);
    if (!wkt.empty()) return wkt;
  }
  const std::string spheroid = spheroid_of(keys);
  const std::vector<double> shift = keys.numbers(kToWgs84);
  const double meridian_deg = keys.number({kPrimeMeridianLongitude}).value_or(0.0);
  if (shift.empty() && meridian_deg == 0.0) {
    if (spheroid.find("WGS 84") != std::string::npos) return geographic_of_code(4326);
    if (spheroid.find("GRS 1980\"") != std::string::npos) return geographic_of_code(4258);
  }
  std::string to_wgs84;
  if (shift.size() == 3 || shift.size() == 7) {
    for (std::size_t i = 0; i < 7; ++i) {
      to_wgs84 +=
          fmt::format("{}{:.17g}", i == 0 ? ",TOWGS84[" : ",", i < shift.size() ? shift[i] : 0.0);
    }
    to_wgs84 += ']';
  }
  const std::string name = plain(keys.text(kGeogCitation), "unnamed");
  return fmt::format(
      "GEOGCS[\"{}\",DATUM[\"{}\",{}{}],PRIMEM[\"{}\",{:.17g}],UNIT[\"degree\",{:.17g}]]", name,
      name, spheroid, to_wgs84, meridian_deg == 0.0 ? "Greenwich" : "unnamed", meridian_deg,
      std::numbers::pi / 180.0);
}

/// Returns the length of the unit of projected coordinates in metres, or 0 if it is unknown.
double linear_unit_of(const GeoKeys& keys) {
  const int code = keys.code(kLinearUnits);
  if (code == kUserDefined) return keys.number({kLinearUnitSize}).value_or(0.0);
  return code == 0 ? 1.0 : metres_of_unit_code(code);
}

std::string parameter(const char* name, double value) {
  return fmt::format(",PARAMETER[\"{}\",{:.17g}]", name, value);
}

/// Returns the parameters of a method. Writers of files differ in which key of an origin they use.
std::string parameters_of(const Method& method, const GeoKeys& keys, double degrees_per_unit) {
  const auto angle = [&](std::initializer_list<std::uint16_t> names, double otherwise) {
    const std::optional<double> value = keys.number(names);
    return value ? *value * degrees_per_unit : otherwise;
  };
  std::string text;
  if (method.parallels > 0) text += parameter("standard_parallel_1", angle({kParallel1}, 0.0));
  if (method.parallels > 1) text += parameter("standard_parallel_2", angle({kParallel2}, 0.0));
  if (method.latitude) {
    // Some files give the latitude of the origin of a polar projection as its standard parallel.
    const bool is_polar = method.code == 15 && !keys.number({3081, 3085, 3089});
    const double latitude = is_polar ? angle({kParallel1}, 90.0) : angle({3081, 3085, 3089}, 0.0);
    text += parameter(method.latitude, latitude);
  }
  if (method.longitude) text += parameter(method.longitude, angle({3080, 3084, 3088, 3095}, 0.0));
  if (method.azimuth) {
    text += parameter("azimuth", angle({kAzimuth}, 90.0));
    text += parameter("rectified_grid_angle", angle({kRectifiedAngle}, 90.0));
  }
  if (method.scale) text += parameter(method.scale, keys.number({3092, 3093}).value_or(1.0));
  text += parameter("false_easting", keys.number({3082, 3086, 3090}).value_or(0.0));
  text += parameter("false_northing", keys.number({3083, 3087, 3091}).value_or(0.0));
  return text;
}

/// Returns the method that keys name. UTM may be named by a code of its own.
const Method* method_of(const GeoKeys& keys) {
  const int code = keys.code(kMethod);
  const auto at = std::find_if(kMethods.begin(), kMethods.end(),
                               [code](const Method& method) { return method.code == code; });
  return at == kMethods.end() ? nullptr : &*at;
}

std::string utm_parameters(int projection) {
  const bool south = projection > 16100;
  const int zone = projection - (south ? 16100 : 16000);
  return parameter(kLatitude0, 0.0) + parameter(kMeridian, 6.0 * zone - 183.0) +
         parameter(kScale, 0.9996) + parameter("false_easting", 500000.0) +
         parameter("false_northing", south ? 10000000.0 : 0.0);
}

}  // namespace

double metres_of_unit_code(int code) {
  switch (code) {
    case 9001:
      return 1.0;
    case 9002:
      return 0.3048;
    case 9003:
      return 1200.0 / 3937.0;
    case 9005:
      return 0.3047972654;  // Clarke's foot
    case 9014:
      return 1.8288;  // fathom
    case 9030:
      return 1852.0;  // nautical mile
    case 9036:
      return 1000.0;
    case 9084:
      return 0.3047995102;  // Sears's foot (1922)
    case 1025:
      return 0.001;
    case 1033:
      return 0.01;
    default:
      return 0.0;
  }
}

std::string wkt_of(const GeoKeys& keys) {
  const int projection = keys.code(kProjection);
  const bool is_utm =
      (projection > 16000 && projection <= 16060) || (projection > 16100 && projection <= 16160);
  const Method* method = is_utm ? &kMethods.front() : method_of(keys);
  const std::string base = geographic_wkt_of(keys);
  const bool is_projected = keys.code(kModelType) == 1 || keys.code(kMethod) != 0;
  if (!is_projected) return keys.code(kModelType) == 2 ? base : "";
  const double unit = linear_unit_of(keys);
  if (method == nullptr || base.empty() || !(unit > 0.0)) return "";
  double degrees_per_unit = 1.0;
  if (keys.code(kAngularUnits) == 9101) degrees_per_unit = 180.0 / std::numbers::pi;
  if (keys.code(kAngularUnits) == 9105) degrees_per_unit = 0.9;
  std::string name = method->name, parameters;
  if (is_utm) {
    parameters = utm_parameters(projection);
  } else {
    parameters = parameters_of(*method, keys, degrees_per_unit);
  }
  if (method->code == 7 && keys.number({kParallel1}) && !keys.number({3092, 3093})) {
    const Method two{7, "Mercator_2SP", nullptr, kMeridian, nullptr, 1, false};
    name = two.name;
    parameters = parameters_of(two, keys, degrees_per_unit);
  }
  const std::string citation = keys.text(kProjectedCitation);
  return fmt::format("PROJCS[\"{}\",{},PROJECTION[\"{}\"]{},UNIT[\"unit\",{:.17g}]]",
                     plain(citation.empty() ? keys.text(kCitation) : citation, "unnamed"), base,
                     name, parameters, unit);
}

}  // namespace aerostat::elevation

#include "scene/moon_position.hpp"

#include <cmath>
#include <cstdlib>

namespace aerostat::scene::detail {

namespace {

// A term of the sums: the factors of the moon's elongation, the sun's anomaly, the moon's anomaly
// and the moon's argument of latitude, and the coefficients of longitude (1e-6 degrees) and
// distance (metres).
struct Term {
  int elongation, sun, moon, node;
  double longitude, distance;
};

// The largest terms of table 47.A.
constexpr Term kTerms[] = {
    {0, 0, 1, 0, 6288774, -20905355}, {2, 0, -1, 0, 1274027, -3699111},
    {2, 0, 0, 0, 658314, -2955968},   {0, 0, 2, 0, 213618, -569925},
    {0, 1, 0, 0, -185116, 48888},     {0, 0, 0, 2, -114332, -3149},
    {2, 0, -2, 0, 58793, 246158},     {2, -1, -1, 0, 57066, -152138},
    {2, 0, 1, 0, 53322, -170733},     {2, -1, 0, 0, 45758, -204586},
    {0, 1, -1, 0, -40923, -129620},   {1, 0, 0, 0, -34720, 108743},
    {0, 1, 1, 0, -30383, 104755},     {2, 0, 0, -2, 15327, 10321},
    {0, 0, 1, 2, -12528, 0},          {0, 0, 1, -2, 10980, 79661},
    {4, 0, -1, 0, 10675, -34782},     {0, 0, 3, 0, 10034, -23210},
    {4, 0, -2, 0, 8548, -21636},      {2, 1, -1, 0, -7888, 24208},
    {2, 1, 0, 0, -6766, 30824},       {1, 0, -1, 0, -5163, -8379},
    {1, 1, 0, 0, 4987, -16675},       {2, -1, 1, 0, 4036, -12831},
    {2, 0, 2, 0, 3994, -10445},       {4, 0, 0, 0, 3861, -11650},
    {2, 0, -3, 0, 3665, 14403},       {0, 1, -2, 0, -2689, -7003},
    {2, 0, -1, 2, -2602, 0},          {2, -1, -2, 0, 2390, 10056},
    {1, 0, 1, 0, -2348, 6322},        {2, -2, 0, 0, 2236, -9884},
    {0, 1, 2, 0, -2120, 5751},        {0, 2, 0, 0, -2069, 0},
};

// The largest terms of table 47.B, which give the latitude in place of the longitude.
constexpr Term kLatitudeTerms[] = {
    {0, 0, 0, 1, 5128122, 0}, {0, 0, 1, 1, 280602, 0},  {0, 0, 1, -1, 277693, 0},
    {2, 0, 0, -1, 173237, 0}, {2, 0, -1, 1, 55413, 0},  {2, 0, -1, -1, 46271, 0},
    {2, 0, 0, 1, 32573, 0},   {0, 0, 2, 1, 17198, 0},   {2, 0, 1, -1, 9266, 0},
    {0, 0, 2, -1, 8822, 0},   {2, -1, 0, -1, 8216, 0},  {2, 0, -2, -1, 4324, 0},
    {2, 0, 1, 1, 4200, 0},    {2, 1, 0, -1, -3359, 0},  {2, -1, -1, 1, 2463, 0},
    {2, -1, 0, 1, 2211, 0},   {2, -1, -1, -1, 2065, 0},
};

/// The mean angles on which the moon's place depends, in radians.
struct Arguments {
  double longitude, elongation, sun, moon, node;
};

Arguments arguments_at(double t) {
  return {
      (218.3164477 + t * (481267.88123421 - t * (0.0015786 - t / 538841.0))) * kDegree,
      (297.8501921 + t * (445267.1114034 - t * (0.0018819 - t / 545868.0))) * kDegree,
      (357.5291092 + t * (35999.0502909 - t * 0.0001536)) * kDegree,
      (134.9633964 + t * (477198.8675055 + t * (0.0087414 + t / 69699.0))) * kDegree,
      (93.2720950 + t * (483202.0175233 - t * 0.0036539)) * kDegree,
  };
}

/// Returns the sine and the cosine of a term's angle, times the factor by which the Earth's orbit
/// becomes rounder.
dvec2 wave_of(const Term& term, const Arguments& at, double t) {
  const double angle = term.elongation * at.elongation + term.sun * at.sun + term.moon * at.moon +
                       term.node * at.node;
  const double rounder = 1.0 - t * (0.002516 + t * 0.0000074);
  const double factor = std::pow(rounder, std::abs(term.sun));
  return {factor * std::sin(angle), factor * std::cos(angle)};
}

constexpr double kEarthRadiusKm = 6371.0;

}  // namespace

MoonPlace moon_place_at(double days_from_2000) {
  const double t = orbit_centuries(days_from_2000);
  const Arguments at = arguments_at(t);
  double longitude = 0.0, latitude = 0.0, distance = 385000560.0;
  for (const Term& term : kTerms) {
    const dvec2 wave = wave_of(term, at, t);
    longitude += term.longitude * wave.x;
    distance += term.distance * wave.y;
  }
  for (const Term& term : kLatitudeTerms) latitude += term.longitude * wave_of(term, at, t).x;
  // Venus and the flattening of the Earth.
  longitude += 3958.0 * std::sin((119.75 + 131.849 * t) * kDegree) +
               1962.0 * std::sin(at.longitude - at.node);
  latitude -= 2235.0 * std::sin(at.longitude);
  const Nutation nutation = nutation_at(t);
  const double longitude_deg = at.longitude / kDegree + longitude * 1e-6 + nutation.longitude_deg;
  return {equatorial_of(longitude_deg, latitude * 1e-6, nutation.obliquity_deg), distance * 1e-3};
}

MoonSeen moon_seen_at(double days_from_2000, double latitude_deg, double longitude_deg) {
  const MoonPlace moon = moon_place_at(days_from_2000);
  const double sidereal_deg = sidereal_deg_at(days_from_2000) + longitude_deg;
  const dvec3 from_middle = seen_from(moon.place, sidereal_deg, latitude_deg) * moon.distance_km;
  const dvec3 from_ground = from_middle - dvec3(0.0, kEarthRadiusKm, 0.0);
  return {lifted_angles(from_ground), glm::length(from_ground)};
}

}  // namespace aerostat::scene::detail

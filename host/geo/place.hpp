#pragma once

namespace aerostat::geo {

/// A place on the Earth in degrees, on the datum WGS 84. North and east are positive.
struct Place {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;

  bool operator==(const Place&) const = default;
};

}  // namespace aerostat::geo

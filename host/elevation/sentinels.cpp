#include "elevation/sentinels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace aerostat::elevation {

std::string sentinel_warning(const ExtremeValue& extreme) {
  constexpr std::array kMarks{-32768.0, -32767.0, -9999.0,       -99999.0,     32767.0, 65535.0,
                              -99.0,    9999.0,   -2147483648.0, 2147483647.0, -3.0e38};
  // No land has a step of so many metres, feet or even decimetres between neighbouring values.
  constexpr double kFar = 1000.0;
  if (std::find(kMarks.begin(), kMarks.end(), extreme.value) == kMarks.end()) return "";
  if (extreme.count == 0 || extreme.others == 0) return "";
  const double least = extreme.value == -99.0 ? 80.0 : kFar;
  if (!(std::abs(extreme.value - extreme.next) >= least)) return "";
  return fmt::format(
      "{} sample{} the value {}, which is far from all others and often marks places without a "
      "height; set /terrain/nodata to {} if it does here.",
      extreme.count, extreme.count == 1 ? " has" : "s have", extreme.value, extreme.value);
}

}  // namespace aerostat::elevation

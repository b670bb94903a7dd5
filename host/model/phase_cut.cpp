#include "model/phase_cut.hpp"

#include <algorithm>
#include <cmath>

namespace aerostat::model {
namespace {

/// The distance from a whole number within which a phase becomes that number. Chosen by eye.
constexpr double kSnap = 0.005;

/// Returns the point of an edge at which the phase is `phase`. It is always computed from the lower
/// phase to the higher one, so that both owners of the edge get the same point.
CutVertex crossing(const CutVertex& a, const CutVertex& b, double phase) {
  const CutVertex& low = a.phase < b.phase ? a : b;
  const CutVertex& high = a.phase < b.phase ? b : a;
  const auto t = static_cast<float>((phase - low.phase) / (high.phase - low.phase));
  return {low.position + t * (high.position - low.position),
          glm::normalize(low.normal + t * (high.normal - low.normal)),
          low.uv + t * (high.uv - low.uv), phase};
}

/// Splits a convex polygon at `phase` into the part below and the part above.
void split(const std::vector<CutVertex>& polygon, double phase, std::vector<CutVertex>& below,
           std::vector<CutVertex>& above) {
  below.clear();
  above.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const CutVertex& here = polygon[i];
    const CutVertex& next = polygon[(i + 1) % polygon.size()];
    if (here.phase <= phase) below.push_back(here);
    if (here.phase >= phase) above.push_back(here);
    if ((here.phase < phase && next.phase > phase) || (here.phase > phase && next.phase < phase)) {
      below.push_back(crossing(here, next, phase));
      above.push_back(below.back());
    }
  }
}

}  // namespace

double quantized_phase(double phase) {
  const double whole = std::round(phase);
  if (std::abs(phase - whole) < kSnap) return whole;
  return std::round(phase * 0x1p20) * 0x1p-20;
}

bool lies_in_one_band(const std::array<CutVertex, 3>& triangle, int& band) {
  const auto [low, high] = std::minmax({triangle[0].phase, triangle[1].phase, triangle[2].phase});
  band = static_cast<int>(std::floor(low));
  return high <= band + 1.0;
}

std::vector<CutPiece> cut_by_phase(const std::array<CutVertex, 3>& triangle) {
  std::vector<CutPiece> pieces;
  std::vector<CutVertex> rest(triangle.begin(), triangle.end());
  const double high = std::max({triangle[0].phase, triangle[1].phase, triangle[2].phase});
  int band = 0;
  lies_in_one_band(triangle, band);
  std::vector<CutVertex> below, above;
  for (; band + 1.0 < high; ++band) {
    split(rest, band + 1.0, below, above);
    if (below.size() >= 3) pieces.push_back({band, below});
    rest.swap(above);
  }
  if (rest.size() >= 3) pieces.push_back({band, rest});
  return pieces;
}

}  // namespace aerostat::model

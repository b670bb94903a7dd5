#include "image/white.hpp"

#include <cmath>

namespace aerostat::image {

namespace {

constexpr double kNeutral = 6504.0;
constexpr double kAutomaticDegree = 0.5;

// Returns the matrix with these rows.
glm::dmat3 rows(const dvec3& a, const dvec3& b, const dvec3& c) {
  return glm::transpose(glm::dmat3(a, b, c));
}

glm::dmat3 xyz_from_rec709() {
  return rows({0.4123908, 0.3575843, 0.1804808}, {0.2126390, 0.7151687, 0.0721923},
              {0.0193308, 0.1191948, 0.9505322});
}

glm::dmat3 cones_from_rec709() {
  const glm::dmat3 bradford =
      rows({0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296});
  return bradford * xyz_from_rec709();
}

double luminance(const dvec3& c) {
  return (xyz_from_rec709() * c).y;
}

}  // namespace

dvec3 black_body(double kelvin) {
  const double t = 1000.0 / kelvin;
  const double x = kelvin < 4000.0 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                                   : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
  double y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  if (kelvin < 2222.0) {
    y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
  } else if (kelvin < 4000.0) {
    y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
  }
  return glm::inverse(xyz_from_rec709()) * dvec3(x / y, 1.0, (1.0 - x - y) / y);
}

glm::dmat3 white_balance(const dvec3& white, double degree) {
  const glm::dmat3 cones = cones_from_rec709();
  const dvec3 from = cones * (white / luminance(white)), to = cones * dvec3(1.0);
  const dvec3 gain = glm::pow(to / glm::max(from, dvec3(1e-6)), dvec3(degree));
  glm::dmat3 scale(0.0);
  for (int i = 0; i < 3; ++i) scale[i][i] = gain[i];
  const glm::dmat3 balance = glm::inverse(cones) * scale * cones;
  return balance * (luminance(white) / luminance(balance * white));
}

glm::dmat3 white_balance_for(double kelvin) {
  // A black body of 6504 K differs a little from the daylight that Rec. 709 calls white.
  return white_balance(black_body(kelvin) / black_body(kNeutral), 1.0);
}

glm::dmat3 automatic_white_balance(const dvec3& daylight) {
  const double light = luminance(daylight);
  if (!(light > 1e-9) || !std::isfinite(light)) return glm::dmat3(1.0);
  return white_balance(daylight, kAutomaticDegree);
}

}  // namespace aerostat::image

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "image/tone.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

/// A function on [0, most] by straight lines between samples, dense where it is steep: at 0. What
/// the functions here lose is below 1e-6, a four-thousandth of a display step.
class Table {
 public:
  template <typename Function>
  Table(const Function& function, double most) : scale_(kSteps / std::sqrt(most)) {
    for (int i = 0; i <= kSteps; ++i) {
      const double root = i / scale_;
      values_[static_cast<std::size_t>(i)] = function(root * root);
    }
    values_.back() = values_[kSteps];
  }

  double operator()(double x) const {
    const double at = std::sqrt(x) * scale_;
    const auto i = static_cast<std::size_t>(std::min(at, double{kSteps}));
    return values_[i] + (at - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
  }

 private:
  static constexpr int kSteps = 4096;

  double scale_;
  std::array<double, kSteps + 2> values_{};
};

/// By how much a vignette multiplies the light of a pixel.
class Vignette {
 public:
  Vignette(const Film& film, const Look& look)
      : lost_(look.vignette),
        first_(look.first),
        size_(look.whole == glm::ivec2(0) ? dvec2(film.width, film.height) : dvec2(look.whole)) {}

  double operator()(int x, int y) const {
    if (lost_ <= 0.0) return 1.0;
    const dvec2 from_middle = dvec2(first_ + glm::ivec2(x, y)) + 0.5 - 0.5 * size_;
    return vignette_share(2.0 * glm::length(from_middle) / glm::length(size_), lost_);
  }

 private:
  double lost_;
  glm::ivec2 first_;
  dvec2 size_;
};

void develop_row(const Film& film, const Look& look, int y, Pixels& pixels) {
  static const Table encode(srgb_from_linear, 1.0);
  static const Table curve_table(tone_curve, kWhitePoint);
  const auto curve = [](double x) { return x < kWhitePoint ? curve_table(x) : 1.0; };
  const Vignette vignette(film, look);
  const glm::dmat3 exposed = look.white_balance * std::exp2(look.exposure_ev);
  const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width);
  for (int x = 0; x < film.width; ++x) {
    const std::size_t index = first + static_cast<std::size_t>(x);
    const dvec3 light = exposed * dvec3(film.radiance[index]) * vignette(x, y);
    const dvec3 display = tone_map(light, curve);
    for (int channel = 0; channel < 3; ++channel) {
      pixels.rgb[3 * index + static_cast<std::size_t>(channel)] =
          quantise(encode(std::clamp(display[channel], 0.0, 1.0)), x, y);
    }
  }
}

}  // namespace

double vignette_share(double distance, double lost) {
  const double tangent_squared = (1.0 / std::sqrt(1.0 - lost) - 1.0) * distance * distance;
  return 1.0 / ((1.0 + tangent_squared) * (1.0 + tangent_squared));
}

Pixels develop(const Film& film, double exposure_ev) {
  return develop(film, Look{exposure_ev, glm::dmat3(1.0), 0.0, {0, 0}, {0, 0}});
}

Pixels develop(const Film& film, const Look& look) {
  const std::size_t count =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  if (film.width < 0 || film.height < 0 || film.radiance.size() != count) {
    throw Error(ErrorKind::internal, "developing a film whose size and pixels do not agree");
  }
  Pixels pixels{film.width, film.height, std::vector<std::uint8_t>(3 * count)};
  tbb::parallel_for(tbb::blocked_range<int>(0, film.height, 16), [&](const auto& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) develop_row(film, look, y, pixels);
  });
  return pixels;
}

}  // namespace aerostat::image

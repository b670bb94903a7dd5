#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/simd.hpp"
#include "image/glare.hpp"
#include "image/tone.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

/// A function on [0, most] that is approximated by straight lines between samples. Samples are
/// densest at 0, where the functions are steep. The error of the functions here is below 1e-6, a
/// four-thousandth of a display step.
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

  /// The part that loops copy, so that the compiler knows that no store changes it.
  struct Lines {
    const double* values;
    double scale;

    AEROSTAT_INLINE double operator()(double x) const {
      const double at = std::sqrt(x) * scale;
      // The index is signed, because compilers use gather instructions with signed indices only.
      const auto i = static_cast<std::int32_t>(at < kSteps ? at : kSteps);
      return values[i] + (at - static_cast<double>(i)) * (values[i + 1] - values[i]);
    }
  };
  Lines lines() const { return {values_.data(), scale_}; }

 private:
  static constexpr int kSteps = 4096;

  double scale_;
  std::array<double, kSteps + 2> values_{};
};

constexpr int kBlock = 128;
using Values = std::array<double, kBlock>;

glm::ivec2 whole_of(const Film& film) {
  return film.whole == glm::ivec2(0) ? glm::ivec2(film.width, film.height) : film.whole;
}

void require_pixels(const Film& film) {
  const std::size_t count =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  if (film.width < 0 || film.height < 0 || film.radiance.size() != count) {
    throw Error(ErrorKind::internal, "developing a film whose size and pixels do not agree");
  }
}

/// The factor by which a vignette multiplies the light of a pixel.
class Vignette {
 public:
  Vignette(const Film& film, const Development& development)
      : lost_(development.vignette), first_(film.first), size_(whole_of(film)) {}

  /// Computes the factors of `count` pixels of a row, from x on.
  void shares(int x, int y, int count, Values& share) const {
    for (int i = 0; i < count; ++i) share[i] = lost_ <= 0.0 ? 1.0 : of(x + i, y);
  }

 private:
  double of(int x, int y) const {
    const dvec2 from_middle = dvec2(first_ + glm::ivec2(x, y)) + 0.5 - 0.5 * size_;
    return vignette_share(2.0 * glm::length(from_middle) / glm::length(size_), lost_);
  }

  double lost_;
  glm::ivec2 first_;
  dvec2 size_;
};

/// The values of developing that are the same for all pixels.
struct Bath {
  glm::dmat3 exposed;
  Table::Lines curve, encode;
};

/// Some neighbouring pixels of a row.
struct Strip {
  const float* light;  // three floats for each pixel
  int count;
  Values share;       // share of the light that the vignette leaves
  Values thresholds;  // thresholds of the dither
  std::uint8_t* rgb;
};

/// Computes what tone_map, srgb_from_linear and quantise make of the pixels, without a branch.
AEROSTAT_INLINE void develop_loop(const Bath& bath, const Strip& strip) {
  const glm::dmat3 m = bath.exposed;
  const Table::Lines curve = bath.curve, encode = bath.encode;
  const float* light = strip.light;
  const int count = strip.count;
  std::array<std::int32_t, 3 * kBlock> bytes;
  for (int i = 0; i < count; ++i) {
    const double r = light[3 * i], g = light[3 * i + 1], b = light[3 * i + 2];
    const double share = strip.share[i], threshold = strip.thresholds[i];
    const auto exposed = [&](int c) {
      const double value = (m[0][c] * r + m[1][c] * g + m[2][c] * b) * share;
      return value > 0.0 ? value : 0.0;
    };
    const double x = exposed(0), y = exposed(1), z = exposed(2);
    const double higher = x < y ? y : x, peak = higher < z ? z : higher;
    const double bent = curve(peak), display = peak < kWhitePoint ? bent : 1.0;
    const double fourth = display * display * display * display, white = fourth * fourth;
    const double most = peak > 0.0 ? peak : 1.0;
    const auto byte = [&](double color) {
      const double mapped = display * (color / most * (1.0 - white) + white);
      // The comparison also gives 1 where an infinite component has made the value NaN.
      const double shown = mapped < 1.0 ? mapped : 1.0;
      const double encoded = encode(shown);
      return static_cast<std::int32_t>((encoded < 1.0 ? encoded : 1.0) * 255.0 + threshold);
    };
    bytes[3 * i] = byte(x);
    bytes[3 * i + 1] = byte(y);
    bytes[3 * i + 2] = byte(z);
  }
  std::uint8_t* rgb = strip.rgb;
  for (int i = 0; i < 3 * count; ++i) rgb[i] = static_cast<std::uint8_t>(bytes[i]);
}

void develop_row(const Film& film, const Development& development, const Glare& glare, int y,
                 Pixels& pixels) {
  static const Table encode(srgb_from_linear, 1.0);
  static const Table curve(tone_curve, kWhitePoint);
  const Vignette vignette(film, development);
  const Bath bath{development.white_balance * std::exp2(development.exposure_ev), curve.lines(),
                  encode.lines()};
  Strip strip;
  std::array<float, 3 * kBlock> glaring;
  for (int i = 0; i < kBlock; ++i)
    strip.thresholds[i] = dither_threshold(film.first.x + i, film.first.y + y);
  for (int x = 0; x < film.width; x += kBlock) {
    const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                              static_cast<std::size_t>(x);
    strip.light = &film.radiance[first].x;
    strip.count = std::min(kBlock, film.width - x);
    strip.rgb = &pixels.rgb[3 * first];
    if (glare.is_there()) {
      glare.apply(film, x, y, strip.count, glaring.data());
      strip.light = glaring.data();
    }
    vignette.shares(x, y, strip.count, strip.share);
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA { develop_loop(bath, strip); });
  }
}

}  // namespace

double vignette_share(double distance, double lost) {
  const double tangent_squared = (1.0 / std::sqrt(1.0 - lost) - 1.0) * distance * distance;
  return 1.0 / ((1.0 + tangent_squared) * (1.0 + tangent_squared));
}

Pixels develop(const Film& film, double exposure_ev) {
  return develop(film, Development{exposure_ev, glm::dmat3(1.0), 0.0, 0.0});
}

Pixels develop(const Film& film, const Development& development) {
  Glare glare(whole_of(film), development);
  require_pixels(film);
  glare.add(film);
  glare.spread();
  return develop(film, development, glare);
}

Pixels develop(const Film& film, const Development& development, const Glare& glare) {
  require_pixels(film);
  const std::size_t count =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  Pixels pixels{film.width, film.height, std::vector<std::uint8_t>(3 * count)};
  tbb::parallel_for(tbb::blocked_range<int>(0, film.height, 16), [&](const auto& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) {
      develop_row(film, development, glare, y, pixels);
    }
  });
  return pixels;
}

}  // namespace aerostat::image

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <vector>

#include <tbb/parallel_for.h>

#include "image/tone.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

// The grey to which the middle of a picture is exposed. It lies between the classical 0.18 and
// the look of daylight. Chosen by eye.
constexpr double kGrey = 0.21;
// The shares of the pixels between which the middle is measured. A dark foreground, and the sun
// and its reflections, tell little about the view. Chosen by eye.
constexpr double kDarkShare = 0.2, kBrightShare = 0.95;
// The brightest twentieth of the pixels may reach kLights, up to which the tone curve still shows
// the modelling of clouds and snow. Chosen by eye.
constexpr double kLightsShare = 0.95, kLights = 1.5;
// The largest number of stops by which a picture is darkened for its lights. Beyond that, lights
// such as a glitter on the sea may clip. Chosen by eye.
constexpr double kMostHeldBack = 2.0;
// Where the lights leave room, the exposure rises by this share of the room, so that whites are
// white. The room counts up to kMostRoom stops, because a dull view has no whites. Chosen by eye.
constexpr double kRaisedShare = 0.3, kMostRoom = 1.5;

// Candelas per square metre of a radiance of 1. The sun's 133.1 klx outside the air (S. Darula,
// R. Kittler and C. A. Gueymard, "Reference luminous solar constant", Solar Energy 79, 2005)
// correspond to its usual irradiance of 5.
constexpr double kCandelas = 133100.0 / 5.0;
// From this luminance (cd/m^2) upwards, the middle is shown as in daylight. Chosen by eye.
constexpr double kDaylight = 100.0;
// Below the luminance kNight (cd/m^2), darker views hardly look darker to the eye. They are still
// shown darker by kNightShare stops for each stop, so that a later hour of the night looks later.
// Chosen by eye.
constexpr double kNight = 0.01, kNightShare = 0.25;

constexpr double kLeastLight = 1e-12;
constexpr std::size_t kBlockPixels = 8192;

// Bins of luminance, 32 for each stop. A bin is given by the upper bits of a double, counted from
// those of kLeastLight.
constexpr int kBinShift = 52 - 5;
constexpr std::uint64_t kFirstBin = std::bit_cast<std::uint64_t>(kLeastLight) >> kBinShift;
constexpr std::size_t kBins = (std::bit_cast<std::uint64_t>(0x1p130) >> kBinShift) - kFirstBin;
using Counts = std::vector<std::uint64_t>;  // kBins counts

std::size_t bin_of(double light) {
  return (std::bit_cast<std::uint64_t>(light) >> kBinShift) - kFirstBin;
}

/// Calls `f` with the luminance of each pixel of a block that has any.
template <typename F>
void each_light(const Film& film, std::size_t block, F&& f) {
  const std::size_t begin = block * kBlockPixels;
  const std::size_t end = std::min(begin + kBlockPixels, film.radiance.size());
  for (std::size_t i = begin; i < end; ++i) {
    const double light = luminance(dvec3(film.radiance[i]));
    if (light > kLeastLight && light < 0x1p130) f(light);
  }
}

std::size_t blocks_of(const Film& film) {
  return (film.radiance.size() + kBlockPixels - 1) / kBlockPixels;
}

Counts count_bins(const Film& film) {
  Counts all(kBins);
  std::mutex adding;
  tbb::parallel_for(std::size_t{0}, blocks_of(film), [&](std::size_t block) {
    std::vector<std::uint32_t> counts(kBins);
    each_light(film, block, [&](double light) { ++counts[bin_of(light)]; });
    const std::lock_guard lock(adding);
    for (std::size_t bin = 0; bin < kBins; ++bin) all[bin] += counts[bin];
  });
  return all;
}

/// A position among all luminances in ascending order.
struct Rank {
  std::size_t bin = 0;
  std::uint64_t within = 0;  // position within the bin
};

Rank find(const Counts& counts, std::uint64_t rank) {
  std::size_t bin = 0;
  while (rank >= counts[bin]) rank -= counts[bin++];
  return {bin, rank};
}

/// Computes the sum of many logarithms with few calls of log2. Exponents are added, and mantissas
/// are multiplied.
class LogSum {
 public:
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    exponents_ += static_cast<std::int64_t>(bits >> 52) - 1023;
    product_ *= std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFull) | 0x3FF0000000000000ull);
    // Each factor is less than 2, so that 512 of them do not overflow.
    if (++factors_ % 512 == 0) settle();
  }
  double log2() {
    settle();
    return logs_ + static_cast<double>(exponents_);
  }

 private:
  void settle() {
    logs_ += std::log2(product_);
    product_ = 1.0;
  }

  double product_ = 1.0, logs_ = 0.0;
  std::int64_t exponents_ = 0;
  unsigned factors_ = 0;
};

/// The sum, in stops, of all luminances between the bins of two ranks, and each luminance of the
/// bins in which ranks lie.
struct Sifted {
  double stops_between = 0.0;
  std::vector<double> edges;  // in ascending order
};

Sifted sift(const Film& film, const Rank& from, const Rank& to, const Rank& lights) {
  std::vector<Sifted> parts(blocks_of(film));
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t block) {
    LogSum sum;
    each_light(film, block, [&](double light) {
      const std::size_t bin = bin_of(light);
      if (bin > from.bin && bin < to.bin) sum.add(light);
      if (bin == from.bin || bin == to.bin || bin == lights.bin)
        parts[block].edges.push_back(light);
    });
    parts[block].stops_between = sum.log2();
  });
  Sifted all;
  for (const Sifted& part : parts) {
    all.stops_between += part.stops_between;
    all.edges.insert(all.edges.end(), part.edges.begin(), part.edges.end());
  }
  std::sort(all.edges.begin(), all.edges.end());
  return all;
}

/// Returns the key of a view of this mean luminance (cd/m^2), which tells how bright it looks.
/// Source: G. Krawczyk, K. Myszkowski and H.-P. Seidel, "Perceptual Effects in Real-time Tone
/// Mapping", SCCG 2005, equation 11.
double key(double candelas) {
  return 1.03 - 2.0 / (2.0 + std::log10(candelas + 1.0));
}

/// Returns the stops by which the middle of a view is shown darker than by day. They are never
/// positive.
double dusk_stops(double middle) {
  const double candelas = std::min(std::exp2(middle) * kCandelas, kDaylight);
  const double night = std::min(candelas / kNight, 1.0);
  return std::log2(key(candelas) / key(kDaylight)) + kNightShare * std::log2(night);
}

/// The levels of a picture's middle and of its lights, in stops.
struct Levels {
  double middle = 0.0, lights = 0.0;
};

/// Returns the levels of a film with `count` > 0 luminances.
Levels levels_of(const Film& film, const Counts& counts, std::uint64_t count) {
  const auto rank = [last = static_cast<double>(count - 1)](double share) {
    return static_cast<std::uint64_t>(share * last);
  };
  const std::uint64_t first = rank(kDarkShare), end = rank(kBrightShare);
  const Rank from = find(counts, first), to = find(counts, end),
             lights = find(counts, rank(kLightsShare));
  const Sifted sifted = sift(film, from, to, lights);
  const std::uint64_t before_to = to.bin == from.bin ? 0 : counts[from.bin];
  const std::uint64_t before_lights = lights.bin == to.bin ? before_to : before_to + counts[to.bin];
  const auto stop = [&sifted](std::uint64_t place) { return std::log2(sifted.edges[place]); };
  double middle = sifted.stops_between;
  for (std::uint64_t place = from.within; place < before_to + to.within; ++place)
    middle += stop(place);
  middle = first == end ? stop(from.within) : middle / static_cast<double>(end - first);
  return {middle, stop(before_lights + lights.within)};
}

}  // namespace

double automatic_exposure_ev(const Film& film) {
  const Counts counts = count_bins(film);
  const std::uint64_t count = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  if (count == 0) return 0.0;
  const Levels levels = levels_of(film, counts, count);
  const double dusk = dusk_stops(levels.middle);
  const double wanted = std::log2(kGrey) + dusk - levels.middle;
  const double room = std::log2(kLights) - levels.lights - wanted;
  if (room > 0.0) return wanted + kRaisedShare * std::min(room, kMostRoom);
  // The lights of a dark view are lamps, which may clip. Such a view is not darkened twice.
  return wanted + std::max(room, std::min(-kMostHeldBack - dusk, 0.0));
}

}  // namespace aerostat::image

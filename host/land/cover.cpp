#include "land/cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "elevation/open.hpp"
#include "land/levels_maker.hpp"

namespace aerostat::land {
namespace {

constexpr OverlayWords kWords{"land cover", "/terrain/cover/crs"};
constexpr LevelLimits kLimits{kLeastCoverSide, kMostCoverSide, kMostCoverLevels};
constexpr int kRowsAtOnce = 64, kPointsAnEdge = 65;

/// Shares with the arithmetic of LevelsMaker.
struct Shares {
  CoverShares of{};

  Shares& operator+=(const Shares& other) {
    for (std::size_t k = 0; k < of.size(); ++k) of[k] += other.of[k];
    return *this;
  }
};

Shares operator*(float factor, const Shares& shares) {
  Shares scaled;
  scaled += shares;
  for (float& share : scaled.of) share *= factor;
  return scaled;
}

Shares mix(const Shares& a, const Shares& b, float t) {
  Shares mixed;
  for (std::size_t k = 0; k < a.of.size(); ++k) mixed.of[k] = a.of[k] + t * (b.of[k] - a.of[k]);
  return mixed;
}

/// The share of water with the arithmetic of LevelsMaker.
struct WaterShare {
  float of = 0.0f;

  WaterShare& operator+=(const WaterShare& other) {
    of += other.of;
    return *this;
  }
};

WaterShare operator*(float factor, const WaterShare& share) {
  return {factor * share.of};
}

WaterShare mix(const WaterShare& a, const WaterShare& b, float t) {
  return {a.of + t * (b.of - a.of)};
}

/// The codes of a raster as a source of levels of shares.
template <class ValueType>
class CodeSource {
 public:
  using Value = ValueType;

  CodeSource(const elevation::Raster& raster, const CoverCodes& classes)
      : raster_(raster), classes_(classes) {
    sizes_.push_back({raster.info().width, raster.info().height});
    const std::size_t overviews = raster.overview_factors().size();
    for (std::size_t k = 0; k < overviews; ++k) {
      sizes_.push_back(raster.overview_size(static_cast<int>(k)));
    }
  }

  const elevation::RasterInfo& info() const { return raster_.info(); }
  const std::vector<std::array<int, 2>>& levels() const { return sizes_; }

  void read(int level, const elevation::Window& window, Value* values) const {
    std::vector<float> codes(static_cast<std::size_t>(window.width) *
                             static_cast<std::size_t>(window.height));
    if (level == 0) {
      raster_.read(window, codes.data());
    } else {
      raster_.read_overview(level - 1, window, codes.data());
    }
    for (std::size_t k = 0; k < codes.size(); ++k) {
      values[k] = Value{};
      if (std::isnan(codes[k])) continue;
      // An overview can have codes that the raster has elsewhere.
      const auto found = classes_.find(static_cast<int>(std::lround(codes[k])));
      if (found != classes_.end()) set(found->second, values[k]);
    }
  }

  static std::uint32_t pack(const Shares& shares) { return packed_shares(shares.of); }
  static std::uint32_t pack(const WaterShare& share) {
    return static_cast<std::uint32_t>(std::lround(255.0f * std::clamp(share.of, 0.0f, 1.0f)));
  }

 private:
  static void set(CoverClass is, Shares& shares) {
    const CoverClass shown = is == CoverClass::water ? CoverClass::wetland : is;
    shares.of[static_cast<std::size_t>(shown)] = 1.0f;
  }
  static void set(CoverClass is, WaterShare& share) {
    share.of = is == CoverClass::water ? 1.0f : 0.0f;
  }

  const elevation::Raster& raster_;
  const CoverCodes& classes_;
  std::vector<std::array<int, 2>> sizes_;
};

/// Returns the part of a raster that lies within reach of the middle.
elevation::Window window_within(const elevation::RasterInfo& info, const Placement& placement,
                                double reach_m) {
  std::vector<dvec2> points;
  for (int j = 0; j < kPointsAnEdge; ++j)
    for (int i = 0; i < kPointsAnEdge; ++i) {
      points.push_back(reach_m * (2.0 * dvec2(i, j) / (kPointsAnEdge - 1.0) - 1.0));
    }
  placement.to_raster(points);
  dvec2 low(1e9), high(-1e9);
  for (const dvec2& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const dvec2 size(info.width, info.height);
  low = glm::clamp(glm::floor(low), dvec2(0.0), size);
  high = glm::clamp(glm::ceil(high), dvec2(0.0), size);
  return {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x - low.x),
          static_cast<int>(high.y - low.y)};
}

/// Counts the codes of a part of a raster. Throws Error{bad_data} if a value is no whole number.
CoverCounts counted(const elevation::Raster& raster, const elevation::Window& window) {
  CoverCounts counts;
  std::mutex mutex;
  const auto count_rows = [&](int first, int end) {
    const elevation::Window part{window.column, first, window.width, end - first};
    std::vector<float> codes(static_cast<std::size_t>(part.width) *
                             static_cast<std::size_t>(part.height));
    raster.read(part, codes.data());
    CoverCounts found;
    float last = std::numeric_limits<float>::quiet_NaN();
    std::uint64_t* count = nullptr;
    for (const float code : codes) {
      if (std::isnan(code)) continue;
      if (code != last) {
        if (std::abs(code) > 1e6f || code != std::round(code)) {
          throw Error(ErrorKind::bad_data,
                      fmt::format("{}: {} is no code of land cover, which is a whole number; this "
                                  "may be a raster of something else",
                                  raster.info().path.string(), code));
        }
        count = &found[static_cast<int>(code)];
        last = code;
      }
      ++*count;
    }
    const std::lock_guard lock(mutex);
    for (const auto& [code, times] : found) counts[code] += times;
  };
  const int end = window.row + window.height;
  tbb::parallel_for(0, (window.height + kRowsAtOnce - 1) / kRowsAtOnce,
                    [&, stop = current_stop()](int k) {
                      stop_if_asked(stop);
                      const int first = window.row + k * kRowsAtOnce;
                      count_rows(first, std::min(first + kRowsAtOnce, end));
                    });
  return counts;
}

}  // namespace

CoverShares shares_of_texel(std::uint32_t texel) {
  CoverShares shares{};
  for (std::size_t k = 0; k < shares.size(); ++k) {
    shares[k] = static_cast<float>(texel >> (4 * k) & 15u) / 15.0f;
  }
  return shares;
}

std::uint32_t packed_shares(const CoverShares& shares) {
  std::uint32_t texel = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const float held = std::clamp(shares[k], 0.0f, 1.0f);
    texel |= static_cast<std::uint32_t>(std::lround(15.0f * held)) << (4 * k);
  }
  return texel;
}

Cover::Cover(const CoverOptions& options) {
  elevation::OpenOptions open;
  open.crs = options.crs;
  open.codes = true;
  const std::unique_ptr<elevation::Raster> raster = elevation::open(options.file, open);
  if (!raster->info().georeference) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: the file does not say where its codes of land cover lie",
                            options.file.string()));
  }
  const Placement placement(raster->info(), options.middle, kWords);
  const elevation::Window window = window_within(raster->info(), placement, options.reach_m);
  CoverCounts found;
  if (window.width > 0 && window.height > 0) found = counted(*raster, window);
  const KnownCodes known = known_codes(options.scheme, options.classes, found, options.file);
  if (!known.note.empty()) notes_.push_back(known.note);
  const CodeSource<Shares> classes(*raster, known.classes);
  ground_ = LevelsMaker(classes, placement, kWords, options.reach_m, kLimits).run();
  const bool has_water = std::any_of(found.begin(), found.end(), [&](const auto& one) {
    return known.classes.at(one.first) == CoverClass::water;
  });
  if (!has_water) return;
  const CodeSource<WaterShare> water(*raster, known.classes);
  water_ = LevelsMaker(water, placement, kWords, options.reach_m, kLimits).run();
}

CoverShares Cover::at(double east_m, double south_m, double footprint_m) const {
  return nested_at(ground_, {east_m, south_m}, footprint_m, Shares{},
                   [](std::uint32_t texel) { return Shares{shares_of_texel(texel)}; })
      .of;
}

float Cover::water_at(double east_m, double south_m, double footprint_m) const {
  return nested_at(
             water_, {east_m, south_m}, footprint_m, WaterShare{},
             [](std::uint32_t texel) { return WaterShare{static_cast<float>(texel) / 255.0f}; })
      .of;
}

}  // namespace aerostat::land

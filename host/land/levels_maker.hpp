#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "elevation/raster.hpp"
#include "land/nested_levels.hpp"
#include "land/placement.hpp"

/// How levels of detail are made from a raster with a place.
namespace aerostat::land {

/// The limits of nested levels, which bound their memory whatever the size of the file.
struct LevelLimits {
  int least_side, most_side, most_levels;
};

namespace detail {

inline constexpr int kNodes = 129;  // along a side of the lattice of a level
/// Samples that are read at once.
inline constexpr int kRowsAtOnce = 256, kColumnsAtOnce = 4096;
/// A level's share of cells of the raster is at most so many times its texels. A square raster
/// needs 2 times as many if it is turned.
inline constexpr double kMostCells = 16.0;
/// The coarsest level has at most so many texels over the reach, so that land that is seen from
/// afar has texels as wide as pixels.
inline constexpr double kCoarsest = 1024.0;

/// A window of a raster in cells of some samples a side, each with the mean of its samples.
template <class Value>
struct Cells {
  elevation::Window window;  // in cells
  double samples = 1.0;      // of the whole raster along a side of a cell
  std::vector<Value> means;

  Value mean(int column, int row) const {
    if (column < 0 || row < 0 || column >= window.width || row >= window.height) {
      return Value{};
    }
    return means[static_cast<std::size_t>(row) * static_cast<std::size_t>(window.width) +
                 static_cast<std::size_t>(column)];
  }

  /// Returns the mean around a place in samples from the raster's corner.
  Value at(const dvec2& place) const {
    const dvec2 p = place / samples - 0.5 - dvec2(window.column, window.row);
    if (!(p.x > -1.0 && p.y > -1.0 && p.x < window.width && p.y < window.height)) {
      return Value{};
    }
    const dvec2 cell = glm::floor(p);
    const vec2 share(p - cell);
    const int i = static_cast<int>(cell.x), j = static_cast<int>(cell.y);
    return mix(mix(mean(i, j), mean(i + 1, j), share.x),
               mix(mean(i, j + 1), mean(i + 1, j + 1), share.x), share.y);
  }
};

/// A level of a raster's file, and how many of its samples are a side of a cell.
struct FileLevel {
  int level = 0;
  int a_cell = 1;
};

/// Chooses the coarsest overview of half the size of a cell or less, because many overviews are
/// single samples of the raster and no means. `sizes` are those of the raster and its overviews.
inline FileLevel file_level_for(const std::vector<std::array<int, 2>>& sizes, int level) {
  FileLevel chosen{0, 1 << level};
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    const double factor = static_cast<double>(sizes[0][0]) / sizes[k][0];
    const double rounded = std::exp2(std::round(std::log2(factor)));
    if (std::abs(factor / rounded - 1.0) > 0.002 || 2.0 * rounded > (1 << level)) continue;
    chosen = {static_cast<int>(k), (1 << level) / static_cast<int>(rounded)};
  }
  return chosen;
}

}  // namespace detail

/// Makes nested levels from a source, a raster that has
///   - Value: what a sample is, with +=, float * Value and mix(); Value{} is nothing,
///   - info() and levels(): the raster, and the sizes of it and of its overviews, finest first,
///   - read(level, window, values): the values of a window, from any thread,
///   - pack(value): the texel of a value.
template <class Source>
class LevelsMaker {
  using Value = typename Source::Value;
  using Cells = detail::Cells<Value>;

 public:
  /// `reach_m` is half of the side of the square around the middle of the local frame that is
  /// looked at.
  LevelsMaker(const Source& source, const Placement& placement, const OverlayWords& words,
              double reach_m, const LevelLimits& limits)
      : source_(source), placement_(placement), words_(words), reach_m_(reach_m), limits_(limits) {}

  NestedLevels run() {
    lay_out();
    const auto side = static_cast<std::size_t>(made_.side);
    made_.texels.assign(static_cast<std::size_t>(made_.levels) * side * side, 0u);
    for (int level = 0; level < made_.levels; ++level) fill(level);
    return std::move(made_);
  }

 private:
  /// Chooses the middle, the size and the number of the levels.
  void lay_out() {
    auto [low, high] = placement_.bounds();
    const dvec2 reach(reach_m_);
    const dvec2 nearest = glm::clamp(dvec2(0.0), low, high);
    if (!(low.x < high.x && low.y < high.y) ||
        glm::any(glm::greaterThan(glm::abs(nearest), reach))) {
      throw Error(ErrorKind::bad_data,
                  fmt::format("{}: the {} does not lie on the land: its nearest point is {:.4g} "
                              "km from the terrain's centre, which reaches {:.4g} km; {} may be "
                              "wrong",
                              source_.info().path.string(), words_.what,
                              1e-3 * glm::length(nearest), 1e-3 * reach_m_, words_.crs_option));
    }
    low = glm::max(low, -reach);
    high = glm::min(high, reach);
    made_.middle = glm::clamp(dvec2(0.0), low, high);
    const dvec2 far = glm::max(high - made_.middle, made_.middle - low);
    const double away = std::max(far.x, far.y);
    const double sample = placement_.sample_m(0.5 * (low + high));
    const double texel = std::max(sample, away / (kReachOfLevel * limits_.most_side *
                                                  std::ldexp(1.0, limits_.most_levels - 1)));
    int side = limits_.least_side;
    while (side < limits_.most_side && kReachOfLevel * side * texel < away) side *= 2;
    int levels = 1;
    const auto is_enough = [&] {
      const double wide = std::ldexp(texel, levels - 1);
      return kReachOfLevel * side * wide >= away && wide * detail::kCoarsest >= reach_m_;
    };
    while (levels < limits_.most_levels && !is_enough()) ++levels;
    made_.side = side;
    made_.levels = levels;
    made_.texel_m = texel;
    // The cells of the first level are the samples, or as many of them as a texel has.
    first_ = std::max(0, static_cast<int>(std::lround(std::log2(texel / sample))));
  }

  /// Fills the texels of a level.
  void fill(int level) {
    const int side = made_.side;
    const double texel = std::ldexp(made_.texel_m, level);
    const double half = 0.5 * side * texel;
    std::vector<dvec2> nodes;
    for (int j = 0; j < detail::kNodes; ++j) {
      for (int i = 0; i < detail::kNodes; ++i) {
        nodes.push_back(made_.middle + half * (2.0 * dvec2(i, j) / (detail::kNodes - 1.0) - 1.0));
      }
    }
    placement_.to_raster(nodes);
    const Cells cells = read_cells(level + first_, nodes);
    std::uint32_t* const texels = made_.texels.data() + static_cast<std::size_t>(level) *
                                                            static_cast<std::size_t>(side) *
                                                            static_cast<std::size_t>(side);
    if (cells.means.empty()) return;
    tbb::parallel_for(0, side, [&](int row) {
      const double v = (row + 0.5) / side * (detail::kNodes - 1);
      for (int column = 0; column < side; ++column) {
        const double u = (column + 0.5) / side * (detail::kNodes - 1);
        texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
               static_cast<std::size_t>(column)] = Source::pack(cells.at(between(nodes, u, v)));
      }
    });
  }

  /// Returns the place between the nodes of a lattice.
  static dvec2 between(const std::vector<dvec2>& nodes, double u, double v) {
    const int i = std::min(static_cast<int>(u), detail::kNodes - 2);
    const int j = std::min(static_cast<int>(v), detail::kNodes - 2);
    const dvec2* at = nodes.data() + static_cast<std::size_t>(j) * detail::kNodes + i;
    return glm::mix(glm::mix(at[0], at[1], u - i),
                    glm::mix(at[detail::kNodes], at[detail::kNodes + 1], u - i), v - j);
  }

  /// Reads the cells of a level around some places in samples.
  Cells read_cells(int level, const std::vector<dvec2>& places) const {
    const detail::FileLevel from = detail::file_level_for(source_.levels(), level);
    const auto& [width, height] = source_.levels()[static_cast<std::size_t>(from.level)];
    Cells cells;
    cells.samples = std::ldexp(1.0, level);
    dvec2 low(1e9), high(-1e9);
    for (const dvec2& place : places) {
      low = glm::min(low, place / cells.samples);
      high = glm::max(high, place / cells.samples);
    }
    const dvec2 size((width + from.a_cell - 1) / from.a_cell,
                     (height + from.a_cell - 1) / from.a_cell);
    low = glm::clamp(glm::floor(low) - 1.0, dvec2(0.0), size);
    high = glm::clamp(glm::ceil(high) + 1.0, dvec2(0.0), size);
    cells.window = {static_cast<int>(low.x), static_cast<int>(low.y),
                    static_cast<int>(high.x - low.x), static_cast<int>(high.y - low.y)};
    const double count = (high.x - low.x) * (high.y - low.y);
    const double most = detail::kMostCells * made_.side * made_.side;
    if (count > most) {
      throw Error(ErrorKind::bad_data,
                  fmt::format("{}: the samples of the {} are too slanted to be used: {} cells of "
                              "them lie around one level of detail, at most {} are read",
                              source_.info().path.string(), words_.what, count, most));
    }
    cells.means.assign(static_cast<std::size_t>(count), Value{});
    if (cells.means.empty()) return cells;
    const int group = std::max(from.a_cell, detail::kRowsAtOnce / from.a_cell * from.a_cell);
    const std::int64_t first = std::int64_t{cells.window.row} * from.a_cell;
    const std::int64_t end = std::min<std::int64_t>(
        height, std::int64_t{cells.window.row + cells.window.height} * from.a_cell);
    tbb::parallel_for(std::int64_t{0}, (end - first + group - 1) / group,
                      [&, stop = current_stop()](std::int64_t k) {
                        stop_if_asked(stop);
                        add_rows(from, static_cast<int>(first + k * group),
                                 static_cast<int>(std::min(end, first + (k + 1) * group)), cells);
                      });
    return cells;
  }

  /// Adds the samples of some rows to the cells.
  void add_rows(const detail::FileLevel& from, int first, int end, Cells& cells) const {
    const int width = source_.levels()[static_cast<std::size_t>(from.level)][0];
    const float weight = 1.0f / static_cast<float>(from.a_cell) / static_cast<float>(from.a_cell);
    const int left = cells.window.column * from.a_cell;
    const int right = static_cast<int>(std::min<std::int64_t>(
        width, std::int64_t{cells.window.column + cells.window.width} * from.a_cell));
    std::vector<Value> samples;
    for (int row = first; row < end; row += detail::kRowsAtOnce) {
      for (int column = left; column < right; column += detail::kColumnsAtOnce) {
        const elevation::Window part{column, row, std::min(detail::kColumnsAtOnce, right - column),
                                     std::min(detail::kRowsAtOnce, end - row)};
        samples.resize(static_cast<std::size_t>(part.width) *
                       static_cast<std::size_t>(part.height));
        source_.read(from.level, part, samples.data());
        const Value* sample = samples.data();
        for (int j = 0; j < part.height; ++j) {
          Value* line = cells.means.data() +
                        static_cast<std::size_t>((row + j) / from.a_cell - cells.window.row) *
                            static_cast<std::size_t>(cells.window.width);
          for (int i = 0; i < part.width; ++i) {
            line[(column + i) / from.a_cell - cells.window.column] += weight * *sample++;
          }
        }
      }
    }
  }

  const Source& source_;
  const Placement& placement_;
  OverlayWords words_;
  double reach_m_;
  LevelLimits limits_;
  NestedLevels made_;
  int first_ = 0;
};

}  // namespace aerostat::land

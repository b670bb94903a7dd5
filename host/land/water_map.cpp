#include "land/water_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/cubic_spline.hpp"
#include "core/smooth_step.hpp"

namespace aerostat::land {
namespace {

constexpr float kNoLevel = std::numeric_limits<float>::quiet_NaN();
/// Levels are known so many cells from the water, which is as far as splines and banks reach.
constexpr float kLevelReach = 4.0f;
/// Near the shore, the distance is that of a smooth outline, which is a blurred mask. Its slope
/// across a straight shore is that of a normal distribution of one cell.
constexpr float kOutlineSlope = 0.39894228f;                 // 1 / sqrt(2 pi)
constexpr float kOutlineReach = 1.0f, kDistanceFrom = 3.0f;  // cells

constexpr float kFar = 1000.0f;  // distances from the shore are held within this, in cells

/// Cells along a side of the tiles that tell where water may be near. Water is known at least so
/// many cells from the shore, which is enough for meshes whose cells are 16 times as wide.
constexpr int kTile = 64;

/// A rectangle of tiles. `right` and `bottom` are beyond it.
struct TileBox {
  int left, top, right, bottom;

  bool meets(const TileBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  void cover(const TileBox& other) {
    left = std::min(left, other.left);
    top = std::min(top, other.top);
    right = std::max(right, other.right);
    bottom = std::max(bottom, other.bottom);
  }
};

bool has_water(const WetCells& cells, int tile_column, int tile_row) {
  const int right = std::min((tile_column + 1) * kTile, cells.width);
  const int bottom = std::min((tile_row + 1) * kTile, cells.height);
  for (int j = tile_row * kTile; j < bottom; ++j)
    for (int i = tile_column * kTile; i < right; ++i) {
      const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(cells.width) +
                             static_cast<std::size_t>(i);
      if (!std::isnan(cells.level_m[at])) return true;
    }
  return false;
}

/// Returns rectangles that do not meet and hold all water, with a tile around it.
std::vector<TileBox> boxes_around_water(const WetCells& cells, int across, int down) {
  std::vector<TileBox> boxes;
  const auto add = [&boxes](TileBox box) {
    for (std::size_t k = 0; k < boxes.size();) {
      if (!boxes[k].meets(box)) {
        ++k;
        continue;
      }
      box.cover(boxes[k]);
      boxes[k] = boxes.back();
      boxes.pop_back();
      k = 0;  // the larger box may meet those that the smaller one did not
    }
    boxes.push_back(box);
  };
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      if (!has_water(cells, i, j)) continue;
      add({std::max(i - 1, 0), std::max(j - 1, 0), std::min(i + 2, across), std::min(j + 2, down)});
    }
  return boxes;
}

/// Returns the cells of a rectangle of tiles.
WetCells cut_out(const WetCells& cells, const TileBox& box) {
  const int left = box.left * kTile, top = box.top * kTile;
  WetCells part{std::min(box.right * kTile, cells.width) - left,
                std::min(box.bottom * kTile, cells.height) - top,
                cells.samples_a_cell,
                {}};
  for (int j = top; j < top + part.height; ++j) {
    const auto row = cells.level_m.begin() +
                     static_cast<std::ptrdiff_t>(static_cast<std::size_t>(j) *
                                                     static_cast<std::size_t>(cells.width) +
                                                 static_cast<std::size_t>(left));
    part.level_m.insert(part.level_m.end(), row, row + part.width);
  }
  return part;
}

/// For each cell the distance to the nearest source in cells, within 8 %, and that source.
struct Nearest {
  std::vector<float> distance;
  std::vector<std::uint32_t> source;
};

/// Hands the sources of a grid on to all cells in two sweeps.
/// Source: G. Borgefors, "Distance transformations in digital images" (1986).
class Sweeps {
 public:
  Sweeps(int width, int height, const std::vector<std::uint8_t>& is_source)
      : width_(width), height_(height) {
    found_.distance.assign(is_source.size(), kInfinite);
    found_.source.assign(is_source.size(), 0);
    for (std::size_t at = 0; at < is_source.size(); ++at) {
      if (is_source[at] == 0) continue;
      found_.distance[at] = 0.0f;
      found_.source[at] = static_cast<std::uint32_t>(at);
    }
  }

  Nearest run() {
    for (int j = 0; j < height_; ++j) sweep_row(j, j - 1);
    for (int j = height_ - 1; j >= 0; --j) sweep_row(j, j + 1);
    return std::move(found_);
  }

 private:
  static constexpr float kInfinite = 1e9f;

  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(i);
  }

  void take(int i, int j, int from_i, int from_j, float step) {
    if (from_i < 0 || from_i >= width_ || from_j < 0 || from_j >= height_) return;
    const std::size_t at = index(i, j), from = index(from_i, from_j);
    if (found_.distance[from] + step >= found_.distance[at]) return;
    found_.distance[at] = found_.distance[from] + step;
    found_.source[at] = found_.source[from];
  }

  /// Takes what is nearest from the row before, and then along the row in both directions.
  void sweep_row(int j, int before) {
    for (int i = 0; i < width_; ++i) {
      take(i, j, i, before, 1.0f);
      take(i, j, i - 1, before, 1.41421356f);
      take(i, j, i + 1, before, 1.41421356f);
      take(i, j, i - 1, j, 1.0f);
    }
    for (int i = width_ - 2; i >= 0; --i) take(i, j, i + 1, j, 1.0f);
  }

  int width_, height_;
  Nearest found_;
};

/// Blurs a mask over about one cell to both sides, by binomial weights along rows and columns.
std::vector<float> blurred(int width, int height, const std::vector<std::uint8_t>& mask) {
  static constexpr std::array<float, 5> kWeights{1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16,
                                                 1.0f / 16};
  const auto along = [&](auto&& value, int count, std::size_t stride, std::size_t first, int at) {
    float sum = 0.0f;
    for (int k = -2; k <= 2; ++k) {
      const auto place = static_cast<std::size_t>(std::clamp(at + k, 0, count - 1));
      sum += kWeights[static_cast<std::size_t>(k + 2)] *
             static_cast<float>(value[first + place * stride]);
    }
    return sum;
  };
  const auto columns = static_cast<std::size_t>(width);
  std::vector<float> half(mask.size()), whole(mask.size());
  const auto each = [&](auto&& cell) {
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const auto& rows) {
      for (int j = rows.begin(); j != rows.end(); ++j)
        for (int i = 0; i < width; ++i)
          cell(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    });
  };
  each([&](std::size_t i, std::size_t j) {
    half[j * columns + i] = along(mask, width, 1, j * columns, static_cast<int>(i));
  });
  each([&](std::size_t i, std::size_t j) {
    whole[j * columns + i] = along(half, height, columns, i, static_cast<int>(j));
  });
  return whole;
}

/// Gives cells near those that have a level the level of the nearest one.
void spread_levels(int width, int height, float reach, std::vector<float>& levels) {
  std::vector<std::uint8_t> known(levels.size());
  for (std::size_t at = 0; at < levels.size(); ++at) known[at] = std::isnan(levels[at]) ? 0 : 1;
  const Nearest nearest = Sweeps(width, height, known).run();
  for (std::size_t at = 0; at < levels.size(); ++at) {
    if (known[at] == 0 && nearest.distance[at] <= reach) levels[at] = levels[nearest.source[at]];
  }
}

/// The cell of a place along one axis, and the share of the way from its middle to the next one's.
struct CellShare {
  int cell;
  float share;
};

CellShare cell_share(double place, int count) {
  const double held = std::clamp(place, 0.0, static_cast<double>(count - 1));
  const int cell = static_cast<int>(held);
  return {cell, static_cast<float>(held - cell)};
}

/// The four cells around a place along one axis with the weights of a smoothing spline.
struct Around {
  std::array<int, 4> cells;
  std::array<float, 4> weights;
};

Around around(const CellShare& place, int count) {
  const SplineWeights w = spline_weights(place.share);
  Around found{{}, {w.w0, w.w1, w.w2, w.w3}};
  for (int k = 0; k < 4; ++k) found.cells[k] = std::clamp(place.cell + k - 1, 0, count - 1);
  return found;
}

}  // namespace

WaterMap::WaterMap(const WetCells& cells)
    : samples_a_cell_(cells.samples_a_cell),
      width_(cells.width * cells.samples_a_cell),
      height_(cells.height * cells.samples_a_cell),
      tiles_across_((cells.width + kTile - 1) / kTile),
      tiles_down_((cells.height + kTile - 1) / kTile) {
  const std::vector<TileBox> boxes = boxes_around_water(cells, tiles_across_, tiles_down_);
  part_of_.assign(static_cast<std::size_t>(tiles_across_) * static_cast<std::size_t>(tiles_down_),
                  -1);
  parts_.resize(boxes.size());
  tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t k) {
    const TileBox& box = boxes[k];
    Part& part = parts_[k];
    part.column = box.left * kTile;
    part.row = box.top * kTile;
    part.layers.push_back(first_layer(cut_out(cells, box)));
    while (std::max(part.layers.back().width, part.layers.back().height) > 1) {
      part.layers.push_back(coarser(part.layers.back()));
    }
    for (int j = box.top; j < box.bottom; ++j)
      for (int i = box.left; i < box.right; ++i) {
        part_of_[static_cast<std::size_t>(j) * static_cast<std::size_t>(tiles_across_) +
                 static_cast<std::size_t>(i)] = static_cast<std::int32_t>(k);
      }
  });
}

WaterMap::Layer WaterMap::first_layer(const WetCells& cells) {
  Layer layer{cells.width, cells.height, {}, cells.level_m};
  std::vector<std::uint8_t> wet(cells.level_m.size()), dry(wet.size());
  for (std::size_t at = 0; at < wet.size(); ++at) {
    dry[at] = std::isnan(cells.level_m[at]) ? 1 : 0;
    wet[at] = 1 - dry[at];
  }
  layer.shore = blurred(cells.width, cells.height, wet);
  const std::vector<float> from_dry = Sweeps(cells.width, cells.height, dry).run().distance;
  const std::vector<float> from_wet = Sweeps(cells.width, cells.height, wet).run().distance;
  for (std::size_t at = 0; at < wet.size(); ++at) {
    const float distance = wet[at] != 0 ? from_dry[at] - 0.5f : 0.5f - from_wet[at];
    const float outline = (layer.shore[at] - 0.5f) / kOutlineSlope;
    const float share = smooth_step(kOutlineReach, kDistanceFrom, std::abs(distance));
    const float shore = outline + share * (distance - outline);
    layer.shore[at] = std::clamp(shore, -kFar, kFar);
  }
  spread_levels(cells.width, cells.height, kLevelReach, layer.level_m);
  return layer;
}

WaterMap::Layer WaterMap::coarser(const Layer& fine) {
  Layer layer{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, {}};
  for (int j = 0; j < layer.height; ++j)
    for (int i = 0; i < layer.width; ++i) {
      float shore = 0.0f, cells = 0.0f, level = 0.0f, levels = 0.0f;
      for (int v = 2 * j; v < std::min(2 * j + 2, fine.height); ++v)
        for (int u = 2 * i; u < std::min(2 * i + 2, fine.width); ++u) {
          const std::size_t at =
              static_cast<std::size_t>(v) * static_cast<std::size_t>(fine.width) +
              static_cast<std::size_t>(u);
          shore += fine.shore[at];
          cells += 1.0f;
          if (std::isnan(fine.level_m[at])) continue;
          level += fine.level_m[at];
          levels += 1.0f;
        }
      layer.shore.push_back(shore / cells);
      layer.level_m.push_back(levels > 0.0f ? level / levels : kNoLevel);
    }
  spread_levels(layer.width, layer.height, kLevelReach, layer.level_m);
  return layer;
}

WaterPoint WaterMap::layer_at(const Part& part, std::size_t number, double column,
                              double row) const {
  const Layer& layer = part.layers[number];
  const double cell = std::ldexp(static_cast<double>(samples_a_cell_), static_cast<int>(number));
  const CellShare across = cell_share((column + 0.5) / cell - 0.5, layer.width);
  const CellShare down = cell_share((row + 0.5) / cell - 0.5, layer.height);
  const auto middle = static_cast<std::size_t>(down.cell) * static_cast<std::size_t>(layer.width) +
                      static_cast<std::size_t>(across.cell);
  // Most of the land is far from water, where the distance need not be exact.
  if (std::isnan(layer.level_m[middle]) &&
      layer.shore[middle] < -std::ldexp(kLevelReach + 3.0f, static_cast<int>(number))) {
    return {layer.shore[middle] * static_cast<float>(samples_a_cell_), kNoLevel};
  }
  const Around u = around(across, layer.width), v = around(down, layer.height);
  float shore = 0.0f, level = 0.0f, weights = 0.0f;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t l = 0; l < 4; ++l) {
      const std::size_t at =
          static_cast<std::size_t>(v.cells[k]) * static_cast<std::size_t>(layer.width) +
          static_cast<std::size_t>(u.cells[l]);
      const float weight = v.weights[k] * u.weights[l];
      shore += weight * layer.shore[at];
      if (std::isnan(layer.level_m[at])) continue;
      level += weight * layer.level_m[at];
      weights += weight;
    }
  const float known = weights > 1e-6f ? level / weights : kNoLevel;
  return {shore * static_cast<float>(samples_a_cell_), known};
}

int WaterMap::tile_of(double place, int tiles) const {
  const double tile = (place + 0.5) / (static_cast<double>(samples_a_cell_) * kTile);
  return static_cast<int>(std::clamp(tile, 0.0, tiles - 1.0));
}

bool WaterMap::is_near(const dvec2& least, const dvec2& most) const {
  const int right = tile_of(most.x, tiles_across_), bottom = tile_of(most.y, tiles_down_);
  for (int j = tile_of(least.y, tiles_down_); j <= bottom; ++j)
    for (int i = tile_of(least.x, tiles_across_); i <= right; ++i) {
      if (part_of_[static_cast<std::size_t>(j) * static_cast<std::size_t>(tiles_across_) +
                   static_cast<std::size_t>(i)] >= 0) {
        return true;
      }
    }
  return false;
}

WaterPoint WaterMap::at(double column, double row, double samples) const {
  const std::int32_t number = part_of_[static_cast<std::size_t>(tile_of(row, tiles_down_)) *
                                           static_cast<std::size_t>(tiles_across_) +
                                       static_cast<std::size_t>(tile_of(column, tiles_across_))];
  if (number < 0) return {-kFar * static_cast<float>(samples_a_cell_), kNoLevel};
  const Part& part = parts_[static_cast<std::size_t>(number)];
  const double u = column - static_cast<double>(part.column) * samples_a_cell_;
  const double v = row - static_cast<double>(part.row) * samples_a_cell_;
  const double size = std::max(samples / samples_a_cell_, 1.0);
  const double detail = std::min(std::log2(size), static_cast<double>(part.layers.size()) - 1.0);
  const auto finer = static_cast<std::size_t>(detail);
  const auto share = static_cast<float>(detail - static_cast<double>(finer));
  WaterPoint point = layer_at(part, finer, u, v);
  if (share > 0.0f) {
    const WaterPoint coarse = layer_at(part, finer + 1, u, v);
    point.shore += share * (coarse.shore - point.shore);
    if (std::isnan(point.level_m)) {
      point.level_m = coarse.level_m;
    } else if (!std::isnan(coarse.level_m)) {
      point.level_m += share * (coarse.level_m - point.level_m);
    }
  }
  const double inside = std::min({column + 0.5, width_ - 0.5 - column, row + 0.5,
                                  height_ - 0.5 - row, static_cast<double>(point.shore)});
  point.shore = static_cast<float>(inside);
  return point;
}

}  // namespace aerostat::land

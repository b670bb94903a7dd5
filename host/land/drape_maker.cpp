// How the levels of a drape are made from a picture.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "geo/transform.hpp"
#include "land/drape.hpp"

namespace aerostat::land {
namespace {

constexpr int kNodes = 129;  // along a side of the lattice of a level
/// Pixels that are read at once.
constexpr int kRowsAtOnce = 256, kColumnsAtOnce = 4096;
/// A level's share of cells of the picture is at most so many times its texels. A square picture
/// needs 2 times as many if it is turned.
constexpr double kMostCells = 16.0;
constexpr int kPointsAnEdge = 17;
constexpr double kInside = 0.45;  // see kReachOfLevel in drape.cpp
/// The coarsest level has at most so many texels over the reach, so that land that is seen from
/// afar has texels as wide as pixels.
constexpr double kCoarsest = 1024.0;

/// Where points of the local frame lie in a picture.
class Placement {
 public:
  Placement(const elevation::Picture& picture, const LandPoint& middle)
      : info_(picture.info()), grid_(*info_.georeference), middle_(middle) {
    if (middle.place && grid_.crs.empty()) {
      throw Error(ErrorKind::bad_data,
                  fmt::format("{}: the picture does not say its coordinate reference system; "
                              "/terrain/drape/crs names it",
                              info_.path.string()));
    }
    if (!middle.place) return;
    transform_.emplace(grid_.crs, *middle.place);
    if (!geo::crs_info(grid_.crs).geographic) return;
    // Longitudes may count from 0 to 360 degrees in the picture.
    const double centre = grid_.origin.x + 0.5 * info_.width * grid_.per_column.x +
                          0.5 * info_.height * grid_.per_row.x;
    shift_.x = 360.0 * std::round((centre - middle.place->longitude_deg) / 360.0);
  }

  /// Turns points of the local frame into columns and rows, counted from the picture's corner.
  void to_picture(std::vector<dvec2>& points) const {
    if (transform_) {
      transform_->from_local(points);
    } else {
      for (dvec2& p : points) p = {middle_.own.x + p.x, middle_.own.y - p.y};
    }
    const glm::dmat2 inverse = glm::inverse(glm::dmat2(grid_.per_column, grid_.per_row));
    for (dvec2& p : points) {
      p = inverse * (p + shift_ - grid_.origin) + 0.5;
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) p = dvec2(-1e8);
      p = glm::clamp(p, dvec2(-1e8), dvec2(1e8));
    }
  }

  /// Returns the rectangle around the picture in the local frame: its least and its greatest
  /// coordinates.
  std::pair<dvec2, dvec2> bounds() const {
    std::vector<dvec2> points;
    for (int j = 0; j < kPointsAnEdge; ++j) {
      for (int i = 0; i < kPointsAnEdge; ++i) {
        const double column = info_.width * static_cast<double>(i) / (kPointsAnEdge - 1) - 0.5;
        const double row = info_.height * static_cast<double>(j) / (kPointsAnEdge - 1) - 0.5;
        points.push_back(grid_.origin + column * grid_.per_column + row * grid_.per_row - shift_);
      }
    }
    if (transform_) {
      transform_->to_local(points);
    } else {
      for (dvec2& p : points) p = {p.x - middle_.own.x, middle_.own.y - p.y};
    }
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::pair<dvec2, dvec2> box{dvec2(kFar), dvec2(-kFar)};
    for (const dvec2& p : points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
      box.first = glm::min(box.first, p);
      box.second = glm::max(box.second, p);
    }
    return box;
  }

  /// Returns the width of a pixel at a point of the local frame in metres.
  double pixel_m(const dvec2& at) const {
    std::vector<dvec2> points{at, at + dvec2(1.0, 0.0), at + dvec2(0.0, 1.0)};
    to_picture(points);
    const dvec2 a = points[1] - points[0], b = points[2] - points[0];
    const double area = std::abs(a.x * b.y - a.y * b.x);
    return area > 0.0 ? 1.0 / std::sqrt(area) : 0.0;
  }

 private:
  const elevation::RasterInfo& info_;
  const elevation::Georeference& grid_;
  LandPoint middle_;
  std::optional<geo::Transform> transform_;
  dvec2 shift_{0.0};
};

/// A window of the picture in cells of some pixels a side, each with the mean of its pixels.
struct Cells {
  elevation::Window window;  // in cells
  double pixels = 1.0;       // of the whole picture along a side of a cell
  std::vector<vec4> means;

  vec4 mean(int column, int row) const {
    if (column < 0 || row < 0 || column >= window.width || row >= window.height) {
      return vec4(0.0f);
    }
    return means[static_cast<std::size_t>(row) * static_cast<std::size_t>(window.width) +
                 static_cast<std::size_t>(column)];
  }

  /// Returns the mean around a place in pixels from the picture's corner.
  vec4 at(const dvec2& place) const {
    const dvec2 p = place / pixels - 0.5 - dvec2(window.column, window.row);
    if (!(p.x > -1.0 && p.y > -1.0 && p.x < window.width && p.y < window.height)) {
      return vec4(0.0f);
    }
    const dvec2 cell = glm::floor(p);
    const vec2 share(p - cell);
    const int i = static_cast<int>(cell.x), j = static_cast<int>(cell.y);
    return glm::mix(glm::mix(mean(i, j), mean(i + 1, j), share.x),
                    glm::mix(mean(i, j + 1), mean(i + 1, j + 1), share.x), share.y);
  }
};

/// A level of the picture's file, and how many of its pixels are a side of a cell.
struct Source {
  int level = 0;
  int a_cell = 1;
};

/// Chooses the coarsest overview of half the size of a cell or less, because many overviews are
/// single pixels of the picture and no means.
Source source_for(const elevation::Picture& picture, int level) {
  Source chosen{0, 1 << level};
  const auto& sizes = picture.levels();
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    const double factor = static_cast<double>(sizes[0][0]) / sizes[k][0];
    const double rounded = std::exp2(std::round(std::log2(factor)));
    if (std::abs(factor / rounded - 1.0) > 0.002 || 2.0 * rounded > (1 << level)) continue;
    chosen = {static_cast<int>(k), (1 << level) / static_cast<int>(rounded)};
  }
  return chosen;
}

/// Adds the pixels of some rows to the cells.
void add_rows(const elevation::Picture& picture, const Source& source, int first, int end,
              Cells& cells) {
  const auto& [width, height] = picture.levels()[static_cast<std::size_t>(source.level)];
  const float weight = 1.0f / static_cast<float>(source.a_cell) / static_cast<float>(source.a_cell);
  const int left = cells.window.column * source.a_cell;
  const int right = static_cast<int>(std::min<std::int64_t>(
      width, std::int64_t{cells.window.column + cells.window.width} * source.a_cell));
  end = std::min(end, height);
  std::vector<vec4> pixels;
  for (int row = first; row < end; row += kRowsAtOnce) {
    for (int column = left; column < right; column += kColumnsAtOnce) {
      const elevation::Window part{column, row, std::min(kColumnsAtOnce, right - column),
                                   std::min(kRowsAtOnce, end - row)};
      pixels.resize(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
      picture.read(source.level, part, pixels.data());
      const vec4* from = pixels.data();
      for (int j = 0; j < part.height; ++j) {
        vec4* line = cells.means.data() +
                     static_cast<std::size_t>((row + j) / source.a_cell - cells.window.row) *
                         static_cast<std::size_t>(cells.window.width);
        for (int i = 0; i < part.width; ++i) {
          line[(column + i) / source.a_cell - cells.window.column] += weight * *from++;
        }
      }
    }
  }
}

/// Reads the cells of a level around some places in pixels.
Cells read_cells(const elevation::Picture& picture, int level, const std::vector<dvec2>& places,
                 double most_cells) {
  const Source source = source_for(picture, level);
  const auto& [width, height] = picture.levels()[static_cast<std::size_t>(source.level)];
  Cells cells;
  cells.pixels = std::ldexp(1.0, level);
  dvec2 low(1e9), high(-1e9);
  for (const dvec2& place : places) {
    low = glm::min(low, place / cells.pixels);
    high = glm::max(high, place / cells.pixels);
  }
  const dvec2 size((width + source.a_cell - 1) / source.a_cell,
                   (height + source.a_cell - 1) / source.a_cell);
  low = glm::clamp(glm::floor(low) - 1.0, dvec2(0.0), size);
  high = glm::clamp(glm::ceil(high) + 1.0, dvec2(0.0), size);
  cells.window = {static_cast<int>(low.x), static_cast<int>(low.y),
                  static_cast<int>(high.x - low.x), static_cast<int>(high.y - low.y)};
  const double count = (high.x - low.x) * (high.y - low.y);
  if (count > most_cells) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: the pixels of the picture are too slanted to be used: {} cells of "
                            "them lie around one level of detail, at most {} are read",
                            picture.info().path.string(), count, most_cells));
  }
  cells.means.assign(static_cast<std::size_t>(count), vec4(0.0f));
  if (cells.means.empty()) return cells;
  const int group = std::max(source.a_cell, kRowsAtOnce / source.a_cell * source.a_cell);
  const std::int64_t first = std::int64_t{cells.window.row} * source.a_cell;
  const std::int64_t end = std::min<std::int64_t>(
      height, std::int64_t{cells.window.row + cells.window.height} * source.a_cell);
  const std::stop_token stop = current_stop();
  tbb::parallel_for(std::int64_t{0}, (end - first + group - 1) / group, [&](std::int64_t k) {
    stop_if_asked(stop);
    add_rows(picture, source, static_cast<int>(first + k * group),
             static_cast<int>(std::min(end, first + (k + 1) * group)), cells);
  });
  return cells;
}

}  // namespace

class Drape::Maker {
 public:
  Maker(const DrapeOptions& options, Drape& drape)
      : picture_(elevation::open_picture(options.file, options.picture)),
        placement_(*picture_, options.middle),
        drape_(drape) {
    lay_out(options);
    const auto side = static_cast<std::size_t>(drape.side_);
    drape.texels_.assign(static_cast<std::size_t>(drape.levels_) * side * side, 0u);
    for (int level = 0; level < drape.levels_; ++level) fill(level);
  }

 private:
  /// Chooses the middle, the size and the number of the levels.
  void lay_out(const DrapeOptions& options) {
    auto [low, high] = placement_.bounds();
    const dvec2 reach(options.reach_m);
    const dvec2 nearest = glm::clamp(dvec2(0.0), low, high);
    if (!(low.x < high.x && low.y < high.y) ||
        glm::any(glm::greaterThan(glm::abs(nearest), reach))) {
      throw Error(
          ErrorKind::bad_data,
          fmt::format("{}: the picture does not lie on the land: its nearest point is {:.4g} "
                      "km from the terrain's centre, which reaches {:.4g} km; "
                      "/terrain/drape/crs may be wrong",
                      options.file.string(), 1e-3 * glm::length(nearest), 1e-3 * options.reach_m));
    }
    low = glm::max(low, -reach);
    high = glm::min(high, reach);
    drape_.middle_ = glm::clamp(dvec2(0.0), low, high);
    const dvec2 far = glm::max(high - drape_.middle_, drape_.middle_ - low);
    const double away = std::max(far.x, far.y);
    double texel = placement_.pixel_m(0.5 * (low + high));
    texel =
        std::max(texel, away / (kInside * kMostDrapeSide * std::ldexp(1.0, kMostDrapeLevels - 1)));
    int side = kLeastDrapeSide;
    while (side < kMostDrapeSide && kInside * side * texel < away) side *= 2;
    int levels = 1;
    const auto is_enough = [&] {
      const double wide = std::ldexp(texel, levels - 1);
      return kInside * side * wide >= away && wide * kCoarsest >= options.reach_m;
    };
    while (levels < kMostDrapeLevels && !is_enough()) ++levels;
    drape_.side_ = side;
    drape_.levels_ = levels;
    drape_.texel_m_ = texel;
    // The cells of the first level are the pixels, or as many of them as a texel has.
    first_ = std::max(
        0,
        static_cast<int>(std::lround(std::log2(texel / placement_.pixel_m(0.5 * (low + high))))));
  }

  /// Fills the texels of a level.
  void fill(int level) {
    const int side = drape_.side_;
    const double texel = std::ldexp(drape_.texel_m_, level);
    const double half = 0.5 * side * texel;
    std::vector<dvec2> nodes;
    for (int j = 0; j < kNodes; ++j) {
      for (int i = 0; i < kNodes; ++i) {
        nodes.push_back(drape_.middle_ + half * (2.0 * dvec2(i, j) / (kNodes - 1.0) - 1.0));
      }
    }
    placement_.to_picture(nodes);
    const Cells cells =
        read_cells(*picture_, level + first_, nodes, kMostCells * side * static_cast<double>(side));
    std::uint32_t* const texels = drape_.texels_.data() + static_cast<std::size_t>(level) *
                                                              static_cast<std::size_t>(side) *
                                                              static_cast<std::size_t>(side);
    if (cells.means.empty()) return;
    tbb::parallel_for(0, side, [&](int row) {
      const double v = (row + 0.5) / side * (kNodes - 1);
      for (int column = 0; column < side; ++column) {
        const double u = (column + 0.5) / side * (kNodes - 1);
        texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
               static_cast<std::size_t>(column)] = packed_texel(cells.at(between(nodes, u, v)));
      }
    });
  }

  /// Returns the place between the nodes of a lattice.
  static dvec2 between(const std::vector<dvec2>& nodes, double u, double v) {
    const int i = std::min(static_cast<int>(u), kNodes - 2);
    const int j = std::min(static_cast<int>(v), kNodes - 2);
    const dvec2* at = nodes.data() + static_cast<std::size_t>(j) * kNodes + i;
    return glm::mix(glm::mix(at[0], at[1], u - i), glm::mix(at[kNodes], at[kNodes + 1], u - i),
                    v - j);
  }

  std::unique_ptr<elevation::Picture> picture_;
  Placement placement_;
  Drape& drape_;
  int first_ = 0;
};

Drape::Drape(const DrapeOptions& options) {
  Maker(options, *this);
}

}  // namespace aerostat::land

#include "land/reduce.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/stop_scope.hpp"

namespace aerostat::land {
namespace {

constexpr int kRowsAtOnce = 256;
constexpr int kColumnsAtOnce = 1 << 15;
constexpr std::size_t kSomeAChunk = 4096;  // samples of a chunk that tell the step of heights

/// The samples that cells are averaged from: those of the raster or of an overview.
struct Samples {
  const elevation::Raster* raster = nullptr;
  int overview = -1;
  int width = 0, height = 0;
  int a_cell = 1;  // samples along a side of a cell

  void read(const elevation::Window& window, float* heights) const {
    if (overview < 0) {
      raster->read(window, heights);
    } else {
      raster->read_overview(overview, window, heights);
    }
  }
};

/// Chooses the coarsest overview of half the size of a cell or less, whose samples fill cells
/// evenly.
Samples samples_for(const elevation::Raster& raster, int level) {
  const elevation::RasterInfo& info = raster.info();
  Samples chosen{&raster, -1, info.width, info.height, 1 << level};
  const std::vector<double> factors = raster.overview_factors();
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const double rounded = std::exp2(std::round(std::log2(factors[k])));
    // The sides of an overview are rounded, so that its factor is not exact.
    if (std::abs(factors[k] / rounded - 1.0) > 0.002 || 2.0 * rounded > (1 << level)) continue;
    const std::array<int, 2> size = raster.overview_size(static_cast<int>(k));
    chosen = {&raster, static_cast<int>(k), size[0], size[1],
              (1 << level) / static_cast<int>(rounded)};
  }
  return chosen;
}

/// Adds some samples that are no voids to a sum, and counts them.
void add_known(const float* samples, int count, double& sum, int& known) {
  for (int i = 0; i < count; ++i) {
    const bool is_known = samples[i] == samples[i];
    sum += is_known ? static_cast<double>(samples[i]) : 0.0;
    known += is_known ? 1 : 0;
  }
}

/// Averages the samples of a window into cells. The window begins at the corner of a cell.
void average(const std::vector<float>& samples, const elevation::Window& window, int a_cell,
             float* cells, int cells_stride) {
  const int columns = (window.width + a_cell - 1) / a_cell;
  std::vector<double> sums(static_cast<std::size_t>(columns));
  std::vector<int> counts(static_cast<std::size_t>(columns));
  for (int first = 0; first < window.height; first += a_cell) {
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(counts.begin(), counts.end(), 0);
    for (int j = first; j < std::min(first + a_cell, window.height); ++j) {
      const float* row =
          samples.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(window.width);
      for (int i = 0; i < columns; ++i) {
        const auto cell = static_cast<std::size_t>(i);
        add_known(row + i * a_cell, std::min(a_cell, window.width - i * a_cell), sums[cell],
                  counts[cell]);
      }
    }
    float* out =
        cells + static_cast<std::size_t>(first / a_cell) * static_cast<std::size_t>(cells_stride);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      out[i] = counts[i] > 0 ? static_cast<float>(sums[i] / counts[i])
                             : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

/// Returns how many cells a number of rows have.
std::size_t cells_before(int width, int rows) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
}

/// Returns the least multiple of `a_cell` that is at least `count`.
int rounded_up(int count, int a_cell) {
  return (count + a_cell - 1) / a_cell * a_cell;
}

}  // namespace

Reduced reduce(const elevation::Raster& raster, int level) {
  const Samples source = samples_for(raster, level);
  const int rows = rounded_up(kRowsAtOnce, source.a_cell);
  const int columns = rounded_up(kColumnsAtOnce, source.a_cell);
  const int across = (source.width + columns - 1) / columns;
  const int down = (source.height + rows - 1) / rows;
  Reduced reduced;
  reduced.width = (source.width + source.a_cell - 1) / source.a_cell;
  reduced.height = (source.height + source.a_cell - 1) / source.a_cell;
  reduced.heights.resize(static_cast<std::size_t>(reduced.width) *
                         static_cast<std::size_t>(reduced.height));
  std::vector<RasterStatistics> statistics(static_cast<std::size_t>(across) *
                                           static_cast<std::size_t>(down));
  std::vector<std::vector<float>> some(statistics.size());
  // Threads take chunks in the order of the file, so that they read the same large blocks.
  std::atomic<int> next{0};
  tbb::parallel_for(0, across * down, [&, stop = current_stop()](int) {
    stop_if_asked(stop);
    const int chunk = next++;
    elevation::Window window{chunk % across * columns, chunk / across * rows, 0, 0};
    window.width = std::min(columns, source.width - window.column);
    window.height = std::min(rows, source.height - window.row);
    std::vector<float> samples(static_cast<std::size_t>(window.width) *
                               static_cast<std::size_t>(window.height));
    source.read(window, samples.data());
    const auto place = static_cast<std::size_t>(chunk);
    statistics[place].add(samples);
    const std::size_t stride = std::max<std::size_t>(samples.size() / kSomeAChunk, 1);
    for (std::size_t k = 0; k < samples.size(); k += stride) some[place].push_back(samples[k]);
    const std::size_t cell = static_cast<std::size_t>(window.row / source.a_cell) *
                                 static_cast<std::size_t>(reduced.width) +
                             static_cast<std::size_t>(window.column / source.a_cell);
    average(samples, window, source.a_cell, reduced.heights.data() + cell, reduced.width);
  });
  for (const RasterStatistics& one : statistics) reduced.statistics.add(one);
  for (const std::vector<float>& heights : some) {
    reduced.some_heights.insert(reduced.some_heights.end(), heights.begin(), heights.end());
  }
  return reduced;
}

std::vector<float> reduced_window(const elevation::Raster& raster, int level,
                                  const elevation::Window& cells) {
  const Samples source = samples_for(raster, level);
  elevation::Window window{cells.column * source.a_cell, cells.row * source.a_cell, 0, 0};
  window.width = std::min(cells.width * source.a_cell, source.width - window.column);
  window.height = std::min(cells.height * source.a_cell, source.height - window.row);
  std::vector<float> samples(static_cast<std::size_t>(window.width) *
                             static_cast<std::size_t>(window.height));
  source.read(window, samples.data());
  std::vector<float> means(
      static_cast<std::size_t>(cells.width) * static_cast<std::size_t>(cells.height),
      std::numeric_limits<float>::quiet_NaN());
  average(samples, window, source.a_cell, means.data(), cells.width);
  return means;
}

std::vector<float> halved(int width, int height, const std::vector<float>& heights) {
  const int w = (width + 1) / 2, h = (height + 1) / 2;
  std::vector<float> half(cells_before(w, h));
  tbb::parallel_for(tbb::blocked_range<int>(0, h, 16), [&](const auto& rows) {
    for (int j = rows.begin(); j != rows.end(); ++j)
      for (int i = 0; i < w; ++i) {
        float sum = 0.0f, count = 0.0f;
        for (int v = 2 * j; v < std::min(2 * j + 2, height); ++v)
          for (int u = 2 * i; u < std::min(2 * i + 2, width); ++u) {
            const float value = heights[cells_before(width, v) + static_cast<std::size_t>(u)];
            if (std::isnan(value)) continue;
            sum += value;
            count += 1.0f;
          }
        half[cells_before(w, j) + static_cast<std::size_t>(i)] = sum / count;  // NaN without any
      }
  });
  return half;
}

}  // namespace aerostat::land

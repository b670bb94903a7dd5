#include "image/pixel_filter.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <oneapi/tbb/parallel_for.h>

namespace aerostat::image {
namespace {

/// Rows that are filtered one after the other. Bands of them are filtered at the same time.
constexpr std::size_t kBandRows = 64;

/// The rows of a layer and the weight of either neighbour.
template <typename T>
class LayerFilter {
 public:
  LayerFilter(std::span<T> pixels, std::size_t width, float side)
      : pixels_(pixels), width_(width), height_(pixels.size() / width), side_(side) {}

  void run() {
    const std::size_t bands = (height_ + kBandRows - 1) / kBandRows;
    // The rows above and below each band are kept as they are before the bands beside it change.
    std::vector<std::vector<T>> above(bands), below(bands);
    for (std::size_t band = 0; band < bands; ++band) {
      const std::size_t y0 = band * kBandRows, y1 = std::min(y0 + kBandRows, height_);
      if (y0 > 0) above[band] = copy_of(y0 - 1);
      if (y1 < height_) below[band] = copy_of(y1);
    }
    tbb::parallel_for(std::size_t{0}, bands, [&](std::size_t band) {
      filter_band(band * kBandRows, std::move(above[band]), below[band]);
    });
  }

 private:
  std::span<T> row(std::size_t y) const { return pixels_.subspan(y * width_, width_); }
  std::vector<T> copy_of(std::size_t y) const { return {row(y).begin(), row(y).end()}; }

  /// Filters the rows from y0 on. `above` and `below` are the rows beyond them, or empty.
  void filter_band(std::size_t y0, std::vector<T> above, std::span<const T> below) {
    const std::size_t y1 = std::min(y0 + kBandRows, height_);
    std::vector<T> here;
    std::vector<T> mixed(width_);
    for (std::size_t y = y0; y < y1; ++y) {
      here.assign(row(y).begin(), row(y).end());
      const std::span<const T> next = y + 1 < y1 ? std::span<const T>(row(y + 1)) : below;
      for (std::size_t x = 0; x < width_; ++x) {
        mixed[x] =
            mean(above.empty() ? nullptr : &above[x], here[x], next.empty() ? nullptr : &next[x]);
      }
      const std::span<T> out = row(y);
      for (std::size_t x = 0; x < width_; ++x) {
        out[x] = mean(x > 0 ? &mixed[x - 1] : nullptr, mixed[x],
                      x + 1 < width_ ? &mixed[x + 1] : nullptr);
      }
      std::swap(above, here);
    }
  }

  /// Returns the weighted mean of a value and its two neighbours, of which either may be null. It
  /// adds differences from the middle value, so that the mean of equal values is exactly their
  /// value.
  T mean(const T* before, const T& middle, const T* after) const {
    if (before != nullptr && after != nullptr) {
      return middle + ((*before - middle) + (*after - middle)) * side_;
    }
    const T* const only = before != nullptr ? before : after;
    return only == nullptr ? middle : middle + (*only - middle) * (side_ / (1.0f - side_));
  }

  std::span<T> pixels_;
  std::size_t width_, height_;
  float side_;
};

template <typename T>
void filter_layer(Array<T>& layer, int width, float side) {
  if (layer.empty()) return;
  LayerFilter<T>(std::span(layer), static_cast<std::size_t>(width), side).run();
}

template <typename T>
void cut_layer(Array<T>& layer, std::size_t width, const glm::ivec2& from, const glm::ivec2& size) {
  if (layer.empty()) return;
  const auto columns = static_cast<std::size_t>(size.x), rows = static_cast<std::size_t>(size.y);
  Array<T> cut;
  cut.resize(columns * rows);
  for (std::size_t y = 0; y < rows; ++y) {
    const std::size_t first =
        (y + static_cast<std::size_t>(from.y)) * width + static_cast<std::size_t>(from.x);
    std::ranges::copy(std::span(layer).subspan(first, columns),
                      std::span(cut).subspan(y * columns, columns).begin());
  }
  layer = std::move(cut);
}

}  // namespace

void filter_pixels(Film& film, float side) {
  if (side <= 0.0f) return;
  filter_layer(film.radiance, film.width, side);
  filter_layer(film.alpha, film.width, side);
  filter_layer(film.albedo, film.width, side);
  filter_layer(film.normal_ws, film.width, side);
}

void cut_to(Film& film, const glm::ivec2& first, const glm::ivec2& end) {
  const glm::ivec2 size = end - first, from = first - film.first;
  if (from == glm::ivec2(0) && size == glm::ivec2(film.width, film.height)) return;
  const auto width = static_cast<std::size_t>(film.width);
  cut_layer(film.radiance, width, from, size);
  cut_layer(film.alpha, width, from, size);
  cut_layer(film.distance_m, width, from, size);
  cut_layer(film.albedo, width, from, size);
  cut_layer(film.normal_ws, width, from, size);
  cut_layer(film.object_id, width, from, size);
  cut_layer(film.samples, width, from, size);
  film.first = first;
  film.width = size.x;
  film.height = size.y;
}

}  // namespace aerostat::image

#include "image/glare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include <tbb/parallel_for.h>

namespace aerostat::image {
namespace {

constexpr int kMostRows = 216;
/// The widths of the Gaussians: the standard deviation of the first as a share of the picture's
/// height, the factor from each to the next, and what each has of the light of the one before. The
/// sum falls about as r^-2.7, as light in an eye does beyond some degrees. Chosen by eye.
constexpr double kFirstSpread = 1.0 / 150.0;
constexpr int kSpreads = 7;
constexpr double kNextShare = 0.62;

/// Light on a grid.
struct Plane {
  int width = 0, height = 0;
  std::vector<vec3> cells;

  Plane(int columns, int rows)
      : width(columns),
        height(rows),
        cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), vec3(0.0f)) {}

  vec3& at(int x, int y) {
    return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)];
  }
  const vec3& at(int x, int y) const { return const_cast<Plane*>(this)->at(x, y); }
};

/// Returns the plane at half the size. Cells beyond an odd rim are dark.
Plane halved(const Plane& from) {
  Plane half((from.width + 1) / 2, (from.height + 1) / 2);
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) half.at(x / 2, y / 2) += 0.25f * from.at(x, y);
  }
  return half;
}

/// Returns the weights of a Gaussian at 0, 1, 2 ... cells, whose sum over both sides is 1.
std::vector<float> gaussian(double deviation) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * deviation)));
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = 0; i <= reach; ++i) {
    weights.push_back(std::exp(-0.5 * i * i / (deviation * deviation)));
    sum += (i == 0 ? 1.0 : 2.0) * weights.back();
  }
  std::vector<float> shares;
  for (const double weight : weights) shares.push_back(static_cast<float>(weight / sum));
  return shares;
}

/// Returns the plane blurred along x, with x and y swapped, so that two calls blur both ways.
Plane blurred_and_turned(const Plane& from, const std::vector<float>& weights) {
  Plane to(from.height, from.width);
  const int reach = static_cast<int>(weights.size()) - 1;
  tbb::parallel_for(0, from.height, [&](int y) {
    for (int x = 0; x < from.width; ++x) {
      vec3 sum(0.0f);
      for (int i = std::max(-reach, -x); i <= std::min(reach, from.width - 1 - x); ++i) {
        sum += weights[static_cast<std::size_t>(std::abs(i))] * from.at(x + i, y);
      }
      to.at(y, x) = sum;
    }
  });
  return to;
}

Plane blurred(const Plane& from, double deviation) {
  const std::vector<float> weights = gaussian(deviation);
  return blurred_and_turned(blurred_and_turned(from, weights), weights);
}

/// Returns the value between the middles of cells; columns and rows count from the rim.
vec3 between(const Plane& plane, double column, double row) {
  const double x = std::clamp(column - 0.5, 0.0, plane.width - 1.0);
  const double y = std::clamp(row - 0.5, 0.0, plane.height - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, plane.width - 1), y1 = std::min(y0 + 1, plane.height - 1);
  const auto u = static_cast<float>(x - x0), v = static_cast<float>(y - y0);
  return glm::mix(glm::mix(plane.at(x0, y0), plane.at(x1, y0), u),
                  glm::mix(plane.at(x0, y1), plane.at(x1, y1), u), v);
}

/// Adds a plane, whose cells are twice as wide, to a fine one.
void add_coarse(const Plane& coarse, Plane& fine) {
  tbb::parallel_for(0, fine.height, [&](int y) {
    for (int x = 0; x < fine.width; ++x) {
      fine.at(x, y) += between(coarse, 0.5 * (x + 0.5), 0.5 * (y + 0.5));
    }
  });
}

/// Adds the share of a plane to another one of the same size.
void add_share(const Plane& from, float share, Plane& to) {
  for (std::size_t i = 0; i < to.cells.size(); ++i) to.cells[i] += share * from.cells[i];
}

glm::ivec2 grid_of(const glm::ivec2& whole) {
  const int rows = std::clamp(whole.y, 1, kMostRows);
  const double columns = std::round(static_cast<double>(whole.x) * rows / std::max(whole.y, 1));
  return {std::clamp(static_cast<int>(columns), 1, std::max(whole.x, 1)), rows};
}

}  // namespace

Glare::Glare(const glm::ivec2& whole, const Development& development)
    : whole_(whole),
      size_(grid_of(whole)),
      share_(static_cast<float>(development.glare * kMostGlare)),
      exposure_(static_cast<float>(std::exp2(development.exposure_ev))),
      gathered_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), dvec3(0.0)) {
}

float Glare::lost_share(const vec3& radiance) const {
  const float peak = exposure_ * std::max({radiance.x, radiance.y, radiance.z});
  if (!(peak > static_cast<float>(kGlareFrom)) || !is_finite(radiance)) return 0.0f;
  return share_ * (1.0f - static_cast<float>(kGlareFrom) / peak);
}

void Glare::gather_row(const Film& film, int y) {
  const auto cell_row =
      static_cast<std::size_t>(static_cast<std::int64_t>(film.first.y + y) * size_.y / whole_.y);
  for (int x = 0; x < film.width; ++x) {
    const vec3& radiance =
        film.radiance[static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                      static_cast<std::size_t>(x)];
    const float lost = lost_share(radiance);
    if (lost <= 0.0f) continue;
    const auto column =
        static_cast<std::size_t>(static_cast<std::int64_t>(film.first.x + x) * size_.x / whole_.x);
    gathered_[cell_row * static_cast<std::size_t>(size_.x) + column] += dvec3(lost * radiance);
  }
}

void Glare::add(const Film& film) {
  if (share_ <= 0.0f) return;
  // Rows of pixels that share a row of cells are taken one after the other.
  const auto cell_row = [&](int y) {
    return static_cast<int>(static_cast<std::int64_t>(film.first.y + y) * size_.y / whole_.y);
  };
  if (film.height == 0) return;
  std::vector<int> firsts{0};
  for (int y = 1; y < film.height; ++y) {
    if (cell_row(y) != cell_row(y - 1)) firsts.push_back(y);
  }
  firsts.push_back(film.height);
  tbb::parallel_for(std::size_t{0}, firsts.size() - 1, [&](std::size_t i) {
    for (int y = firsts[i]; y < firsts[i + 1]; ++y) gather_row(film, y);
  });
}

void Glare::spread() {
  is_there_ = std::any_of(gathered_.begin(), gathered_.end(),
                          [](const dvec3& light) { return light != dvec3(0.0); });
  if (!is_there_) return;
  const double pixels = static_cast<double>(whole_.x) * whole_.y / (size_.x * size_.y);
  Plane level(size_.x, size_.y);
  std::transform(gathered_.begin(), gathered_.end(), level.cells.begin(),
                 [pixels](const dvec3& light) { return vec3(light / pixels); });
  double shares = 0.0;
  for (int i = 0; i < kSpreads; ++i) shares += std::pow(kNextShare, i);
  std::vector<Plane> sums{Plane(level.width, level.height)};
  for (int i = 0; i < kSpreads; ++i) {
    double deviation = kFirstSpread * size_.y * std::exp2(i + 1 - static_cast<int>(sums.size()));
    // Coarse cells are enough for wide Gaussians.
    for (; deviation > 4.0; deviation *= 0.5) {
      level = halved(level);
      sums.emplace_back(level.width, level.height);
    }
    add_share(blurred(level, std::max(deviation, 1e-3)),
              static_cast<float>(std::pow(kNextShare, i) / shares), sums.back());
  }
  for (std::size_t i = sums.size() - 1; i-- > 0;) add_coarse(sums[i + 1], sums[i]);
  spread_ = std::move(sums.front().cells);
}

vec3 Glare::at(double column, double row) const {
  const double x = std::clamp(column - 0.5, 0.0, size_.x - 1.0);
  const double y = std::clamp(row - 0.5, 0.0, size_.y - 1.0);
  const auto x0 = static_cast<std::size_t>(x), y0 = static_cast<std::size_t>(y);
  const auto columns = static_cast<std::size_t>(size_.x), rows = static_cast<std::size_t>(size_.y);
  const std::size_t x1 = std::min(x0 + 1, columns - 1), y1 = std::min(y0 + 1, rows - 1);
  const auto u = static_cast<float>(x - static_cast<double>(x0));
  const auto v = static_cast<float>(y - static_cast<double>(y0));
  return glm::mix(glm::mix(spread_[y0 * columns + x0], spread_[y0 * columns + x1], u),
                  glm::mix(spread_[y1 * columns + x0], spread_[y1 * columns + x1], u), v);
}

void Glare::apply(const Film& film, int x, int y, int count, float* light) const {
  const double across = static_cast<double>(size_.x) / whole_.x;
  const double row = (film.first.y + y + 0.5) * size_.y / whole_.y;
  const vec3* from =
      &film.radiance[static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                     static_cast<std::size_t>(x)];
  for (int i = 0; i < count; ++i) {
    const vec3 with =
        from[i] * (1.0f - lost_share(from[i])) + at((film.first.x + x + i + 0.5) * across, row);
    for (int c = 0; c < 3; ++c) light[3 * i + c] = with[c];
  }
}

}  // namespace aerostat::image

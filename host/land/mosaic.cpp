#include "land/mosaic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "elevation/open.hpp"

namespace aerostat::land {
namespace {

/// By how much of a sample rasters may be off one grid.
constexpr double kTolerance = 0.02;

/// A raster and the place of its first sample in the grid of another one.
struct Member {
  RasterPointer raster;
  int column = 0, row = 0;
};

/// Returns whether two steps of a grid are the same over the width of a raster.
bool same_step(const dvec2& a, const dvec2& b, int samples) {
  return glm::length(a - b) * samples <= kTolerance * glm::length(a);
}

/// Returns the place of a raster in the grid of another one, or nothing if it lies on another grid.
std::optional<Member> placed(const elevation::RasterInfo& grid, const RasterPointer& raster) {
  const elevation::RasterInfo& info = raster->info();
  if (!grid.georeference || !info.georeference) return std::nullopt;
  const elevation::Georeference &a = *grid.georeference, &b = *info.georeference;
  const int most = std::max({grid.width, grid.height, info.width, info.height});
  if (a.crs != b.crs || !same_step(a.per_column, b.per_column, most) ||
      !same_step(a.per_row, b.per_row, most)) {
    return std::nullopt;
  }
  const glm::dmat2 steps(a.per_column, a.per_row);
  if (!(std::abs(glm::determinant(steps)) > 0.0)) return std::nullopt;
  const dvec2 at = glm::inverse(steps) * (b.origin - a.origin);
  const dvec2 whole = glm::round(at);
  if (glm::length(at - whole) > kTolerance) return std::nullopt;
  if (std::max(std::abs(whole.x), std::abs(whole.y)) > elevation::kMostSamplesASide)
    return std::nullopt;
  return Member{raster, static_cast<int>(whole.x), static_cast<int>(whole.y)};
}

/// Several rasters on one grid.
class Mosaic final : public elevation::Raster {
 public:
  Mosaic(elevation::RasterInfo info, std::vector<Member> members)
      : Raster(std::move(info)), members_(std::move(members)) {}

  void read(const elevation::Window& window, float* heights) const override {
    const auto count =
        static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
    std::fill_n(heights, count, std::numeric_limits<float>::quiet_NaN());
    std::vector<float> part;
    for (const Member& member : members_) read_member(member, window, part, heights);
  }

 private:
  /// Fills in the samples of a window that are still without a height.
  static void read_member(const Member& member, const elevation::Window& window,
                          std::vector<float>& part, float* heights) {
    const elevation::RasterInfo& info = member.raster->info();
    const int left = std::max(window.column, member.column);
    const int top = std::max(window.row, member.row);
    const int right = std::min(window.column + window.width, member.column + info.width);
    const int bottom = std::min(window.row + window.height, member.row + info.height);
    if (left >= right || top >= bottom) return;
    const int width = right - left;
    part.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(bottom - top));
    member.raster->read({left - member.column, top - member.row, width, bottom - top}, part.data());
    for (int j = top; j < bottom; ++j) {
      const float* from =
          part.data() + static_cast<std::size_t>(j - top) * static_cast<std::size_t>(width);
      float* to =
          heights +
          static_cast<std::size_t>(j - window.row) * static_cast<std::size_t>(window.width) +
          (left - window.column);
      for (int i = 0; i < width; ++i) {
        if (std::isnan(to[i])) to[i] = from[i];
      }
    }
  }

  std::vector<Member> members_;
};

/// Makes one raster of members on the grid of the first one.
RasterPointer join(std::vector<Member> members) {
  if (members.size() == 1) return members[0].raster;
  int left = 0, top = 0, right = 0, bottom = 0;
  for (const Member& member : members) {
    left = std::min(left, member.column);
    top = std::min(top, member.row);
    right = std::max(right, member.column + member.raster->info().width);
    bottom = std::max(bottom, member.row + member.raster->info().height);
  }
  elevation::RasterInfo info = members[0].raster->info();
  info.width = right - left;
  info.height = bottom - top;
  info.notes.clear();
  elevation::Georeference& place = *info.georeference;
  place.origin +=
      static_cast<double>(left) * place.per_column + static_cast<double>(top) * place.per_row;
  for (Member& member : members) {
    member.column -= left;
    member.row -= top;
  }
  return std::make_shared<Mosaic>(std::move(info), std::move(members));
}

}  // namespace

std::vector<RasterPointer> joined(const std::vector<RasterPointer>& rasters) {
  std::vector<std::vector<Member>> groups;
  for (const RasterPointer& raster : rasters) {
    bool found = false;
    for (std::vector<Member>& group : groups) {
      const auto member = placed(group[0].raster->info(), raster);
      if (!member) continue;
      group.push_back(*member);
      found = true;
      break;
    }
    if (!found) groups.push_back({{raster, 0, 0}});
  }
  std::vector<RasterPointer> result;
  for (std::vector<Member>& group : groups) result.push_back(join(std::move(group)));
  return result;
}

}  // namespace aerostat::land

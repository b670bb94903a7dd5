#include "film/clearings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "scatter/obstacle.hpp"

namespace aerostat::film {
namespace {

constexpr double kStep_s = 0.1;
constexpr double kMostSteps = 2000.0;
/// The longest way between two circles. Each is wider by half of it, so that they cover all of the
/// way.
constexpr double kSpacing_m = 4.0;
/// The ground of a film and the mesh on which plants stand differ by less.
constexpr double kMargin_m = 5.0;

/// Makes the circles along the way of one flyer.
class Way {
 public:
  Way(const HeightAt& ground, std::size_t most) : ground_(ground), most_(most) {}

  /// Goes on to a place. The middle of the last circle is never farther than half of kSpacing_m
  /// from the place of a flyer that is low.
  void go(const Flyer& flyer) {
    if (is_low(flyer.place)) {
      add(flyer);
    } else {
      last_.reset();
    }
  }

  std::vector<scene::Clearing> take() { return std::move(circles_); }

 private:
  bool is_low(const dvec3& place) const {
    return place.y - ground_(place.x, place.z) < scatter::kClear_m + kMargin_m;
  }

  void add(const Flyer& flyer) {
    const dvec2 to(flyer.place.x, flyer.place.z);
    if (!last_) put(to, flyer.room_m);
    while (glm::distance(*last_, to) > 0.5 * kSpacing_m) {
      const dvec2 from = *last_;
      const double step = std::min(kSpacing_m, glm::distance(from, to));
      put(from + step * glm::normalize(to - from), flyer.room_m);
    }
  }

  void put(const dvec2& center, double room_m) {
    last_ = center;
    if (circles_.size() < most_) circles_.push_back({center, room_m + 0.5 * kSpacing_m});
  }

  const HeightAt& ground_;
  std::size_t most_;
  std::optional<dvec2> last_;  // the middle of the last circle, if the flyer is low
  std::vector<scene::Clearing> circles_;
};

}  // namespace

std::vector<scene::Clearing> clearings_along(
    const std::function<std::vector<Flyer>(double time_s)>& flyers_at, double duration_s,
    const HeightAt& ground) {
  const double step_s = std::max(kStep_s, duration_s / kMostSteps);
  const auto steps = static_cast<int>(std::ceil(duration_s / step_s));
  std::vector<Way> ways;
  for (int i = 0; i <= steps; ++i) {
    const std::vector<Flyer> flyers = flyers_at(std::min(i * step_s, duration_s));
    const std::size_t most = scene::kMostClearings / std::max<std::size_t>(flyers.size(), 1);
    while (ways.size() < flyers.size()) ways.emplace_back(ground, most);
    for (std::size_t k = 0; k < flyers.size(); ++k) ways[k].go(flyers[k]);
  }
  std::vector<scene::Clearing> all;
  for (Way& way : ways) {
    const std::vector<scene::Clearing> circles = way.take();
    all.insert(all.end(), circles.begin(), circles.end());
  }
  return all;
}

}  // namespace aerostat::film

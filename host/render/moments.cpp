#include "render/moments.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "film_pixel.h"
#include "render/film_sums.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {
namespace {

unsigned reversed(unsigned number, int bits) {
  unsigned turned = 0;
  for (int i = 0; i < bits; ++i) turned |= (number >> i & 1u) << (bits - 1 - i);
  return turned;
}

}  // namespace

std::vector<int> visits_of(int moments) {
  const auto count = static_cast<unsigned>(moments);
  const int bits = std::bit_width(std::bit_ceil(count)) - 1;
  std::vector<int> order;
  for (unsigned i = 0; i < std::bit_ceil(count); ++i) {
    if (reversed(i, bits) < count) order.push_back(static_cast<int>(reversed(i, bits)));
  }
  return order;
}

std::vector<int> visit_ends(int samples, int moments, bool is_adaptive) {
  std::vector<int> ends;
  if (is_adaptive) {
    const int each = std::max(1, AERO_LEAST_SAMPLES / moments);
    for (int end = each; end < samples; end += each) ends.push_back(end);
    ends.push_back(samples);
    return ends;
  }
  for (int visit = 1; visit <= moments; ++visit) {
    const int end = static_cast<int>(std::int64_t{samples} * visit / moments);
    if (end > (ends.empty() ? 0 : ends.back())) ends.push_back(end);
  }
  return ends;
}

image::Film render_moments(Session& session,
                           const std::function<scene::ResolvedScene(int moment)>& scene_at,
                           int moments, const std::stop_token& stop,
                           const ProgressCallback& progress) {
  const std::vector<int> order = visits_of(moments);
  const scene::ResolvedScene first = scene_at(order.front());
  const scene::Image& image = first->image;
  const std::vector<int> ends = visit_ends(image.spp, moments, image.adaptive_threshold > 0.0);
  std::shared_ptr<const FilmSums> sums;
  image::Film film;
  vec3 daylight{1.0f};
  for (std::size_t visit = 0; visit < ends.size(); ++visit) {
    const int moment = order[visit % order.size()];
    Course course;
    course.from = std::exchange(sums, nullptr);
    course.until = ends[visit];
    course.at_pause = [&sums](const Pause& pause) {
      sums = std::make_shared<const FilmSums>(pause.sums());
      return false;
    };
    film = session.render_on(visit == 0 ? first : scene_at(moment), course, stop, progress);
    if (visit == 0) daylight = film.daylight;
  }
  film.daylight = daylight;
  return film;
}

}  // namespace aerostat::render

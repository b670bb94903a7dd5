#include "render/passes.hpp"

#include <algorithm>

#include "film_pixel.h"
#include "render/tiles.hpp"

namespace aerostat::render {

PassPlan::PassPlan(const scene::Image& image, const Crop& crop, int lanes, bool filtered)
    : crop_(crop),
      width_(image.width),
      height_(image.height),
      samples_(image.spp),
      adaptive_(image.adaptive_threshold > 0.0),
      is_filtered_(filtered && image.filter != scene::Filter::box),
      lanes_(lanes) {}

int PassPlan::samples_from(int done) const {
  return samples_from(done, samples_);
}

int PassPlan::samples_from(int done, int end) const {
  const bool first_look = done == 0 && samples_ > lanes_;
  // Pixels are tested for convergence after the same numbers of samples, whatever the width of the
  // packets.
  const int round = done / AERO_LEAST_SAMPLES + 1;
  const int until = adaptive_ ? std::min(end, round * AERO_LEAST_SAMPLES) : end;
  return 1 << packet_shape(lanes_, first_look ? 1 : until - done).log2_samples;
}

bool PassPlan::decides_before(int done) const {
  return adaptive_ && done > 0 && done % AERO_LEAST_SAMPLES == 0;
}

int PassPlan::decisions_after(int done) const {
  return adaptive_ ? (samples_ - 1) / AERO_LEAST_SAMPLES - done / AERO_LEAST_SAMPLES : 0;
}

Crop PassPlan::area_from(int done) const {
  const int apron = decisions_after(done) + (is_filtered_ ? 1 : 0);
  return {std::max(crop_.x0 - apron, 0), std::max(crop_.y0 - apron, 0),
          std::min(crop_.x1 + apron, width_), std::min(crop_.y1 + apron, height_)};
}

std::uint64_t PassPlan::rays_until(int samples, int rows_left) const {
  std::uint64_t rays = 0;
  for (int done = 0; done < samples; done += samples_from(done, samples)) {
    rays += static_cast<std::uint64_t>(samples_from(done, samples)) * area_from(done).pixels();
  }
  const Crop now = area_from(samples);
  const Crop finished{0, 0, now.x1 - now.x0, std::max(0, now.y1 - now.y0 - rows_left)};
  return rays + static_cast<std::uint64_t>(samples_from(samples)) * finished.pixels();
}

std::uint64_t PassPlan::rays() const {
  std::uint64_t rays = 0;
  const int round = adaptive_ ? AERO_LEAST_SAMPLES : samples_;
  for (int done = 0; done < samples_; done += round) {
    const auto each = static_cast<std::uint64_t>(std::min(round, samples_ - done));
    rays += each * area_from(done).pixels();
  }
  return rays;
}

}  // namespace aerostat::render

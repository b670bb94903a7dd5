#pragma once

#include <cstdint>

#include "render/session.hpp"
#include "scene/picture.hpp"

namespace aerostat::render {

/// Plans the passes that take the samples of a crop, and the pixels of each pass. If samples are
/// adaptive, the number of samples of a pixel depends on its neighbours, and theirs on their
/// neighbours. The crop is therefore surrounded by an apron of pixels that are rendered too, so
/// that the crop is the same as in the whole image. The apron is one pixel wide for each decision
/// that is still to come, and another one if pixels are filtered with their neighbours.
class PassPlan {
 public:
  /// Plans the passes of `crop`. `lanes` is the width of the widest packets. `filtered` says
  /// whether pixels are filtered by the image's filter.
  PassPlan(const scene::Image& image, const Crop& crop, int lanes, bool filtered = true);

  /// Returns the number of samples per pixel in the pass that begins with sample `done`. It is as
  /// many as the widest packet holds, but no more than are left. The first pass of a long render is
  /// short, so that a picture is seen early. Samples are added in their order, so every bit of the
  /// result is the same.
  int samples_from(int done) const;
  /// Returns the number for a render that ends after `end` samples.
  int samples_from(int done, int end) const;
  /// Returns whether pixels are tested for convergence before the pass that begins with sample
  /// `done`.
  bool decides_before(int done) const;
  /// Returns the pixels of the pass that begins with sample `done`: the crop and the rest of the
  /// apron. No pass has more pixels than the first.
  Crop area_from(int done) const;
  /// Returns the number of eye rays of all passes if no pixel converges early.
  std::uint64_t rays() const;
  /// Returns how many of these rays a render has done whose passes have taken `samples` of each
  /// pixel, and in whose next pass `rows_left` rows still wait.
  std::uint64_t rays_until(int samples, int rows_left) const;

 private:
  int decisions_after(int done) const;

  Crop crop_;
  /// The size of the image in pixels.
  int width_, height_;
  int samples_;
  bool adaptive_, is_filtered_;
  int lanes_;
};

}  // namespace aerostat::render

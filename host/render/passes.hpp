#pragma once

#include <cstdint>

#include "render/session.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {

/// In which passes the samples of a crop are taken, and of which pixels. Where samples are
/// adaptive, whether a pixel takes more of them depends on its neighbours, and what those have
/// taken on theirs: around the crop lies an apron of pixels that are rendered too, so that the crop
/// is what the whole image would show there. It is one pixel wide for each decision that is still
/// to come.
class PassPlan {
 public:
  /// `lanes` is the width of the widest packets.
  PassPlan(const scene::Image& image, const Crop& crop, int lanes);

  /// How many samples the pass takes that begins with sample `done` of each pixel. As many as the
  /// widest packet holds, but no more than are left. A long render shows something early; samples
  /// are added in their order all the same, so every bit stays.
  int samples_from(int done) const;
  /// Whether it is decided before that pass which pixels take no more samples.
  bool decides_before(int done) const;
  /// The pixels of that pass: the crop and what is left of the apron. None has more than the first.
  Crop area_from(int done) const;
  /// Eye rays of all passes, if no pixel converges early.
  std::uint64_t rays() const;

 private:
  int decisions_after(int done) const;

  Crop crop_;
  int width_, height_;  // of the image
  int samples_;
  bool adaptive_;
  int lanes_;
};

}  // namespace aerostat::render

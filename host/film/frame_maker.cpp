#include "film/frame_maker.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/log.hpp"
#include "image/mark.hpp"
#include "image/write.hpp"
#include "render/development.hpp"
#include "render/moments.hpp"
#include "render/scene_cache.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"

namespace aerostat::film {
namespace {

render::Options settled(render::Options options, FrameFormat format) {
  options.contents =
      format == FrameFormat::png ? render::Contents::picture : render::Contents::layers;
  options.guides = format == FrameFormat::exr;
  return options;
}

}  // namespace

FrameMaker::FrameMaker(Timeline& timeline, render::Options options, FrameFormat format)
    : timeline_(timeline),
      format_(format),
      cache_(options.cache),
      session_(settled(std::move(options), format)),
      exposure_(timeline, [this](const scene::Scene& scene) { return metered_ev(scene); }) {}

void FrameMaker::begin_kernels() {
  session_.begin_kernels(timeline_.scene_at(1).light);
}

scene::ResolvedScene FrameMaker::resolved(const scene::Scene& scene) {
  return world::resolve(scene, cache_->reliefs);
}

/// Renders one pixel, because metering looks at the whole picture whatever part is rendered.
double FrameMaker::metered_ev(const scene::Scene& scene) {
  const render::Crop one{scene.image.width / 2, scene.image.height / 2, scene.image.width / 2 + 1,
                         scene.image.height / 2 + 1};
  return session_.render(resolved(scene), stop_, progress_, one).metered_ev;
}

/// Renders a frame, of which `scene` is the scene at its time.
image::Film FrameMaker::film_of(int frame, const scene::Scene& scene) {
  const int moments = timeline_.moments();
  if (moments == 1) return session_.render(resolved(scene), stop_, progress_);
  const auto at = [&](int moment) {
    scene::Scene then = timeline_.scene_at_time(timeline_.time_of_moment(frame, moment));
    // What belongs to the picture as a whole stays as it is at the frame's time.
    then.image = scene.image;
    then.image.spp = std::max(scene.image.spp, moments);
    return resolved(then);
  };
  return render::render_moments(session_, at, moments, stop_, progress_);
}

std::vector<std::uint8_t> FrameMaker::make(int frame, const std::string& mark,
                                           const std::stop_token& stop,
                                           const render::ProgressCallback& progress) {
  stop_ = stop;
  progress_ = progress;
  scene::Scene scene = timeline_.scene_at(frame);
  if (format_ == FrameFormat::png && !scene.image.exposure_ev) {
    scene.image.exposure_ev = exposure_.ev_at(timeline_.time_of(frame));
  }
  const image::Film film = film_of(frame, scene);
  if (film.nan_pixels > 0) {
    warn(fmt::format("frame {}: {} pixels were not a number (NaN) and were set to black", frame,
                     film.nan_pixels));
  }
  if (format_ == FrameFormat::exr) return image::encode_exr(film, mark);
  auto png = image::encode_png(image::develop(film, render::development_of(scene.image, film)));
  image::mark_png(png, mark);
  return png;
}

}  // namespace aerostat::film

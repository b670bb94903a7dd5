#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "image/film.hpp"
#include "render/session.hpp"
#include "scene/scene.hpp"
#include "world/surface.hpp"

namespace aerostat::render {

/// One of the pictures, each better than the one before, that a progressive render shows.
struct Look {
  image::Film film;
  scene::Scene scene;                             // resolved, at the size of the whole picture
  std::shared_ptr<const world::Surface> surface;  // of that scene
  int shrink = 1;                                 // the film's pixels are so many pixels wide
  int samples = 0;                                // per pixel
  bool rough = false;     // of a coarse land without plants, because the land is still to be built
  bool draft = false;     // without what the scene's quality asks for
  bool complete = false;  // this is the picture asked for
  Stats stats;            // of the part of the render that made it
  double seconds = 0.0;   // since the render began
};
using LookCallback = std::function<void(const Look&)>;

/// A step of a progressive render.
struct Step {
  int shrink = 1;
  bool draft = true;
};

/// The steps to a picture of `pixels` where `pixels_per_second` come out at draft quality: the
/// first is ready in `patience_s` if 16 times fewer pixels a side allow, each next one has half the
/// shrink. The last one is the picture itself; before it comes a draft of all pixels unless
/// `is_draft`, when the picture is no more than that.
std::vector<Step> steps_to(double pixels, double pixels_per_second, double patience_s,
                           bool is_draft);

/// Renders scenes so that something is seen at once: few large pixels first, then more, then the
/// samples and the light of the scene's quality. Where the land is to be built anew, a coarse one
/// comes first, and the fine one only when nothing was asked to stop for a moment, so that a slider
/// can be dragged. Not for use from two threads at once.
class Progressive {
 public:
  explicit Progressive(Options options);
  ~Progressive();
  Progressive(const Progressive&) = delete;
  Progressive& operator=(const Progressive&) = delete;

  /// Renders `scene` (not resolved) and shows what comes, on this thread, to the last look. If
  /// `stop` is requested, throws Error{interrupted} soon. Throws as Session::render does.
  void render(const scene::Scene& scene, const std::stop_token& stop, const LookCallback& show,
              const ProgressCallback& progress = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat::render

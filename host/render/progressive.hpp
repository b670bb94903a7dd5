#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "image/film.hpp"
#include "render/session.hpp"
#include "scene/resolved_scene.hpp"
#include "world/surface.hpp"

namespace aerostat::world {
struct SceneModels;
}

namespace aerostat::render {

/// One of the pictures that a progressive render shows. Each is better than the one before.
struct Preview {
  image::Film film;
  /// The scene at the size of the whole picture.
  scene::ResolvedScene scene;
  /// The surface of the scene.
  std::shared_ptr<const world::Surface> surface;
  /// The models from files of the scene.
  std::shared_ptr<const world::SceneModels> models;
  /// A pixel of the film is as wide as this number of pixels of the picture.
  int shrink = 1;
  /// The number of samples per pixel.
  int samples = 0;
  /// Tells whether the land is coarse and without plants, because the fine land is still to be
  /// built.
  bool rough = false;
  /// Tells whether the picture lacks what the scene's quality asks for.
  bool draft = false;
  /// Tells whether this is the picture that was asked for.
  bool complete = false;
  /// The statistics of the part of the render that made this picture.
  Stats stats;
  /// The seconds since the render began.
  double seconds = 0.0;
};
using PreviewCallback = std::function<void(const Preview&)>;

/// A step of a progressive render.
struct Step {
  int shrink = 1;
  bool draft = true;
};

/// Returns the steps to a picture of `pixels` pixels if a draft takes `pixels_per_second`. The
/// first step is ready in `patience_s` if pixels of at most 16 times the size allow that. Each next
/// step halves the shrink. The last step is the picture itself. A draft of all pixels comes before
/// it unless `is_draft`, which says that the picture is a draft itself.
std::vector<Step> steps_to(double pixels, double pixels_per_second, double patience_s,
                           bool is_draft);

/// Renders scenes so that something is seen at once. It shows few large pixels first, then more,
/// then the samples and the light of the scene's quality. If a new land has to be built, a coarse
/// land comes first. The fine land is built only if no stop is requested for a moment, so that a
/// slider can be dragged. It must not be used from two threads at once.
class Progressive {
 public:
  /// Makes a renderer of both lands. Its sessions are interactive whatever `options` say, and it
  /// ignores `carving`.
  explicit Progressive(Options options);
  /// Makes a renderer with hooks for tests (test_hooks.hpp).
  Progressive(Options options, const TestHooks& hooks);
  ~Progressive();
  Progressive(const Progressive&) = delete;
  Progressive& operator=(const Progressive&) = delete;

  /// Resolves and renders `scene`, and shows each preview on this thread up to the last.
  /// Throws Error{interrupted} soon after `stop` is requested. Throws as Session::render does.
  void render(const scene::Scene& scene, const std::stop_token& stop, const PreviewCallback& show,
              const ProgressCallback& progress = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat::render

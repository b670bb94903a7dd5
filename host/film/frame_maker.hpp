#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "film/exposure.hpp"
#include "film/frame_files.hpp"
#include "film/timeline.hpp"
#include "render/session.hpp"

namespace aerostat::film {

/// Renders frames one after the other with one session, so that what does not change between them
/// is built once.
class FrameMaker {
 public:
  /// Takes a timeline, which must outlive the maker, and the options of the session. They must name
  /// the cache whose relief the timeline uses. Contents and guides follow from the format.
  FrameMaker(Timeline& timeline, render::Options options, FrameFormat format);

  /// Begins to build the kernels in the background.
  void begin_kernels();

  /// Renders a frame and returns the bytes of its file, with the mark in it. Throws the errors of
  /// render::Session and Error{interrupted} if `stop` is requested.
  std::vector<std::uint8_t> make(int frame, const std::string& mark, const std::stop_token& stop,
                                 const render::ProgressCallback& progress);

 private:
  scene::ResolvedScene resolved(const scene::Scene& scene);
  image::Film film_of(int frame, const scene::Scene& scene);
  double metered_ev(const scene::Scene& scene);

  Timeline& timeline_;
  FrameFormat format_;
  std::shared_ptr<render::SceneCache> cache_;
  render::Session session_;
  Exposure exposure_;
  std::stop_token stop_;
  render::ProgressCallback progress_;
};

}  // namespace aerostat::film

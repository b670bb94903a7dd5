#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "render/session.hpp"

namespace aerostat::render {

/// Returns the moment, 0 to `moments` - 1, whose turn comes at each visit, one by one. Any run of
/// visits from the beginning is spread over all moments as evenly as it can be: the order is that
/// of J. G. van der Corput's sequence (1935), in which the bits of a number are reversed.
std::vector<int> visits_of(int moments);

/// Returns the numbers of samples after which one visit ends and the next one begins. The last one
/// is `samples`. Moments share the samples of a pixel evenly. If samples are adaptive, visits are
/// short, so that each decision on a pixel knows samples of 16 moments, or of all if there are
/// fewer.
std::vector<int> visit_ends(int samples, int moments, bool is_adaptive);

/// Renders a picture whose samples see a scene at several moments, such as those while a shutter is
/// open. `scene_at` returns the scene of a moment; its pictures must have the same size, samples
/// and lens. If all moments are the same scene, the film has the same bits as that of
/// Session::render. The light of day is that of moment 0. Throws the errors of Session::render_on.
image::Film render_moments(Session& session,
                           const std::function<scene::ResolvedScene(int moment)>& scene_at,
                           int moments, const std::stop_token& stop = {},
                           const ProgressCallback& progress = {});

}  // namespace aerostat::render

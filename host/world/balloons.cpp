#include "scene/balloons.hpp"

#include <algorithm>
#include <utility>

#include <oneapi/tbb/parallel_for.h>

#include "core/stop_scope.hpp"
#include "model/balloon.hpp"
#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"
#include "world/kinds.hpp"
#include "world/scene_models.hpp"
#include "world/special_envelope.hpp"

namespace aerostat::world {
namespace {

constexpr double kCoarseEnvelope_m = 0x1p-5, kCoarseBasket_m = 0x1p-8;

/// Returns the detail of a balloon for an eye whose position counts from where the balloon's does.
/// On a coarse land the balloon is coarse as well, even around an eye in its basket.
model::Detail detail_of(const scene::Balloon& balloon, const dvec3& eye,
                        const GroupRequest& request) {
  model::Detail detail = model::detail_for(balloon, eye, scene::pixel_size(*request.scene));
  if (request.carving == terrain::Carving::coarse) {
    detail.envelope_m = std::max(detail.envelope_m, kCoarseEnvelope_m);
    detail.basket_m = std::max(detail.basket_m, kCoarseBasket_m);
  }
  return detail;
}

Shape build(const GroupInput& input) {
  const auto balloons = scene::balloons_of(input.local);
  const dvec3 eye = input.request.scene.eye() - input.request.scene.origin();
  std::vector<Objects> built(balloons.size());
  tbb::parallel_for(std::size_t{0}, balloons.size(), [&, stop = current_stop()](std::size_t i) {
    stop_if_asked(stop);
    const model::Detail detail = detail_of(*balloons[i], eye, input.request);
    for (auto& part : model::balloon(*balloons[i], detail)) {
      if (part.id == scene::ObjectId::envelope && balloons[i]->envelope) {
        part.mesh = special_envelope(*balloons[i], *input.request.models->envelopes[i]);
      }
      if (part.id == scene::ObjectId::cables && balloons[i]->envelope) {
        cut_above_mouth(*balloons[i], part.mesh);
      }
      built[i].push_back({part.id, part.material, std::move(part.mesh), i});
    }
  });
  Objects objects;
  for (Objects& one : built) {
    for (Object& part : one) objects.push_back(std::move(part));
  }
  return objects;
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  if (now.models && before.models && now.models->envelopes != before.models->envelopes)
    return false;
  const auto a = scene::balloons_of(*now.scene), b = scene::balloons_of(*before.scene);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const scene::Balloon* one, const scene::Balloon* other) {
                      return *one == *other && detail_of(*one, now.scene.eye(), now) ==
                                                   detail_of(*other, before.scene.eye(), before);
                    });
}

std::vector<scatter::Obstacle> obstacles(const GroupRequest& request) {
  std::vector<scatter::Obstacle> found;
  for (const scene::Balloon* balloon : scene::balloons_of(*request.scene)) {
    found.push_back({balloon->position, balloon->diameter_m});
  }
  return found;
}

}  // namespace

const GroupKind kBalloons{.name = "balloons", .build = build, .same = same, .obstacles = obstacles};

}  // namespace aerostat::world

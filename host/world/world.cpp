#include "world/world.hpp"

#include <new>
#include <optional>
#include <utility>

#include <oneapi/tbb/parallel_invoke.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"

namespace aerostat::world {
namespace {

std::vector<scatter::Obstacle> obstacles_of(const GroupRequest& request, const GroupKinds& kinds) {
  std::vector<scatter::Obstacle> obstacles;
  for (const GroupKind* kind : kinds) {
    if (kind->obstacles == nullptr) continue;
    for (const scatter::Obstacle& one : kind->obstacles(request)) obstacles.push_back(one);
  }
  return obstacles;
}

GroupRequest request_for(const scene::ResolvedScene& scene,
                         std::shared_ptr<const SceneModels> models, const BuildOptions& options) {
  GroupRequest request{scene, std::move(models), options.where, options.carving};
  request.obstacles = obstacles_of(request, options.kinds);
  return request;
}

std::optional<GroupRequest> previous_request(const BuildOptions& options) {
  if (options.previous == nullptr) return std::nullopt;
  return request_for(options.previous->scene, options.previous->models, options);
}

std::shared_ptr<const SceneModels> models_for(const scene::Scene& scene,
                                              const BuildOptions& options) {
  return options.models != nullptr ? options.models->models_of(scene)
                                   : ModelCache().models_of(scene);
}

/// Builds groups, or takes them from the previous world.
class Builder {
 public:
  Builder(const scene::ResolvedScene& scene, const BuildOptions& options)
      : request_(request_for(scene, models_for(*scene, options), options)),
        before_(previous_request(options)),
        options_(options),
        local_(scene::counted_from_origin(scene)),
        reliefs_(options.reliefs != nullptr ? *options.reliefs : own_reliefs_) {}

  World run() {
    groups_.resize(options_.kinds.size());
    tbb::parallel_invoke(
        [this, stop = current_stop()] {
          const StopScope scope(stop);
          build_all(Footing::ground);
          build_all(Footing::on_ground);
        },
        [this, stop = current_stop()] {
          const StopScope scope(stop);
          build_all(Footing::none);
        });
    return {request_.scene, std::move(groups_), request_.models};
  }

 private:
  void build_all(Footing footing) {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const GroupKind& kind = *options_.kinds[i];
      if (kind.footing != footing) continue;
      const Group* kept = kept_group(kind);
      // Groups beside the ground are built while the ground is, so they must not look at it.
      const mesh::GridMesh* ground = footing == Footing::on_ground ? ground_ : nullptr;
      const GroupInput input{request_, local_, ground, reliefs_};
      groups_[i] = kept != nullptr ? *kept : make_group(kind, kind.build(input));
      if (footing != Footing::ground) continue;
      ground_is_kept_ = kept != nullptr;
      ground_ = std::get<HeightGrid>(*groups_[i].shape).mesh.get();
      request_.ground = ground_;
    }
  }

  /// Returns the previous group of a kind if it is still what the scene asks for, else null.
  const Group* kept_group(const GroupKind& kind) const {
    if (!before_ || before_->scene.origin() != request_.scene.origin()) return nullptr;
    if (kind.footing == Footing::on_ground && !ground_is_kept_) return nullptr;
    for (const Group& group : options_.previous->groups) {
      if (group.kind == &kind) return kind.same(request_, *before_) ? &group : nullptr;
    }
    return nullptr;
  }

  GroupRequest request_;
  /// The request that the previous world was built for, if there is one.
  std::optional<GroupRequest> before_;
  const BuildOptions& options_;
  scene::Scene local_;
  ReliefCache own_reliefs_;
  ReliefCache& reliefs_;
  std::vector<Group> groups_;
  const mesh::GridMesh* ground_ = nullptr;
  bool ground_is_kept_ = false;
};

}  // namespace

World build(const scene::ResolvedScene& scene, const BuildOptions& options) {
  try {
    return Builder(scene, options).run();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::exhausted,
                "not enough memory for the world's meshes; a smaller /terrain/cells needs less");
  }
}

}  // namespace aerostat::world

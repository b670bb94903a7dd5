#include "scene/resolved_scene.hpp"

#include <utility>

#include "scene/scene.hpp"

namespace aerostat::scene {

ResolvedScene::ResolvedScene(Scene scene, const dvec3& origin)
    : scene_(std::make_shared<const Scene>(std::move(scene))), origin_(origin) {}

const dvec3& ResolvedScene::eye() const {
  return *scene_->camera.position;
}

const dvec3& ResolvedScene::target() const {
  return *scene_->camera.target;
}

ResolvedScene ResolvedScene::counted_from(const dvec3& origin) const {
  ResolvedScene result = *this;
  result.origin_ = origin;
  return result;
}

ResolvedScene ResolvedScene::with_image(const Image& image) const {
  Scene changed = *scene_;
  changed.image = image;
  return {std::move(changed), origin_};
}

ResolvedScene ResolvedScene::seen_as(const ResolvedScene& other) const {
  Scene changed = *scene_;
  changed.camera = other->camera;
  changed.image = other->image;
  return {std::move(changed), origin_};
}

}  // namespace aerostat::scene

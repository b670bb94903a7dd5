#pragma once

#include <memory>

#include "core/math.hpp"

namespace aerostat::world {
class Resolver;
}

namespace aerostat::scene {

struct Image;
struct Scene;

/// A scene in which all values that depend on the land are settled. All heights count from the sea,
/// but for models from files that stand on the ground as it is rendered, and the camera has a
/// position and a target from which it has a view. The scene also has an origin. Only
/// world::resolve makes a resolved scene, and nothing changes it. It is cheap to copy, because
/// copies share the scene. To change a scene, change a copy of the Scene and resolve that again.
class ResolvedScene {
 public:
  const Scene& operator*() const { return *scene_; }
  const Scene* operator->() const { return scene_.get(); }

  /// The position and the target of the camera, in metres and above the sea.
  const dvec3& eye() const;
  const dvec3& target() const;

  /// The point that meshes and kernels count positions from (see local_frame.hpp).
  const dvec3& origin() const { return origin_; }

  /// Returns the same scene with another origin.
  ResolvedScene counted_from(const dvec3& origin) const;

  /// Returns the same scene with other settings of the picture.
  ResolvedScene with_image(const Image& image) const;

  /// Returns the same scene, with its origin, seen by the camera and in the picture of another one.
  ResolvedScene seen_as(const ResolvedScene& other) const;

 private:
  friend class world::Resolver;
  ResolvedScene(Scene scene, const dvec3& origin);

  std::shared_ptr<const Scene> scene_;
  dvec3 origin_;
};

}  // namespace aerostat::scene

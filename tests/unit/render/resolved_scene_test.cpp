// Tests that a scene which is not resolved cannot be passed to what needs a resolved one, and that
// only world::resolve makes a resolved one. These tests fail when they are compiled.
#include "scene/resolved_scene.hpp"

#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "air/light.hpp"
#include "pack/pack_air.hpp"
#include "pack/pack_balloon.hpp"
#include "pack/pack_scene.hpp"
#include "render/geometry.hpp"
#include "render/session.hpp"
#include "scatter/sight.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"
#include "world/world.hpp"

namespace aerostat {
namespace {

using scene::ResolvedScene;
using scene::Scene;

// Each of these says whether a function can be called with an S.
template <typename S>
concept Resolves = requires(const S& s, world::ReliefCache& reliefs,
                            const world::Surface& surface) {
  world::resolve(s);
  world::resolve(s, reliefs);
  world::resolve(s, surface);
};
template <typename S>
concept Builds = requires(const S& s) {
  world::build(s);
};
template <typename S>
concept BuildsGeometry = requires(const S& s) {
  render::build_geometry(s, nullptr);
};
template <typename S>
concept Renders = requires(const S& s, render::Session& session) {
  session.render(s);
};
template <typename S>
concept Packs = requires(const S& s) {
  pack::pack_scene(s);
};
template <typename S>
concept PacksFrame = requires(const S& s) {
  pack::pack_frame(s);
};
template <typename S>
concept PacksBalloon = requires(const S& s, const scene::Balloon& balloon) {
  pack::pack_balloon(s, balloon);
};
template <typename S>
concept PacksAir = requires(const S& s, air::ScatteringCache& cache) {
  pack::pack_air(s, cache);
};
template <typename S>
concept Lights = requires(const S& s) {
  air::Light(s);
};
template <typename S>
concept Scatters = requires(const S& s, const mesh::GridMesh& ground) {
  scatter::scatter(s, ground);
};
template <typename S>
concept Sees = requires(const S& s, const mesh::GridMesh& ground) {
  scatter::Sight(s, ground, 1.0, scatter::Extent{});
};
template <typename S>
concept Exports = requires(const S& s) {
  scene::origin_for_export(s);
};
template <typename S>
concept CountsFromOrigin = requires(const S& s) {
  scene::counted_from_origin(s);
};

template <typename S>
constexpr int kUses =
    Builds<S> + BuildsGeometry<S> + Renders<S> + Packs<S> + PacksFrame<S> + PacksBalloon<S> +
    PacksAir<S> + Lights<S> + Scatters<S> + Sees<S> + Exports<S> + CountsFromOrigin<S>;

TEST(ResolvedScene, AloneIsTakenByWhatNeedsIt) {
  static_assert(kUses<ResolvedScene> == 12);
  static_assert(kUses<Scene> == 0);
}

TEST(ResolvedScene, IsNotResolvedAgain) {
  static_assert(Resolves<Scene>);
  static_assert(!Resolves<ResolvedScene>);
}

TEST(ResolvedScene, IsMadeByNothingElse) {
  static_assert(!std::is_default_constructible_v<ResolvedScene>);
  static_assert(!std::is_constructible_v<ResolvedScene, Scene>);
  static_assert(!std::is_constructible_v<ResolvedScene, Scene, dvec3>);
  static_assert(!std::is_assignable_v<ResolvedScene&, Scene>);
  static_assert(!std::is_convertible_v<ResolvedScene, Scene>);
}

TEST(ResolvedScene, CannotBeChanged) {
  using Shown = decltype(*std::declval<ResolvedScene&>());
  static_assert(std::is_same_v<Shown, const Scene&>);
  static_assert(
      std::is_same_v<decltype(std::declval<ResolvedScene&>().operator->()), const Scene*>);
}

}  // namespace
}  // namespace aerostat

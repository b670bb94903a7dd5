// Tests long work of the host that is given up.
#include "core/stop_scope.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"
#include "world/world.hpp"

namespace aerostat {
namespace {

std::stop_token stopped() {
  std::stop_source source;
  source.request_stop();
  return source.get_token();
}

template <typename Work>
void expect_given_up(Work work) {
  const StopScope scope(stopped());
  try {
    work();
    FAIL() << "it came to its end";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

TEST(StopScope, TheInnermostCounts) {
  EXPECT_FALSE(current_stop().stop_possible());
  {
    const StopScope outer(stopped());
    EXPECT_THROW(stop_if_asked(current_stop()), Error);
    {
      const StopScope inner{std::stop_token()};
      EXPECT_NO_THROW(stop_if_asked(current_stop()));
    }
    EXPECT_THROW(stop_if_asked(current_stop()), Error);
  }
  EXPECT_FALSE(current_stop().stop_possible());
}

TEST(StopScope, ALandThatWasGivenUpIsBuiltAgain) {
  const scene::Scene scene = scene::read_text(
      R"({"version": 1, "terrain": {"cells": 64, "seed": 77}, "vegetation": {"reach_m": 300}})",
      "x");
  expect_given_up([&] { world::Surface{scene}; });
  const world::Surface surface(scene);
  const scene::ResolvedScene resolved = world::resolve(scene, surface);
  EXPECT_GT(surface.height(9000.0, 9000.0), 0.0);
  expect_given_up([&] { world::build(resolved); });
  const world::World world = world::build(resolved);
  EXPECT_EQ(world::shape_of<world::HeightGrid>(world, world::kLand)->mesh->columns(), 64u);
}

TEST(StopScope, GivesUpEachKindOfGroup) {
  const scene::ResolvedScene scene = world::resolve(scene::read_text(
      R"({"version": 1, "terrain": {"cells": 32}, "vegetation": {"reach_m": 300}})", "x"));
  for (const world::GroupKind* kind : {&world::kLand, &world::kBalloons}) {
    world::BuildOptions alone;
    alone.kinds = {kind};
    EXPECT_NO_THROW(world::build(scene, alone)) << kind->name;
    SCOPED_TRACE(kind->name);
    expect_given_up([&] { world::build(scene, alone); });
  }
}

}  // namespace
}  // namespace aerostat

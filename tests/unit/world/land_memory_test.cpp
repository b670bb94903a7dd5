#include "world/land_memory.hpp"

#include <gtest/gtest.h>

#include "support/error_of.hpp"
#include "support/resolved.hpp"
#include "world/world.hpp"

namespace aerostat::world {
namespace {

scene::Scene land_of(int cells) {
  scene::Scene scene;
  scene.terrain.cells = cells;
  return scene;
}

TEST(LandMemory, IsAskedForByTheNumberOfCells) {
  const MemoryLeft left{100ull << 20, "the limit of the test"};
  EXPECT_NO_THROW(require_memory_for_land(land_of(2048), left));
  EXPECT_THROW(require_memory_for_land(land_of(4096), left), Error);
}

TEST(LandMemory, RefusalNamesTheNeedTheBoundAndTheField) {
  const MemoryLeft left{100ull << 20, "the limit of the test"};
  const Error error = test::error_of([&] { require_memory_for_land(land_of(4096), left); });
  EXPECT_EQ(error.kind(), ErrorKind::exhausted);
  const std::string text = error.what();
  EXPECT_NE(text.find("4096 x 4096"), std::string::npos) << text;
  EXPECT_NE(text.find("288 MiB"), std::string::npos) << text;
  EXPECT_NE(text.find("the limit of the test leaves 100 MiB"), std::string::npos) << text;
  EXPECT_NE(text.find("/terrain/cells"), std::string::npos) << text;
}

TEST(LandMemory, IsAskedForBeforeALandIsBuilt) {
  // This land would need 288 TiB.
  scene::Scene huge = land_of(1 << 22);
  huge.balloon.enabled = false;
  huge.camera.position = {0.0, 1000.0, 0.0};
  huge.camera.target = {100.0, 1000.0, 0.0};
  const scene::ResolvedScene resolved = test::resolved(huge);
  EXPECT_EQ(test::error_of([&] { build(resolved); }).kind(), ErrorKind::exhausted);
}

}  // namespace
}  // namespace aerostat::world

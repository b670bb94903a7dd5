// Tests scenes from the whole schema. A scene that `check` accepts must render without a crash, and
// no pixel may be NaN or infinite.
#include "random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/error.hpp"
#include "pictures.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

/// Returns a scene that `aerostat check` accepts. Returns nothing if it is refused, which must have
/// a clear message.
std::optional<scene::Scene> checked(const std::string& text) {
  try {
    const scene::Scene scene = scene::read_text(text, "random.json");
    return *world::resolve(scene, world::Surface(scene, world::Carving::coarse));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data) << error.what();
    EXPECT_NE(std::string(error.what()).find(": found "), std::string::npos) << error.what();
    return std::nullopt;
  }
}

void expect_dump_reads_back(const scene::Scene& scene) {
  const std::string dump = scene::write_text(scene);
  for (const char* word : {"nan", "inf", "null"}) {
    EXPECT_EQ(dump.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(scene::write_text(scene::read_text(dump, "dump.json")), dump);
}

void expect_finite(const image::Film& film) {
  EXPECT_EQ(film.nan_pixels, 0u);
  for (const vec3& light : film.radiance) {
    ASSERT_TRUE(is_finite(light));
    ASSERT_GE(std::min({light.x, light.y, light.z}), 0.0f) << "no light is below none";
  }
  for (const vec3& normal : film.normal_ws) ASSERT_TRUE(is_finite(normal));
}

TEST(RandomScenes, AreRefusedOrRenderedInNumbers) {
  const std::uint32_t first = first_random_seed();
  const int count = random_scene_count(100);
  std::printf("seeds %u to %u\n", first, first + static_cast<std::uint32_t>(count) - 1u);
  render::Options coarse = options();
  coarse.carving = world::Carving::coarse;
  coarse.use = render::Use::single_picture;
  render::Session session(coarse);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t seed = first + static_cast<std::uint32_t>(i);
    const std::string text = random_scene(seed);
    const CrashNote note(seed, text);
    SCOPED_TRACE("AEROSTAT_RANDOM_SEED=" + std::to_string(seed) + ":\n" + text);
    const auto scene = checked(text);
    if (!scene) {
      ++refused;
      continue;
    }
    expect_dump_reads_back(*scene);
    try {
      expect_finite(session.render(resolved(made_quick(*scene))));
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    EXPECT_EQ(session.stats().tree.dropped_non_finite, 0u);
  }
  EXPECT_LE(4 * refused, count) << "the test looks at too few scenes";
}

}  // namespace
}  // namespace aerostat::test

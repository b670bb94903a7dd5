// A pixel does not depend on the tile that it is traced in, nor so on the time that tiles take.
#include <ostream>

#include "pictures.hpp"
#include "world/world.hpp"

namespace aerostat::test {
namespace {

/// Where rays begin on ground many kilometres away: the bottom rows are left out, which say nothing
/// new and take long.
struct Case {
  const char* scene;
  render::Crop crop;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.scene;
}

class Tiles : public testing::TestWithParam<Case> {};

scene::Scene standard_scene(const std::string& name) {
  scene::Scene scene = scene::read_file(
      std::string(AEROSTAT_SOURCE_DIR "/scenes/") + name + ".json",
      {{"/image/width", "320"}, {"/image/height", "180"}, {"/quality", "standard"}});
  world::resolve(scene);
  return scene;
}

TEST_P(Tiles, GiveTheSameBits) {
  const scene::Scene scene = standard_scene(GetParam().scene);
  image::Film first;
  for (const int pixels : {1000, 100000}) {
    render::Options chosen = options();
    chosen.tile_pixels = pixels;
    chosen.plants_in_sight_alone = true;
    render::Session session(chosen);
    image::Film film = session.render(scene, {}, {}, GetParam().crop);
    if (first.radiance.empty()) {
      first = std::move(film);
    } else {
      EXPECT_TRUE(same_bits(first, film)) << pixels << " pixels a tile";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FarGround, Tiles,
                         testing::Values(Case{"tropical", {0, 40, 320, 120}},
                                         Case{"sand-basket", {0, 20, 320, 100}}));

}  // namespace
}  // namespace aerostat::test

// Tests that a pixel depends neither on the tile in which it is traced nor on the time that tiles
// take.
#include "pictures.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

class Tiles : public testing::TestWithParam<const char*> {};

scene::Scene standard_scene(const std::string& name) {
  return *world::resolve(scene::read_file(
      std::string(AEROSTAT_SOURCE_DIR "/scenes/") + name + ".json",
      {{"/image/width", "320"}, {"/image/height", "180"}, {"/quality", "standard"}}));
}

TEST_P(Tiles, GiveTheSameBits) {
  const scene::Scene scene = standard_scene(GetParam());
  image::Film first;
  for (const int pixels : {1000, 100000}) {
    render::Options chosen = options();
    chosen.tile_pixels = pixels;
    chosen.use = render::Use::single_picture;
    render::Session session(chosen);
    image::Film film = session.render(resolved(scene));
    if (first.radiance.empty()) {
      first = std::move(film);
    } else {
      EXPECT_TRUE(same_bits(first, film)) << pixels << " pixels a tile";
    }
  }
}

// These scenes have many rays that begin on ground some ten kilometres away and hit slopes edge-on.
INSTANTIATE_TEST_SUITE_P(FarGround, Tiles, testing::Values("tropical", "sand-basket"));

}  // namespace
}  // namespace aerostat::test

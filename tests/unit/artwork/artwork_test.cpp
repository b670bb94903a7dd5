// Tests the unrolled cloth, the template of the gores and pictures that were drawn on it.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "artwork/gores.hpp"
#include "artwork/template.hpp"
#include "artwork/unrolled.hpp"
#include "model/envelope_shape.hpp"

namespace aerostat::artwork {
namespace {

TEST(Unrolled, HasTheMeasuresOfTheEnvelope) {
  scene::Balloon balloon;
  const Unrolled cloth(balloon);
  const model::EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  EXPECT_NEAR(cloth.height(), shape.plate_arc() - shape.mouth_arc(), 1e-9);
  EXPECT_NEAR(cloth.panels() * cloth.panel_height(), shape.disc_arc() - shape.mouth_arc(), 1e-9);
  EXPECT_NEAR(cloth.gore_width(0.0) * cloth.gores(), 2.0 * std::numbers::pi * shape.mouth_radius(),
              1e-6);
  EXPECT_NEAR(cloth.widest_gore() * cloth.gores(), std::numbers::pi * balloon.diameter_m, 1e-3);
  EXPECT_LT(cloth.gore_width(cloth.widest_height() - 0.5), cloth.widest_gore());
  EXPECT_LT(cloth.gore_width(cloth.widest_height() + 0.5), cloth.widest_gore());
}

/// The point of the fabric at the place of a direction lies in that direction.
TEST(Unrolled, KnowsDirections) {
  scene::Balloon balloon;
  const Unrolled cloth(balloon);
  const model::EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  for (const double around_deg : {0.0, 37.0, 90.0, 180.0, 271.0, -45.0}) {
    const double place = cloth.place_of(around_deg) + cloth.gores();
    const int gore = static_cast<int>(place);
    const auto point =
        shape.fabric(gore % cloth.gores(), place - gore, {shape.mouth_arc() + 9.0, 0.5}).position;
    // Ahead is -z, and to the right is +x.
    const double found = std::atan2(point.x, -point.z) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(std::remainder(found - around_deg, 360.0), 0.0, 0.2) << around_deg;
  }
}

TEST(Template, HasAnOutlineForEachGoreAndItsGuidesApart) {
  scene::Balloon balloon;
  balloon.gores = 16;
  const std::string svg = gores_template(balloon);
  std::size_t outlines = 0;
  for (std::size_t at = svg.find("<polygon"); at != std::string::npos;
       at = svg.find("<polygon", at + 1)) {
    ++outlines;
  }
  EXPECT_EQ(outlines, 16u);
  const std::size_t guides = svg.find("<g id=\"aerostat-guides\"");
  ASSERT_NE(guides, std::string::npos);
  EXPECT_GT(svg.find("<g id=\"artwork\">"), svg.rfind("<text")) << "the guides end before it";
  EXPECT_NE(svg.find(">10 m</text>"), std::string::npos);
  const Unrolled cloth(balloon);
  const double width = cloth.gores() * cloth.widest_gore();
  EXPECT_NEAR(std::stod(svg.substr(svg.find("viewBox=\"0 0 ") + 13)), width, 1e-2);
}

/// Each gore of the template is white between its outlines and black beside them. Straightened, all
/// is white but for the mixed pixels at the edges.
TEST(Straightened, FillsTheRoomBetweenGores) {
  scene::Balloon balloon;
  balloon.gores = 8;
  const Unrolled cloth(balloon);
  asset::Texture drawn{"drawn", 8 * 64, 128, {}};
  for (std::uint32_t y = 0; y < drawn.height; ++y) {
    const double height = (1.0 - (y + 0.5) / drawn.height) * cloth.height();
    for (std::uint32_t x = 0; x < drawn.width; ++x) {
      const double from_middle = (x % 64 + 0.5) / 64.0 - 0.5;
      const bool inside =
          std::abs(from_middle) < 0.5 * cloth.gore_width(height) / cloth.widest_gore();
      const auto grey = static_cast<std::uint8_t>(inside ? 255 : 0);
      drawn.rgba.insert(drawn.rgba.end(), {grey, grey, grey, 255});
    }
  }
  const asset::Texture flat = straightened(drawn, cloth);
  ASSERT_EQ(flat.rgba.size(), drawn.rgba.size());
  std::size_t white_before = 0, white = 0;
  for (std::size_t i = 0; i < flat.rgba.size(); i += 4) {
    white_before += drawn.rgba[i] > 250;
    white += flat.rgba[i] > 120;
  }
  EXPECT_LT(white_before, drawn.rgba.size() / 4 * 8 / 10);
  EXPECT_GT(white, flat.rgba.size() / 4 * 99 / 100);
}

}  // namespace
}  // namespace aerostat::artwork

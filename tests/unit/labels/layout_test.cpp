// Tests where names are put, and what is written of them.
#include "labels/layout.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "labels/write.hpp"

namespace aerostat::labels {
namespace {

bool meet(const Label& a, const Label& b) {
  return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y;
}

TEST(LabelLayout, NoTwoLabelsOverlap) {
  constexpr std::uint32_t kSeed = 7;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> x(0.0, 1280.0), y(150.0, 400.0);
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i) {
    points.push_back({std::string(3 + static_cast<std::size_t>(i % 17), 'n'),
                      {x(random), y(random)},
                      static_cast<double>(i)});
  }
  const std::vector<Label> labels = lay_out(points, {1280.0, 720.0});
  EXPECT_GT(labels.size(), 20u);
  EXPECT_LT(labels.size(), points.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_GE(labels[i].lo.x, 0.0);
    EXPECT_LE(labels[i].hi.x, 1280.0);
    EXPECT_GE(labels[i].lo.y, 0.0);
    for (std::size_t k = 0; k < labels.size(); ++k) {
      if (i == k) continue;
      EXPECT_FALSE(meet(labels[i], labels[k])) << i << " and " << k << ", seed " << kSeed;
      const Label line{"", {}, {labels[i].point.x, labels[i].hi.y}, labels[i].point};
      EXPECT_FALSE(meet(line, labels[k])) << "the line of " << i << " and " << k;
    }
  }
}

TEST(LabelLayout, TheHigherPlaceWins) {
  std::vector<Point> points(40, {"low", {100.0, 90.0}, 1.0});
  points.push_back({"high", {100.0, 90.0}, 2.0});
  EXPECT_EQ(lay_out(points, {200.0, 100.0}).front().name, "high");
}

NameInView seen(const std::string& name, const dvec2& pixel, bool hidden) {
  NameInView view;
  view.named = {name, {46.0, 9.0}, {}};
  view.height_m = 1234.0;
  view.pixel = pixel;
  view.distance_m = 5000.0;
  view.in_picture = true;
  view.hidden = hidden;
  return view;
}

TEST(LabelWriting, NamesAreNoMarkupAndHiddenOnesAreLeftOut) {
  const std::vector<std::uint8_t> png{'M', 'a', 'n', 'y'};
  const std::string svg =
      svg_text({seen("<b>&\"", {300.0, 200.0}, false), seen("unseen", {500.0, 200.0}, true)},
               {{100.0, 50.0}, {640.0, 360.0}}, png);
  EXPECT_NE(svg.find(">&lt;b&gt;&amp;&quot;</text>"), std::string::npos) << svg;
  EXPECT_EQ(svg.find("unseen"), std::string::npos);
  EXPECT_NE(svg.find("base64,TWFueQ==\""), std::string::npos);
  // Pixels count from the part's first one.
  EXPECT_NE(svg.find("d=\"M200.0 150.0V"), std::string::npos) << svg;
}

TEST(LabelWriting, JsonHasAllPlaces) {
  NameInView behind;
  behind.named = {"behind", {46.0, 9.0}, {}};
  const std::string json =
      json_text({seen("a", {300.5, 200.0}, true), behind}, {{100.0, 50.0}, {640.0, 360.0}});
  for (const char* piece : {"\"name\": \"a\"", "\"latitude\": 46.0", "\"x\": 200.5", "\"y\": 150.0",
                            "\"distance_m\": 5000.0", "\"hidden\": true", "\"x\": null"}) {
    EXPECT_NE(json.find(piece), std::string::npos) << piece << '\n' << json;
  }
}

}  // namespace
}  // namespace aerostat::labels

// Tests that an edited scene is written as the shortest text with the same meaning.
#include "scene/source.hpp"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "scene/field_rule.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {
namespace {

SceneSource source(const std::string& body) {
  return SceneSource::from_text("{\"version\": 1" + (body.empty() ? "" : ", " + body) + "}",
                                "test");
}

/// Expects that the text is read back as the same scene.
void expect_kept(const SceneSource& source) {
  const std::string text = source.text();
  const SceneSource again = SceneSource::from_text(text, "again");
  EXPECT_EQ(write_text(again.scene()), write_text(source.scene())) << text;
  EXPECT_EQ(again.text(), text);
}

TEST(SceneSource, KnowsTheUsualDropletsOfTheVisibility) {
  const SceneSource hazy = SceneSource().with({{"/haze/visibility_m", "500"}});
  EXPECT_TRUE(hazy.differs("/haze/visibility_m"));
  EXPECT_FALSE(hazy.differs("/haze/angstrom"));
  EXPECT_FALSE(hazy.differs("/haze/albedo"));
  EXPECT_EQ(hazy.scene().haze.angstrom, 0.0);
  EXPECT_EQ(hazy.without({"/haze/visibility_m"}).scene().haze.angstrom,
            SceneSource().scene().haze.angstrom);
  EXPECT_EQ(SceneSource::from_text(hazy.text(), "again").scene().haze.visibility_m, 500.0);
}

TEST(SceneSource, SaysOnlyWhatDiffers) {
  EXPECT_EQ(SceneSource().text(), "{\n  \"version\": 1,\n  \"biome\": \"snow\"\n}\n");
  const auto edited = source(R"("biome": {"kind": "sand", "water": {"enabled": false}})")
                          // 320 is the default.
                          .with({{"/terrain/height_m", "320"},
                                 {"/balloon/gores", "30"},
                                 {"/quality", "final"},
                                 // 256 is the value of the quality.
                                 {"/image/spp", "256"}});
  EXPECT_EQ(edited.text(),
            "{\n  \"version\": 1,\n  \"biome\": \"sand\",\n  \"balloon\": {\n    \"gores\": 30\n  "
            "},\n  \"quality\": \"final\"\n}\n");
  expect_kept(edited);
}

TEST(SceneSource, KeepsTheScenesOfTheProject) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(AEROSTAT_SOURCE_DIR "/scenes")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".json") || name.ends_with(".schema.json")) continue;
    SCOPED_TRACE(name);
    expect_kept(SceneSource::from_file(entry.path()));
    ++count;
  }
  EXPECT_GE(count, 7);
}

TEST(SceneSource, ASceneWrittenInFullBecomesShort) {
  for (const BiomeKind kind :
       {BiomeKind::snow, BiomeKind::tropical, BiomeKind::sand, BiomeKind::meadow}) {
    for (const View view : {View::outside, View::basket}) {
      const auto full = SceneSource::from_text(write_text(defaults(kind, view)), "full");
      EXPECT_LT(full.text().size(), 100u) << full.text();
      expect_kept(full);
    }
  }
}

TEST(SceneSource, EditsLeaveTheFormerAlone) {
  const auto before = source(R"("biome": "tropical")");
  const auto after = before.with({{"/terrain/seed", "7"}});
  EXPECT_EQ(before.value("/terrain/seed"), "1");
  EXPECT_EQ(after.value("/terrain/seed"), "7");
  EXPECT_FALSE(before.differs("/terrain/seed"));
  EXPECT_TRUE(after.differs("/terrain/seed"));
  EXPECT_EQ(after.without({"/terrain/seed"}).text(), before.text());
}

TEST(SceneSource, ElementsOfArraysGoBackToTheirDefaults) {
  const auto moved = source("").with({{"/balloon/position/0", "50"}, {"/balloon/position/2", "7"}});
  EXPECT_EQ(moved.value("/balloon/position"), "[50.0,420.0,7.0]");
  EXPECT_TRUE(moved.differs("/balloon/position/0"));
  const auto back = moved.without({"/balloon/position/0"});
  EXPECT_EQ(back.scene().balloon.position, dvec3(0.0, 420.0, 7.0));
  EXPECT_FALSE(back.differs("/balloon/position/0"));
}

TEST(SceneSource, ObjectsOfAListGoBackToTheirDefaults) {
  const auto two = source(R"("balloons": [{}, {"position": [10, 20, 30], "gores": 12}])");
  EXPECT_FALSE(two.differs("/balloons/1/heading_deg"));
  EXPECT_TRUE(two.differs("/balloons/1/gores"));
  const auto plain = two.without({"/balloons/1/gores", "/balloons/1/position/1"});
  EXPECT_EQ(plain.scene().balloons[1].gores, scene::Balloon().gores);
  EXPECT_EQ(plain.scene().balloons[1].position, dvec3(10.0, 0.0, 30.0));
  EXPECT_FALSE(plain.differs("/balloons/1/gores"));
  // A balloon whose place is not given is moved along one axis.
  EXPECT_EQ(two.with({{"/balloons/0/position/1", "70"}}).scene().balloons[0].position,
            dvec3(0.0, 70.0, 0.0));
  expect_kept(two);
  const auto lamp = SceneSource().with({{"/lights/0", R"({"position": [1, 2, 3]})"}});
  EXPECT_FALSE(lamp.differs("/lights/0/intensity"));
  EXPECT_TRUE(lamp.differs("/lights/0/position/1"));
  expect_kept(lamp);
}

TEST(SceneSource, TheSunByAnglesOrByDate) {
  EXPECT_EQ(SceneSource().value("/sun/azimuth_deg"), "-130.0");
  const auto turned =
      SceneSource().with({{"/sun/azimuth_deg", "90"}, {"/sun/elevation_deg", "15"}});
  EXPECT_EQ(turned.value("/sun/elevation_deg"), "15");
  expect_kept(turned);
  const auto dated = turned.with({{"/sun/date", "2024-06-21"},
                                  {"/sun/time", "06:30+02:00"},
                                  {"/sun/latitude_deg", "46.5"},
                                  {"/sun/longitude_deg", "7.7"}});
  EXPECT_EQ(dated.value("/sun/time"), "\"06:30+02:00\"");
  EXPECT_TRUE(dated.differs("/sun/date"));
  EXPECT_NE(dated.text().find("2024-06-21"), std::string::npos);
  expect_kept(dated);
}

TEST(SceneSource, ErrorsNameThePointer) {
  try {
    SceneSource().with({{"/image/width", "0"}});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_NE(std::string(error.what()).find("/image/width"), std::string::npos) << error.what();
  }
}

TEST(SceneSource, ChangesLeadFromOneToTheOther) {
  const auto base = source(R"("biome": "sand", "balloon": {"heading_deg": 20, "gores": 12})");
  const auto here = base.with({{"/terrain/seed", "3"}, {"/balloon/colors", "[[1,0,0]]"}})
                        .without({"/balloon/heading_deg"});
  const auto changes = here.changes_from(base);
  ASSERT_TRUE(changes);
  EXPECT_EQ(changes->size(), 3u);
  EXPECT_EQ(write_text(base.with(*changes).scene()), write_text(here.scene()));
  EXPECT_TRUE(here.changes_from(here)->empty());
  const auto basket = source(R"("camera": {"view": "basket", "target": [0, 0, -9]})");
  EXPECT_FALSE(basket.without({"/camera/target"}).changes_from(basket));
}

TEST(FieldRule, AllValuesAreNamed) {
  const auto pointers = field_pointers();
  for (const char* const one : {"/image/width", "/biome/ground/snow", "/materials/rim/specular",
                                "/balloons/0/position", "/lights/0/color", "/sky/cumulus/seed"}) {
    EXPECT_EQ(std::count(pointers.begin(), pointers.end(), one), 1) << one;
  }
  for (const std::string& one : pointers) EXPECT_NO_THROW(field_rule(one)) << one;
}

TEST(FieldRule, SaysWhatTheSchemaSays) {
  const FieldRule seed = field_rule("/terrain/seed");
  EXPECT_EQ(seed.type, FieldType::integer);
  EXPECT_EQ(seed.maximum, 4294967295.0);
  EXPECT_FALSE(seed.description.empty());
  EXPECT_EQ(field_rule("/biome/kind").words.size(), 4u);
  EXPECT_EQ(field_rule("/biome/water/enabled").type, FieldType::boolean);
  EXPECT_EQ(field_rule("/materials/envelope/diffuse").maximum, 10.0);
  const FieldRule x = field_rule("/balloon/position/0");
  EXPECT_EQ(x.type, FieldType::number);
  EXPECT_FALSE(x.description.empty());
  EXPECT_EQ(field_rule("/balloon/colors").type, FieldType::array);
  EXPECT_THROW(field_rule("/terrain/sed"), Error);
}

TEST(SceneSource, NamesFilesFromAFolder) {
  const SceneSource source =
      SceneSource().with({{"/objects/0", R"({"file": "/land/village/models/church.obj"})"},
                          {"/vegetation/species/0", R"({"file": "/land/village/oak.glb"})"},
                          {"/balloon/artwork/0", R"({"file": "/land/logo.svg"})"}});
  const std::string whole = source.text();
  EXPECT_NE(whole.find("\"/land/village/models/church.obj\""), std::string::npos);
  const std::string text = source.text_in("/land/village");
  EXPECT_NE(text.find("\"models/church.obj\""), std::string::npos);
  EXPECT_NE(text.find("\"oak.glb\""), std::string::npos);
  EXPECT_NE(text.find("\"/land/logo.svg\""), std::string::npos);
  EXPECT_EQ(source.files_outside("/land/village"), std::vector<std::string>{"/land/logo.svg"});
  EXPECT_TRUE(source.files_outside("/land").empty());
  EXPECT_EQ(source.files_outside("/land/villa").size(), 3u);
}

TEST(SceneSource, KeepsSpeciesOfPlants) {
  const SceneSource source = SceneSource().with(
      {{"/vegetation/species/0", R"({"file": "oak.glb", "share": 0.25, "cover": ["woods"]})"},
       {"/vegetation/usual", "false"}});
  const SceneSource again = SceneSource::from_text(source.text(), "again");
  EXPECT_TRUE(again.scene().vegetation == source.scene().vegetation);
  EXPECT_EQ(again.scene().vegetation.species[0].cover, std::vector<CoverClass>{CoverClass::woods});
  const SceneSource usual = source.without({"/vegetation/species/0/share"});
  EXPECT_EQ(usual.scene().vegetation.species[0].share, PlantSpecies().share);
  EXPECT_EQ(source.without({"/vegetation/species/0/file"}).text(), source.text());
  const auto fault = [](const char* species) {
    try {
      SceneSource().with({{"/vegetation/species/0", species}});
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(fault(R"({"file": "a.obj", "height_m": [5, 4]})").find("height_m"), std::string::npos);
  EXPECT_NE(fault(R"({"file": "a.obj", "slope_deg": [5, 4]})").find("slope_deg"),
            std::string::npos);
  EXPECT_NE(fault(R"({"file": "a.obj", "heights_m": [5, 4]})").find("heights_m"),
            std::string::npos);
  EXPECT_NE(fault(R"({"file": ""})").find("an empty name"), std::string::npos);
  EXPECT_NE(fault(R"({"file": "a.obj", "cover": ["lava"]})").find("cover"), std::string::npos);
}

}  // namespace
}  // namespace aerostat::scene

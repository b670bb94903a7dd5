#include "elevation/geokeys.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "geo/transform.hpp"

namespace aerostat::elevation {
namespace {

struct Double {
  std::uint16_t key;
  double value;
};

/// Returns keys of codes and of numbers, with a citation if it is not empty.
GeoKeys keys_of(const std::vector<std::pair<std::uint16_t, std::uint16_t>>& codes,
                const std::vector<Double>& numbers, const std::string& citation = "",
                std::uint16_t citation_key = 3073) {
  std::vector<std::uint16_t> directory{1, 1, 0, 0};
  std::vector<double> doubles;
  for (const auto& [key, code] : codes) directory.insert(directory.end(), {key, 0, 1, code});
  for (const Double& number : numbers) {
    directory.insert(directory.end(),
                     {number.key, 34736, 1, static_cast<std::uint16_t>(doubles.size())});
    doubles.push_back(number.value);
  }
  const std::string texts = citation.empty() ? "" : citation + "|";
  if (!citation.empty()) {
    directory.insert(directory.end(),
                     {citation_key, 34737, static_cast<std::uint16_t>(texts.size()), 0});
  }
  directory[3] = static_cast<std::uint16_t>(directory.size() / 4 - 1);
  return GeoKeys(directory, doubles, texts);
}

struct ProjectionRow {
  const char* what;
  std::vector<std::pair<std::uint16_t, std::uint16_t>> codes;
  std::vector<Double> numbers;
  const char* same_as;  // a code of EPSG or a PROJ string
  geo::Place place;     // where both are compared
};

const std::vector<ProjectionRow> kProjections = {
    {"transverse Mercator",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3075, 1}},
     {{3080, 9.0}, {3081, 0.0}, {3082, 500000.0}, {3083, 0.0}, {3092, 0.9996}},
     "EPSG:32632",
     {46.8, 9.9}},
    {"UTM by its code",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3074, 16132}},
     {},
     "EPSG:32732",
     {-20.0, 9.9}},
    {"transverse Mercator of MGI",
     {{1024, 1}, {3072, 32767}, {2048, 4312}, {3075, 1}},
     {{3080, 10.0 + 1.0 / 3.0}, {3081, 0.0}, {3083, -5000000.0}, {3092, 1.0}},
     "EPSG:31254",
     {46.9, 10.3}},
    {"Lambert, 2 parallels",
     {{1024, 1}, {3072, 32767}, {2048, 4171}, {3075, 8}},
     {{3078, 49.0}, {3079, 44.0}, {3084, 3.0}, {3085, 46.5}, {3086, 700000.0}, {3087, 6600000.0}},
     "EPSG:2154",
     {45.9, 6.9}},
    {"Lambert of MGI",
     {{1024, 1}, {3072, 32767}, {2048, 4312}, {3075, 8}},
     {{3078, 49.0},
      {3079, 46.0},
      {3080, 13.0 + 1.0 / 3.0},
      {3081, 47.5},
      {3082, 400000.0},
      {3083, 400000.0}},
     "EPSG:31287",
     {47.2, 11.4}},
    {"Lambert, 1 parallel",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3075, 9}},
     {{3080, 10.0}, {3081, 46.0}, {3092, 0.9998}, {3082, 1000.0}, {3083, 2000.0}},
     "+proj=lcc +lat_1=46 +lat_0=46 +lon_0=10 +k_0=0.9998 +x_0=1000 +y_0=2000 +datum=WGS84",
     {46.8, 9.9}},
    {"equal area",
     {{1024, 1}, {3072, 32767}, {2048, 4258}, {3075, 10}},
     {{3088, 10.0}, {3089, 52.0}, {3082, 4321000.0}, {3083, 3210000.0}},
     "EPSG:3035",
     {46.8, 9.9}},
    {"Albers",
     {{1024, 1}, {3072, 32767}, {2048, 4269}, {3075, 11}},
     {{3078, 29.5}, {3079, 45.5}, {3080, -96.0}, {3081, 23.0}},
     "EPSG:5070",
     {40.0, -105.0}},
    {"polar by its scale",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3075, 15}},
     {{3081, 90.0}, {3095, 0.0}, {3092, 0.994}, {3082, 2000000.0}, {3083, 2000000.0}},
     "EPSG:32661",
     {85.0, 30.0}},
    {"polar by its parallel",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3075, 15}},
     {{3081, -71.0}, {3095, 0.0}, {3092, 1.0}},
     "EPSG:3031",
     {-78.0, 160.0}},
    {"Mercator",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3075, 7}},
     {{3080, 0.0}, {3081, 0.0}, {3092, 1.0}},
     "EPSG:3395",
     {46.8, 9.9}},
    {"Mercator by its parallel",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3075, 7}},
     {{3080, 5.0}, {3078, 40.0}},
     "+proj=merc +lon_0=5 +lat_ts=40 +datum=WGS84",
     {46.8, 9.9}},
    {"feet",
     {{1024, 1}, {3072, 32767}, {2048, 4269}, {3075, 8}, {3076, 9003}},
     {{3078, 35.4666666666667},
      {3079, 34.0333333333333},
      {3084, -118.0},
      {3085, 33.5},
      {3086, 6561666.66666667},
      {3087, 1640416.66666667}},
     "EPSG:2229",
     {34.2, -118.1}},
    {"oblique stereographic",
     {{1024, 1}, {3072, 32767}, {2048, 4289}, {3075, 16}},
     {{3080, 5.38763888888889},
      {3081, 52.1561605555556},
      {3092, 0.9999079},
      {3082, 155000.0},
      {3083, 463000.0}},
     "EPSG:28992",
     {51.0, 5.9}},
    {"oblique Mercator",
     {{1024, 1}, {3072, 32767}, {2048, 4326}, {3075, 9815}},
     {{3088, 9.0}, {3089, 46.0}, {3093, 1.0}, {3094, 30.0}, {3096, 30.0}},
     "+proj=omerc +lat_0=46 +lonc=9 +alpha=30 +gamma=30 +k=1 +datum=WGS84",
     {46.8, 9.9}},
    {"oblique of Switzerland",
     {{1024, 1}, {3072, 32767}, {2048, 4149}, {3075, 5}},
     {{3088, 7.43958333333333}, {3089, 46.9524055555556}, {3082, 600000.0}, {3083, 200000.0}},
     "EPSG:21781",
     {46.8, 9.9}},
    {"datum by its code",
     {{1024, 1}, {3072, 32767}, {2048, 32767}, {2050, 6267}, {3074, 16010}},
     {},
     "EPSG:26710",
     {46.2, -122.2}},
    {"ellipsoid by its axes",
     {{1024, 1}, {3072, 32767}, {2048, 32767}, {3075, 1}},
     {{2057, 6378137.0}, {2059, 298.257223563}, {3080, 9.0}, {3082, 500000.0}, {3092, 0.9996}},
     "EPSG:32632",
     {46.8, 9.9}},
    {"degrees by parameters",
     {{1024, 2}, {2048, 32767}, {2056, 7030}},
     {},
     "EPSG:4326",
     {46.8, 9.9}},
};

TEST(GeoKeys, DescribeProjectionsByParameters) {
  for (const ProjectionRow& row : kProjections) {
    const GeoKeyCrs crs = crs_of(keys_of(row.codes, row.numbers));
    ASSERT_FALSE(crs.crs.empty()) << row.what;
    dvec2 point(1000.0, 2000.0);
    geo::Transform(row.same_as, row.place).from_local({&point, 1});
    geo::Transform(crs.crs, row.place).to_local({&point, 1});
    EXPECT_NEAR(point.x, 1000.0, 0.01) << row.what << ' ' << crs.crs;
    EXPECT_NEAR(point.y, 2000.0, 0.01) << row.what << ' ' << crs.crs;
  }
}

TEST(GeoKeys, NameSystemsByCodes) {
  EXPECT_EQ(crs_of(keys_of({{1024, 1}, {3072, 32632}}, {})).crs, "EPSG:32632");
  EXPECT_EQ(crs_of(keys_of({{3072, 3794}}, {})).crs, "EPSG:3794");
  EXPECT_EQ(crs_of(keys_of({{1024, 2}, {2048, 4326}}, {})).crs, "EPSG:4326");
  EXPECT_EQ(crs_of(keys_of({{1024, 2}, {2048, 4326}, {3072, 32632}}, {})).crs, "EPSG:4326");
  EXPECT_EQ(crs_of(keys_of({{1024, 1}, {3072, 54009}}, {})).crs, "ESRI:54009");
  EXPECT_EQ(crs_of(keys_of({{1024, 3}, {2048, 4978}}, {})).crs, "");
  EXPECT_EQ(crs_of(GeoKeys()).crs, "");
}

TEST(GeoKeys, HoldWktInCitations) {
  const std::string wkt =
      R"(PROJCS["x",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,)"
      R"(298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],)"
      R"(PROJECTION["Transverse_Mercator"],PARAMETER["Central_Meridian",9.0],)"
      R"(PARAMETER["Scale_Factor",0.9996],UNIT["Meter",1.0]])";
  const GeoKeyCrs crs = crs_of(keys_of({{1024, 1}, {3072, 32767}}, {}, "ESRI PE String = " + wkt));
  EXPECT_EQ(crs.crs, wkt);
  EXPECT_EQ(crs_of(keys_of({{1024, 32767}, {2048, 4326}}, {}, "ESRI PE String = " + wkt)).crs, wkt);
  // A citation leads to no file.
  for (const char* text : {"ESRI PE String = /etc/passwd", "ESRI PE String = http://example.org",
                           "ESRI PE String ="}) {
    EXPECT_EQ(crs_of(keys_of({{1024, 1}, {3072, 32767}}, {}, text)).crs, "") << text;
  }
}

TEST(GeoKeys, GiveNotesForWhatIsUnknown) {
  const GeoKeyCrs method = crs_of(keys_of({{1024, 1}, {3072, 32767}, {3075, 4}}, {}));
  EXPECT_EQ(method.crs, "");
  ASSERT_EQ(method.notes.size(), 1u);
  EXPECT_EQ(crs_of(keys_of({{1024, 1}, {3072, 32767}, {3075, 1}, {3076, 9999}}, {})).crs, "");
  EXPECT_EQ(crs_of(keys_of({{1024, 1}, {3072, 32767}, {3075, 1}},
                           {{3080, std::nan("")}, {2057, 1e300}, {2059, -1.0}}))
                .notes.size(),
            1u);
}

TEST(GeoKeys, AreLeftOutIfTheyLieOutsideTheirTags) {
  const GeoKeys keys({1, 1, 0, 900, 3080, 34736, 1, 7, 1026, 34737, 9, 50, 3072, 0, 1, 32632, 1024},
                     {1.0}, "abc|");
  EXPECT_FALSE(keys.number({3080}).has_value());
  EXPECT_EQ(keys.text(1026), "");
  EXPECT_EQ(keys.code(3072), 32632);
  EXPECT_TRUE(GeoKeys({1, 1, 0}, {}, "").empty());
}

}  // namespace
}  // namespace aerostat::elevation

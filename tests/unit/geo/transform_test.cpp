#include "geo/transform.hpp"

#include <cmath>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace aerostat::geo {
namespace {

constexpr Place kDavos{46.8, 9.9};

double distance(const dvec2& a, const dvec2& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

dvec2 to_local(const std::string& crs, const Place& middle, dvec2 point) {
  Transform(crs, middle).to_local({&point, 1});
  return point;
}

TEST(Transform, GivesEastAndSouthInMetres) {
  const dvec2 middle = to_local("EPSG:4326", kDavos, {9.9, 46.8});
  EXPECT_LT(std::hypot(middle.x, middle.y), 1e-6);
  // By the series of the ellipsoid, a minute is 1272.3 m of longitude and 1852.8 m of latitude
  // here.
  const dvec2 east = to_local("EPSG:4326", kDavos, {9.9 + 1.0 / 60.0, 46.8});
  EXPECT_NEAR(east.x, 1272.3, 0.5);
  const dvec2 north = to_local("EPSG:4326", kDavos, {9.9, 46.8 + 1.0 / 60.0});
  EXPECT_NEAR(north.x, 0.0, 1e-6);
  EXPECT_NEAR(north.y, -1852.8, 0.5);
}

struct Known {
  std::string crs;
  dvec2 point;
  Place place;
  double within_m;
};

TEST(Transform, PutsPointsOfManySystemsWhereTheyAre) {
  // The points come from the program cs2cs of PROJ, apart from the origins of projections.
  const std::vector<Known> all = {
      {"EPSG:32632", {568677.7502, 5183332.4424}, kDavos, 0.01},
      {"EPSG:3857", {1102062.9589, 5909489.8637}, kDavos, 0.01},
      {"+proj=laea +lat_0=52 +lon_0=10 +x_0=4321000 +y_0=3210000 +ellps=GRS80 +units=m",
       {4321000.0, 3210000.0},
       {52.0, 10.0},
       0.01},
      {"EPSG:3035", {4321000.0, 3210000.0}, {52.0, 10.0}, 0.01},
      {"EPSG:3794", {500000.0, -5000000.0}, {0.0, 15.0}, 0.01},
      {"EPSG:31287", {253624.8602, 368542.3894}, {47.2, 11.4}, 0.01},
      {"EPSG:32633", {500000.0, 0.0}, {0.0, 15.0}, 0.01},
  };
  for (const Known& known : all) {
    const dvec2 point = to_local(known.crs, known.place, known.point);
    EXPECT_LT(std::hypot(point.x, point.y), known.within_m) << known.crs;
    const Place place = place_of(known.crs, known.point);
    EXPECT_NEAR(place.latitude_deg, known.place.latitude_deg, 1e-6) << known.crs;
    EXPECT_NEAR(place.longitude_deg, known.place.longitude_deg, 1e-6) << known.crs;
  }
}

TEST(Transform, TakesLongitudeFirstWhateverTheAuthoritySays) {
  for (const char* crs : {"EPSG:4326", "OGC:CRS84", "EPSG:4258", "+proj=longlat +datum=WGS84"}) {
    const dvec2 point = to_local(crs, kDavos, {9.91, 46.8});
    EXPECT_NEAR(point.x, 763.4, 0.2) << crs;
    EXPECT_NEAR(point.y, 0.0, 0.2) << crs;
  }
}

TEST(Transform, ShiftsOldDatums) {
  // At Mount St Helens, NAD27 lies some 94 m from WGS 84: 91 m to the east and 23 m to the north.
  // Without grids, PROJ knows the shift to within 20 m.
  const Place summit{46.1914, -122.1956};
  dvec2 nad83(0.0);
  Transform("EPSG:26910", summit).from_local({&nad83, 1});
  const dvec2 as_nad27 = to_local("EPSG:26710", summit, nad83);
  EXPECT_NEAR(distance(as_nad27, {0.0, 0.0}), 207.0, 40.0);  // with the northing of UTM on Clarke
  const dvec2 degrees = to_local("EPSG:4267", summit, {summit.longitude_deg, summit.latitude_deg});
  EXPECT_NEAR(std::hypot(degrees.x, degrees.y), 94.0, 20.0);
  EXPECT_LT(degrees.x, -70.0);
  // MGI in Austria lies some 69 m off.
  const dvec2 mgi = to_local("EPSG:4312", {47.2, 11.4}, {11.4, 47.2});
  EXPECT_NEAR(std::hypot(mgi.x, mgi.y), 69.0, 5.0);
}

TEST(Transform, LeadsThroughAThirdSystemWhereItMust) {
  // PROJ knows a way from the German railways' datum to WGS 84 only by way of ETRS89. The national
  // datum DHDN lies some metres from that of the railways, and WGS 84 some 150 m. ESRI's text has
  // no code, so the datum is known by its name.
  const Place bonn{50.7, 7.1};
  dvec2 national(0.0);
  Transform("EPSG:31466", bonn).from_local({&national, 1});
  for (const std::string& crs : {std::string("EPSG:5682"), esri_wkt("EPSG:5682")}) {
    const dvec2 point = to_local(crs, bonn, national);
    EXPECT_LT(std::hypot(point.x, point.y), 20.0) << crs;
  }
}

TEST(Transform, DoesNotSearchLongForUnknownDatums) {
  // A search for a third system takes PROJ a second of processor time for each of these.
  const std::string datums[] = {
      R"(DATUM["D_North_American_1983",SPHEROID["GRS_1980",6378147.0,298.257222101]],)"
      R"(PRIMEM["Greenwich",0.0])",
      R"(DATUM["D_North_American_1983",SPHEROID["GRS_1980",6378137.0,298.257222101]],)"
      R"(PRIMEM["Greenwich",9.0])"};
  const std::clock_t before = std::clock();
  for (const std::string& datum : datums) {
    const std::string crs =
        R"(PROJCS["Albers",GEOGCS["GCS_North_American_1983",)" + datum +
        R"(,UNIT["Degree",0.0174532925199433]],PROJECTION["Albers"],)"
        R"(PARAMETER["Central_Meridian",9.0],PARAMETER["Standard_Parallel_1",29.5],)"
        R"(PARAMETER["Standard_Parallel_2",45.5],PARAMETER["Latitude_Of_Origin",23.0],)"
        R"(UNIT["Meter",1.0]])";
    const dvec2 point = to_local(crs, kDavos, {0.0, 0.0});
    EXPECT_TRUE(std::isfinite(point.x)) << crs;
  }
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, 0.6);
}

TEST(Transform, IsTrueToScaleAroundTheMiddle) {
  // The lengths of geodesics are from the program geod of PROJ. The local frame is off by up to
  // 0.9 m at 60 km.
  struct Row {
    Place place;
    double geodesic_m;
    double within_m;
  };
  for (const Row& row : {Row{{46.8, 10.0}, 7633.9334, 0.02}, Row{{46.9, 9.9}, 11116.7915, 0.02},
                         Row{{47.1, 10.4}, 50607.2518, 0.6}}) {
    const dvec2 point = local_point(kDavos, row.place);
    EXPECT_NEAR(std::hypot(point.x, point.y), row.geodesic_m, row.within_m);
  }
}

TEST(Transform, ComesBackToMillimetres) {
  // A shift of datum by three numbers loses the height above the other ellipsoid, and with it some
  // 1.3 mm at 700 m in Switzerland.
  for (const char* crs : {"EPSG:4326", "EPSG:32632", "EPSG:3857", "EPSG:31287", "EPSG:3035",
                          "EPSG:2056", "EPSG:4312", "EPSG:32632+5773", "EPSG:4979"}) {
    const Transform transform(crs, kDavos);
    std::vector<dvec2> points = {{0.0, 0.0}, {30000.0, -20000.0}, {-60000.0, 55000.0}};
    const std::vector<dvec2> before = points;
    transform.from_local(points);
    transform.to_local(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT(distance(points[i], before[i]), 0.002) << crs;
    }
  }
}

TEST(Transform, DoesNotJumpAtTheAntimeridian) {
  const Transform transform("EPSG:4326", {-16.8, 179.99});
  std::vector<dvec2> points = {{-5000.0, 0.0}, {5000.0, 0.0}};
  transform.from_local(points);
  EXPECT_GT(points[1].x, 180.0);
  EXPECT_GT(points[1].x, points[0].x);
  transform.to_local(points);
  EXPECT_NEAR(points[1].x, 5000.0, 0.001);
}

TEST(Transform, MarksPointsWithoutCounterpart) {
  const Transform transform("EPSG:32632", kDavos);
  std::vector<dvec2> points = {{std::nan(""), 0.0}, {1e30, 1e30}, {568677.7502, 5183332.4424}};
  transform.to_local(points);
  EXPECT_TRUE(std::isnan(points[0].x) && std::isnan(points[0].y));
  EXPECT_TRUE(std::isnan(points[1].x) && std::isnan(points[1].y));
  EXPECT_LT(std::hypot(points[2].x, points[2].y), 0.01);
  transform.to_local({});
}

TEST(Transform, RefusesPlacesThatAreNone) {
  EXPECT_THROW(Transform("EPSG:4326", {91.0, 0.0}), Error);
  EXPECT_THROW(Transform("EPSG:4326", {std::nan(""), 0.0}), Error);
  EXPECT_THROW(local_point(kDavos, {-100.0, 0.0}), Error);
  EXPECT_THROW(place_of("EPSG:32632", {1e30, 1e30}), Error);
  EXPECT_THROW(place_of("EPSG:4326", {9.0, 4000.0}), Error);
}

TEST(Transform, WorksInThreadsOfItsOwn) {
  std::vector<std::thread> threads;
  std::vector<dvec2> results(4);
  for (std::size_t i = 0; i < results.size(); ++i) {
    threads.emplace_back([&results, i] {
      results[i] = to_local("EPSG:31287", {47.2, 11.4}, {400000.0, 380000.0});
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const dvec2& result : results) EXPECT_EQ(result, results[0]);
}

TEST(LocalFrame, AgreesWithTheTransformAndComesBack) {
  const Place place{47.05, 9.55};
  const dvec2 point = local_point(kDavos, place);
  EXPECT_LT(distance(point, to_local("EPSG:4326", kDavos, {9.55, 47.05})), 1e-4);
  const Place back = place_of_local(kDavos, point);
  EXPECT_NEAR(back.latitude_deg, place.latitude_deg, 1e-9);
  EXPECT_NEAR(back.longitude_deg, place.longitude_deg, 1e-9);
}

TEST(CurvatureDrop, HidesSixtyMetresAtThirtyKilometres) {
  EXPECT_NEAR(curvature_drop(30000.0), 61.45, 0.05);  // 70.63 m without refraction
  EXPECT_EQ(curvature_drop(0.0), 0.0);
}

}  // namespace
}  // namespace aerostat::geo

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geo/transform.hpp"

namespace aerostat::geo {
namespace {

TEST(CrsInfo, KnowsCodes) {
  const CrsInfo utm = crs_info("EPSG:32632");
  EXPECT_EQ(utm.name, "WGS 84 / UTM zone 32N");
  EXPECT_FALSE(utm.geographic);
  EXPECT_EQ(utm.metres_per_unit, 1.0);
  EXPECT_EQ(utm.vertical_name, "");
  EXPECT_EQ(utm.vertical_metres_per_unit, 0.0);
  EXPECT_TRUE(crs_info("EPSG:4326").geographic);
  EXPECT_TRUE(crs_info("OGC:CRS84").geographic);
}

TEST(CrsInfo, KnowsTheUnitsOfProjectedAndVerticalSystems) {
  // NAD83 / California zone 5 (US survey foot) and heights over NAVD88 in feet.
  const CrsInfo both = crs_info("EPSG:2229+6360");
  EXPECT_NEAR(both.metres_per_unit, 0.3048006096, 1e-9);
  EXPECT_EQ(both.vertical_name, "NAVD88 height (ftUS)");
  EXPECT_NEAR(both.vertical_metres_per_unit, 0.3048006096, 1e-9);
  const CrsInfo metres = crs_info("EPSG:32611+5703");
  EXPECT_EQ(metres.vertical_name, "NAVD88 height");
  EXPECT_EQ(metres.vertical_metres_per_unit, 1.0);
  EXPECT_EQ(crs_info("EPSG:4979").vertical_metres_per_unit, 1.0);
}

TEST(CrsInfo, ReadsProjStringsAndWkt) {
  EXPECT_FALSE(crs_info("+proj=utm +zone=32").geographic);
  EXPECT_TRUE(crs_info("+proj=longlat +datum=WGS84 +no_defs").geographic);
  EXPECT_NEAR(
      crs_info("+proj=tmerc +lat_0=40 +lon_0=-100 +ellps=GRS80 +units=us-ft").metres_per_unit,
      0.3048006096, 1e-9);
  // GDAL writes Web Mercator with this extension.
  EXPECT_FALSE(crs_info("+proj=merc +a=6378137 +b=6378137 +lat_ts=0 +lon_0=0 +x_0=0 +y_0=0 +k=1 "
                        "+units=m +nadgrids=@null +wktext +no_defs")
                   .geographic);
  EXPECT_EQ(crs_info(R"(PROJCS["ETRS_1989_UTM_Zone_32N",GEOGCS["GCS_ETRS_1989",)"
                     R"(DATUM["D_ETRS_1989",SPHEROID["GRS_1980",6378137.0,298.257222101]],)"
                     R"(PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],)"
                     R"(PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],)"
                     R"(PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",9.0],)"
                     R"(PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0.0],)"
                     R"(UNIT["Meter",1.0]])")
                .metres_per_unit,
            1.0);
}

TEST(CrsInfo, RefusesWhatIsNoSystemOrLeadsToFiles) {
  for (const std::string text : {"",
                                 "  ",
                                 "/etc/passwd",
                                 "@/etc/passwd",
                                 "./dem.prj",
                                 "~/dem.prj",
                                 "C:\\dem.prj",
                                 "data/../../dem.prj",
                                 "dem.prj",
                                 "http://example.org/crs",
                                 "file:///etc/passwd",
                                 "+init=epsg:4326",
                                 "init=epsg:4326",
                                 "+init=/etc/passwd:4326",
                                 "+proj=longlat +ellps=clrk66 +nadgrids=/etc/passwd",
                                 "+proj=longlat +ellps=clrk66 +nadgrids=@conus",
                                 "+proj=longlat +nadgrids=@null,/etc/passwd",
                                 "+proj=longlat +datum=WGS84 +geoidgrids=/etc/passwd",
                                 "proj=utm zone=32 geoidgrids = x",
                                 "+proj=pipeline +step +proj=utm +zone=32",
                                 "+proj=hgridshift +grids=/etc/passwd",
                                 "+proj=utm +zone=32 +catalog=x",
                                 "+proj=deformation +xy_grids=a +z_grids=b",
                                 "{\"type\": \"GeographicCRS\"}",
                                 "EPSG:999999",
                                 "EPSG:5773",
                                 "EPSG:4978",
                                 "EPSG:6326",
                                 "nonsense",
                                 "+proj=nonsense",
                                 "BOUNDCRS[SOURCECRS[x],PARAMETERFILE[\"file\",\"/etc/passwd\"]]",
                                 "GEOGCS[",
                                 "[[[[[["}) {
    try {
      crs_info(text);
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_data) << text;
      EXPECT_NE(std::string(error.what()).find("coordinate reference system"), std::string::npos);
    }
  }
}

TEST(CrsInfo, ShortensLongTextsInMessages) {
  for (const std::string& text : {std::string(100000, 'x'), "a\nb" + std::string(300, 'y')}) {
    try {
      crs_info(text);
      FAIL();
    } catch (const Error& error) {
      EXPECT_LT(std::string(error.what()).size(), 300u);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(CrsInfo, KnowsEpsgCodesAndEsrisWkt) {
  EXPECT_EQ(epsg_code("EPSG:32632"), 32632);
  EXPECT_EQ(epsg_code("EPSG:32611+5703"), 32611);
  EXPECT_EQ(epsg_code("+proj=tmerc +lat_0=40 +lon_0=11 +datum=WGS84"), 0);
  const std::string wkt = esri_wkt("+proj=tmerc +lat_0=40 +lon_0=11 +datum=WGS84");
  EXPECT_EQ(wkt.rfind("PROJCS[", 0), 0u) << wkt;
  EXPECT_EQ(wkt.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace aerostat::geo

// The place of GeoTIFF files: transformations, systems, units of heights.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "elevation/open.hpp"
#include "files.hpp"
#include "geo/transform.hpp"
#include "tiff_files.hpp"

namespace aerostat::elevation {
namespace {

std::unique_ptr<Raster> through_file(const Folder& folder, const TiffPageSpec& page,
                                     const OpenOptions& options = {}) {
  write_tiff(folder.path() / "a.tif", {page});
  return open(folder.path() / "a.tif", options);
}

void expect_at(const dvec2& point, double x, double y) {
  EXPECT_NEAR(point.x, x, 1e-9);
  EXPECT_NEAR(point.y, y, 1e-9);
}

TEST(GeoTiffPlace, HasItsTiePointAtACornerOrAtACentre) {
  const Folder folder;
  TiffPageSpec page = page_at(32632, 600000.0, 5200000.0, 30.0);
  const auto area = through_file(folder, page);
  EXPECT_EQ(area->info().georeference->crs, "EPSG:32632");
  expect_at(centre_of(*area, 0, 0), 600015.0, 5199985.0);
  expect_at(centre_of(*area, 2, 1), 600075.0, 5199955.0);
  page.geo_keys[7] = 2;  // PixelIsPoint
  const auto point = through_file(folder, page);
  expect_at(centre_of(*point, 0, 0), 600000.0, 5200000.0);
  page.tiepoints = {10.0, 20.0, 0.0, 600000.0, 5200000.0, 0.0};
  expect_at(centre_of(*through_file(folder, page), 10, 20), 600000.0, 5200000.0);
}

TEST(GeoTiffPlace, MayBeTurnedAndSheared) {
  const Folder folder;
  TiffPageSpec page = page_at(32611, 0.0, 0.0, 1.0);
  page.pixel_scale.clear();
  page.tiepoints.clear();
  page.transformation = {1.5, -5.0, 0.0, 1841001.75, -5.0, -1.5, 0.0, 1144003.25,
                         0.0, 0.0,  0.0, 0.0,        0.0,  0.0,  0.0, 1.0};
  const auto area = through_file(folder, page);
  expect_at(centre_of(*area, 0, 0), 1841000.0, 1144000.0);
  expect_at(area->info().georeference->per_column, 1.5, -5.0);
  expect_at(area->info().georeference->per_row, -5.0, -1.5);
  page.geo_keys[7] = 2;
  expect_at(centre_of(*through_file(folder, page), 0, 0), 1841001.75, 1144003.25);
}

TEST(GeoTiffPlace, RunsFromTheSouthOnlyByATransformation) {
  const Folder folder;
  TiffPageSpec page = page_at(32632, 600000.0, 5200000.0, 30.0);
  page.pixel_scale[1] = -30.0;
  const auto negative = through_file(folder, page);
  expect_at(negative->info().georeference->per_row, 0.0, -30.0);
  EXPECT_TRUE(has_note(*negative, "negative distance"));
  page.transformation = {30.0, 0.0, 0.0, 600000.0, 0.0, 30.0, 0.0, 5200000.0,
                         0.0,  0.0, 0.0, 0.0,      0.0, 0.0,  0.0, 1.0};
  expect_at(through_file(folder, page)->info().georeference->per_row, 0.0, 30.0);
}

TEST(GeoTiffPlace, IsRefusedIfItMakesNoSense) {
  const Folder folder;
  TiffPageSpec page = page_at(32632, 600000.0, 5200000.0, 30.0);
  page.pixel_scale[0] = 0.0;
  EXPECT_TRUE(says(refusal_of([&] { through_file(folder, page); }), "makes no sense"));
  page.pixel_scale[0] = 1e308;
  EXPECT_TRUE(says(refusal_of([&] { through_file(folder, page); }), "makes no sense"));
  page.pixel_scale.clear();
  page.tiepoints = {0, 0, 0, 1, 1, 0, 9, 0, 0, 2, 1, 0, 0, 9, 0, 1, 0, 0};
  EXPECT_TRUE(says(refusal_of([&] { through_file(folder, page); }), "ground control points"));
}

TEST(GeoTiffPlace, MayBeMissing) {
  const Folder folder;
  const TiffPageSpec page;
  EXPECT_FALSE(through_file(folder, page)->info().georeference.has_value());
  OpenOptions options;
  options.cell_m = 10.0;
  const auto raster = through_file(folder, page, options);
  expect_at(raster->info().georeference->per_row, 0.0, -10.0);
  EXPECT_TRUE(has_note(*raster, "/terrain/cell_m"));
}

TEST(GeoTiffPlace, IsTakenFromFilesBesideOnlyIfTheFileLacksIt) {
  const Folder folder;
  folder.write("a.tfw", "30\n0\n0\n-30\n600015\n5199985\n");
  folder.write("a.prj", R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,)"
                        R"(298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925]])");
  TiffPageSpec page = page_at(32632, 700000.0, 5200000.0, 30.0);
  const auto whole = through_file(folder, page);
  expect_at(centre_of(*whole, 0, 0), 700015.0, 5199985.0);
  EXPECT_EQ(whole->info().georeference->crs, "EPSG:32632");
  page.pixel_scale.clear();
  page.tiepoints.clear();
  const auto placed = through_file(folder, page);
  expect_at(centre_of(*placed, 0, 0), 600015.0, 5199985.0);
  EXPECT_EQ(placed->info().georeference->crs, "EPSG:32632");
  EXPECT_TRUE(has_note(*placed, "world file"));
  page.geo_keys.clear();
  folder.write("a.tfw", "0.01\n0\n0\n-0.01\n9.6\n47.1\n");
  const auto bare = through_file(folder, page);
  EXPECT_TRUE(geo::crs_info(bare->info().georeference->crs).geographic);
  EXPECT_TRUE(has_note(*bare, ".prj"));
  std::filesystem::remove(folder.path() / "a.prj");
  folder.write("a.tif.aux.xml",
               "<PAMDataset><SRS dataAxisToSRSAxisMapping=\"2,1\">GEOGCS[&quot;NAD27&quot;,DATUM["
               "&quot;North_American_Datum_1927&quot;,SPHEROID[&quot;Clarke 1866&quot;,6378206.4,"
               "294.9786982]],PRIMEM[&quot;Greenwich&quot;,0],UNIT[&quot;degree&quot;,"
               "0.0174532925199433]]</SRS><PAMRasterBand band=\"1\"><NoDataValue>5</NoDataValue>"
               "<Scale>2</Scale></PAMRasterBand></PAMDataset>");
  const auto named = through_file(folder, page);
  EXPECT_EQ(geo::crs_info(named->info().georeference->crs).name, "NAD27");
  EXPECT_TRUE(has_note(*named, ".aux.xml"));
  EXPECT_EQ(height_at(*named, 1, 1), 5.0f);
}

TEST(GeoTiffPlace, LeavesAMissingSystemToTheCaller) {
  const Folder folder;
  TiffPageSpec page = page_at(32632, 600000.0, 5200000.0, 30.0);
  page.geo_keys.clear();
  EXPECT_EQ(through_file(folder, page)->info().georeference->crs, "");
  EXPECT_TRUE(has_note(*through_file(folder, page), "/terrain/crs names it"));
  OpenOptions options;
  options.crs = "EPSG:25832";
  EXPECT_EQ(through_file(folder, page, options)->info().georeference->crs, "EPSG:25832");
  options.crs = "/etc/passwd";
  EXPECT_TRUE(says(refusal_of([&] { through_file(folder, page, options); }), "names of files"));
  page = page_at(32999, 600000.0, 5200000.0, 30.0);
  const auto unknown = through_file(folder, page);
  EXPECT_EQ(unknown->info().georeference->crs, "");
  EXPECT_TRUE(has_note(*unknown, "EPSG:32999, which PROJ does not know"));
}

TEST(GeoTiffPlace, MayBeInAnotherUnitThanItsSystem) {
  const Folder folder;
  TiffPageSpec feet = page_at(26910, 600000.0 / 0.3048, 5000000.0 / 0.3048, 100.0);
  feet.geo_keys.insert(feet.geo_keys.end(), {3076, 0, 1, 9002});
  const auto utm = through_file(folder, feet);
  EXPECT_NEAR(centre_of(*utm, 0, 0).x, 600000.0 + 15.24, 1e-6);
  EXPECT_NEAR(utm->info().georeference->per_row.y, -30.48, 1e-9);
  EXPECT_TRUE(has_note(*utm, "multiplied by 0.3048"));
  TiffPageSpec seconds = page_at(4267, -122.2 * 3600.0, 46.2 * 3600.0, 1.0);
  seconds.geo_keys.insert(seconds.geo_keys.end(), {2054, 0, 1, 9104});
  EXPECT_NEAR(centre_of(*through_file(folder, seconds), 0, 0).y, 46.2 - 0.5 / 3600.0, 1e-9);
  // The same unit in other words changes nothing.
  TiffPageSpec metres = page_at(32632, 600000.0, 5200000.0, 30.0);
  metres.geo_keys.insert(metres.geo_keys.end(), {3076, 0, 1, 9001, 2054, 0, 1, 9102});
  expect_at(centre_of(*through_file(folder, metres), 0, 0), 600015.0, 5199985.0);
}

TEST(GeoTiffPlace, IsRefusedIfTheSystemCannotBeTheRightOne) {
  const Folder folder;
  // Metres that are said to be degrees.
  TiffPageSpec page = page_at(4326, -10805.0, 195595.0, 10.0);
  const std::string metres = refusal_of([&] { through_file(folder, page); });
  EXPECT_TRUE(says(metres, "WGS 84, whose coordinates are degrees"));
  EXPECT_TRUE(says(metres, "look like metres"));
  EXPECT_TRUE(says(metres, "/terrain/crs"));
  page = page_at(4326, 0.0, 60.0, 2.0);
  EXPECT_TRUE(says(refusal_of([&] { through_file(folder, page); }), "look like metres"));
  OpenOptions options;
  options.crs = "EPSG:4326";
  EXPECT_NO_THROW(through_file(folder, page, options));
  // Degrees that are said to be metres.
  page = page_at(32632, 9.6, 47.1, 1.0 / 3600.0);
  const std::string degrees = refusal_of([&] { through_file(folder, page); });
  EXPECT_TRUE(says(degrees, "UTM zone 32N, whose coordinates are lengths"));
  EXPECT_TRUE(says(degrees, "look like degrees"));
  EXPECT_TRUE(says(degrees, "/terrain/crs"));
  // The whole Earth, and longitudes from 0 to 360 degrees, pass.
  page = page_at(4326, -180.5, 14.5, 1.0);
  EXPECT_NO_THROW(through_file(folder, page));
  page = page_at(4326, 359.0, 10.0, 0.01);
  EXPECT_NO_THROW(through_file(folder, page));
}

struct UnitRow {
  std::vector<std::uint16_t> keys;
  const char* unit_of_metadata;
  double metres;
  const char* name;
};

TEST(GeoTiffHeights, AreInTheUnitOfTheVerticalSystemThenOfTheMetadata) {
  const std::vector<UnitRow> rows = {
      {{4096, 0, 1, 5703}, "ft", 1.0, "metre"},
      {{4096, 0, 1, 6360}, "", 1200.0 / 3937.0, "US survey foot"},
      {{4096, 0, 1, 5773}, "", 1.0, "metre"},
      {{4096, 0, 1, 5103, 4099, 0, 1, 9002}, "", 0.3048, "foot"},
      {{4099, 0, 1, 9003}, "metre", 1200.0 / 3937.0, "US survey foot"},
      {{}, "foot", 0.3048, "foot"},
      {{}, "Metre", 1.0, "metre"},
      {{}, "US survey foot", 1200.0 / 3937.0, "US survey foot"},
      // The unit of horizontal coordinates says nothing of heights.
      {{3076, 0, 1, 9003}, "", 1.0, "metre"},
      {{}, "", 1.0, "metre"}};
  const Folder folder;
  for (const UnitRow& row : rows) {
    TiffPageSpec page = page_at(32611, 400000.0, 3800000.0, 30.0);
    page.geo_keys.insert(page.geo_keys.end(), row.keys.begin(), row.keys.end());
    if (*row.unit_of_metadata != '\0') {
      page.metadata = std::string(
                          "<GDALMetadata><Item name=\"UNITTYPE\" sample=\"0\" "
                          "role=\"unittype\">") +
                      row.unit_of_metadata + "</Item></GDALMetadata>";
    }
    const auto raster = through_file(folder, page);
    EXPECT_NEAR(raster->info().metres_per_unit, row.metres, 1e-9) << row.unit_of_metadata;
    EXPECT_EQ(raster->info().unit, row.name);
    EXPECT_NEAR(height_at(*raster, 10, 0), 30.0 * row.metres, 1e-4);
    const bool nothing_says =
        *row.unit_of_metadata == '\0' && (row.keys.empty() || row.keys[0] == 3076);
    EXPECT_EQ(has_note(*raster, "gives no unit"), nothing_says);
    if (!row.keys.empty() && row.keys[3] == 5773) {
      EXPECT_EQ(raster->info().vertical_datum, "EGM96 height");
    }
  }
}

}  // namespace
}  // namespace aerostat::elevation

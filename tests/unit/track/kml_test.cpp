#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "support.hpp"
#include "support/temporary_folder.hpp"
#include "track/read.hpp"
#include "unit/elevation/packed.hpp"

namespace aerostat::track {
namespace {

constexpr double kStart_s = 1696232710.0;  // 2023-10-02 07:45:10 UTC

std::string kml(const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><kml "
         "xmlns=\"http://www.opengis.net/kml/2.2\" "
         "xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><Document><name>D</name>" +
         content + "</Document></kml>";
}

std::string placemark(const std::string& content) {
  return "<Placemark><name>P</name>" + content + "</Placemark>";
}

std::string mode(const std::string& word) {
  return "<altitudeMode>" + word + "</altitudeMode>";
}

const std::string kWhens = "<when>2023-10-02T07:45:10Z</when><when>2023-10-02T07:45:12Z</when>";
const std::string kCoords = "<gx:coord>9.5 46.5 900</gx:coord><gx:coord>9.6 46.6 910</gx:coord>";

std::string gx_track(const std::string& content) {
  return "<gx:Track>" + content + "</gx:Track>";
}

TEST(Kml, ReadsATrack) {
  const Track track =
      read_bytes(kml(placemark(gx_track(mode("absolute") + kWhens + kCoords))), "x");
  ASSERT_EQ(track.fix_count(), 2u);
  const Fix& fix = track.segments[0][1];
  EXPECT_EQ(track.format, Format::kml);
  EXPECT_EQ(track.name, "P");
  EXPECT_EQ(fix.place, (geo::Place{46.6, 9.6}));
  EXPECT_EQ(fix.gnss_m, 910.0);
  EXPECT_EQ(fix.time_s, kStart_s + 2.0);
  EXPECT_EQ(track.reference, HeightReference::sea);
  EXPECT_TRUE(track.notes.empty()) << notes_of(track);
}

TEST(Kml, ReadsTimesAndPlacesInTurnAndWithoutDeclaredPrefix) {
  const std::string text =
      "<kml><Placemark><gx:Track><when>2023-10-02T07:45:10Z</when><gx:coord>9.5 46.5 900</gx:coord>"
      "<when>2023-10-02T07:45:12Z</when><gx:coord>9.6 46.6 "
      "910</gx:coord></gx:Track></Placemark></kml>";
  const Track track = read_bytes(text, "x");
  ASSERT_EQ(track.fix_count(), 2u);
  EXPECT_EQ(track.segments[0][1].time_s, kStart_s + 2.0);
  EXPECT_TRUE(says(notes_of(track), "The altitude mode is not given"));
}

TEST(Kml, PassesOverEmptyPlacesAndUnpairedTimes) {
  const Track track = read_bytes(
      kml(placemark(gx_track("<when>2023-10-02T07:45:09Z</when>" + kWhens +
                             "<when>2023-10-02T07:45:19Z</when><gx:coord></gx:coord>" + kCoords))),
      "x");
  ASSERT_EQ(track.fix_count(), 2u);
  EXPECT_EQ(track.segments[0][0].time_s, kStart_s);
  EXPECT_TRUE(says(notes_of(track), "1 coordinate could not be read"));
  EXPECT_TRUE(says(notes_of(track), "another number of times than of coordinates"));
}

TEST(Kml, JoinsTheTracksOfAMultiTrackAsSegments) {
  const std::string second = "<when>2023-10-02T08:00:00Z</when><gx:coord>9.7 46.7 910</gx:coord>";
  const Track track =
      read_bytes(kml(placemark("<gx:MultiTrack>" + gx_track("") + gx_track(kWhens + kCoords) +
                               gx_track("") + gx_track(second) + "</gx:MultiTrack>")),
                 "x");
  ASSERT_EQ(track.segments.size(), 2u);
  EXPECT_EQ(track.segments[1].size(), 1u);
}

TEST(Kml, ReadsLinesWhoseTimesMustBeGiven) {
  const std::string text = kml(placemark("<LineString>" + mode("absolute") +
                                         "<coordinates>\n 9.5,46.5,900 9.6,46.6,910\n\t9.7 , 46.7 "
                                         ", 920 9.8,46.8\n</coordinates></LineString>"));
  const Track track = read_bytes(text, "x");
  ASSERT_EQ(track.fix_count(), 4u);
  EXPECT_EQ(track.clock, Clock::none);
  EXPECT_EQ(track.segments[0][2].place, (geo::Place{46.7, 9.7}));
  EXPECT_EQ(track.segments[0][2].gnss_m, 920.0);
  EXPECT_FALSE(track.segments[0][3].gnss_m);
  EXPECT_TRUE(says(notes_of(track), "The track has no times."));
  ReadOptions options;
  options.start_s = kStart_s;
  options.interval_s = 60.0;
  const Track timed = read_bytes(text, "x", options);
  EXPECT_EQ(timed.clock, Clock::utc);
  EXPECT_EQ(timed.segments[0][3].time_s, kStart_s + 180.0);
  EXPECT_TRUE(says(notes_of(timed), "2023-10-02 07:45:10 UTC, and 60 s from fix to fix"));
}

TEST(Kml, JoinsLinesThatTouch) {
  const auto line = [](const std::string& coordinates) {
    return placemark("<LineString>" + mode("absolute") + "<coordinates>" + coordinates +
                     "</coordinates></LineString>");
  };
  const std::string text =
      kml(line("9.5,46.5,900 9.6,46.5,910") + line("9.6,46.5,910 9.7,46.5,920") +
          line("9.7,46.5,920 9.8,46.5,930") + line("1,2,3 1.01,2,3"));
  const Track track = read_bytes(text, "x");
  EXPECT_EQ(track.fix_count(), 6u);
  EXPECT_TRUE(says(notes_of(track), "4 lines that touch each other were joined into 2."));
}

TEST(Kml, PrefersAFlightToItsShadow) {
  const auto line = [](const std::string& content) {
    return placemark("<LineString>" + content + "</LineString>");
  };
  const std::string text =
      kml(line(mode("clampToGround") + "<coordinates>9.5,46.5 9.6,46.5</coordinates>") +
          line(mode("absolute") + "<coordinates>9.5,46.5,900 9.6,46.5,910</coordinates>"));
  EXPECT_EQ(read_bytes(text, "x").segments[0][0].gnss_m, 900.0);
}

TEST(Kml, PrefersTracksToLines) {
  const std::string line =
      placemark("<LineString><coordinates>1,2,3 4,5,6</coordinates></LineString>");
  const Track track = read_bytes(kml(line + placemark(gx_track(kWhens + kCoords))), "x");
  EXPECT_EQ(track.clock, Clock::utc);
  EXPECT_TRUE(says(notes_of(track), "lines as well"));
}

TEST(Kml, KeepsTracksAndLinesOfOneGeometryApart) {
  const std::string both =
      "<MultiGeometry><LineString><coordinates>1,2,3 4,5,6</coordinates></LineString>" +
      gx_track(kWhens + kCoords) + "</MultiGeometry>";
  EXPECT_EQ(read_bytes(kml(placemark(both)), "x").fix_count(), 2u);
}

struct ModeRow {
  std::string mode;
  const char* altitude;
  HeightReference reference;
  bool has_height;
  const char* note;
};

TEST(Kml, KnowsTheAltitudeModes) {
  const ModeRow rows[] = {
      {mode("absolute"), "0", HeightReference::sea, false, "heights of 0 were taken for unknown"},
      {mode("absolute"), "900", HeightReference::sea, true, ""},
      {mode("relativeToGround"), "120", HeightReference::ground, true, ""},
      {mode("clampToGround"), "0", HeightReference::unknown, false, ""},
      {mode("clampToGround"), "900", HeightReference::unknown, true,
       "mode is 'clampToGround', but"},
      {"", "0", HeightReference::unknown, false, ""},
      {"", "900", HeightReference::unknown, true, "mode is not given, but"},
  };
  for (const ModeRow& row : rows) {
    const std::string coord = std::string("<coordinates>9.5,46.5,") + row.altitude + " 9.6,46.6," +
                              row.altitude + "</coordinates>";
    const Track track =
        read_bytes(kml(placemark("<LineString>" + row.mode + coord + "</LineString>")), "x");
    EXPECT_EQ(track.reference, row.reference) << row.mode;
    EXPECT_EQ(track.segments[0][0].gnss_m.has_value(), row.has_height) << row.mode;
    EXPECT_TRUE(says(notes_of(track), row.note)) << row.mode;
  }
}

TEST(Kml, RefusesFilesWithoutTracks) {
  const std::string dot = placemark("<Point><coordinates>9.5,46.5</coordinates></Point>");
  EXPECT_TRUE(says(complaint(kml(dot)), "no fix with a usable place"));
  const std::string broken = "<LineString><coordinates>a,b c,d ,,, </coordinates></LineString>";
  EXPECT_TRUE(says(complaint(kml(placemark(broken))), "no fix with a usable place"));
}

TEST(Kml, IsReadFromAZipFile) {
  const std::string text = kml(placemark(gx_track(mode("absolute") + kWhens + kCoords)));
  const std::string kmz = elevation::zip({{"files/icon.png", "png"}, {"doc.kml", text}});
  EXPECT_EQ(read_bytes(kmz, "x").fix_count(), 2u);
  EXPECT_TRUE(says(complaint(elevation::zip({{"readme.txt", "text"}})), "x: "));
  EXPECT_TRUE(says(complaint(kmz.substr(0, kmz.size() / 2)), "x: the zip file is cut short"));
  const test::TemporaryFolder folder;
  for (const char* name : {"flight.KMZ", "flight.zip"}) {
    std::ofstream(folder.path() / name, std::ios::binary) << kmz;
  }
  EXPECT_TRUE(is_track(folder.path() / "flight.KMZ"));
  EXPECT_FALSE(is_track(folder.path() / "flight.zip"));
  EXPECT_EQ(read_file(folder.path() / "flight.KMZ").format, Format::kml);
}

}  // namespace
}  // namespace aerostat::track

#include <gtest/gtest.h>

#include "support.hpp"
#include "track/read.hpp"

namespace aerostat::track {
namespace {

constexpr double kStart_s = 1696232710.0;  // 2023-10-02 07:45:10 UTC

std::string point(double latitude, double longitude, const std::string& content) {
  return "<trkpt lat=\"" + std::to_string(latitude) + "\" lon=\"" + std::to_string(longitude) +
         "\">" + content + "</trkpt>";
}

std::string gpx(const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><gpx version=\"1.1\">" + content + "</gpx>";
}

std::string segment(const std::string& content) {
  return "<trk><trkseg>" + content + "</trkseg></trk>";
}

std::string time(int seconds) {
  const std::string tens = seconds < 10 ? "0" : "";
  return "<time>2023-10-02T07:45:" + tens + std::to_string(seconds) + "Z</time>";
}

const std::string kTwo =
    point(46.5, 9.5, "<ele>900.5</ele>" + time(10)) + point(46.6, 9.6, "<ele>905</ele>" + time(11));

void expect_two(const Track& track) {
  ASSERT_EQ(track.segments.size(), 1u) << notes_of(track);
  ASSERT_EQ(track.segments[0].size(), 2u) << notes_of(track);
  const Fix& fix = track.segments[0][0];
  EXPECT_DOUBLE_EQ(fix.place.latitude_deg, 46.5);
  EXPECT_DOUBLE_EQ(fix.place.longitude_deg, 9.5);
  EXPECT_EQ(fix.gnss_m, 900.5);
  EXPECT_EQ(fix.time_s, kStart_s);
  EXPECT_EQ(track.clock, Clock::utc);
}

TEST(Gpx, ReadsEveryWrapping) {
  const std::string body = "<trk><name>A</name><trkseg>" + kTwo + "</trkseg></trk></gpx>";
  const std::string rows[] = {
      "<gpx>" + body,
      "\xef\xbb\xbf<?xml version=\"1.0\"?><gpx>" + body,
      "\n <?xml version=\"1.0\"?><gpx>" + body,
      "<?xml version=\"1.0\"?><!-- a > comment --><gpx>" + body,
      "<?xml version=\"1.0\"?><!DOCTYPE gpx><gpx>" + body,
      "<gpx version=\"1.0\" xmlns=\"http://www.topografix.com/GPX/1/0\">" + body,
      "<gpx version=\"1.1\" xmlns=\"http://www.topografix.com/GPX/1/1\">" + body,
      "<gpx version=\"9\" xmlns=\"urn:wrong\" xmlns:gpxx=\"urn:x\">" + body,
      "<?xml version=\"1.0\" encoding=\"windows-1252\"?><gpx>" + body,
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><gpx>" + body,
  };
  for (const std::string& row : rows) {
    SCOPED_TRACE(row.substr(0, 80));
    const Track track = read_bytes(row, "x");
    expect_two(track);
    EXPECT_EQ(track.name, "A");
    EXPECT_EQ(track.format, Format::gpx);
  }
}

TEST(Gpx, ReadsElementsWithAPrefix) {
  const std::string text =
      "<g:gpx xmlns:g=\"urn:x\"><g:trk><g:trkseg><g:trkpt lat=\"46.5\" lon=\"9.5\"><g:ele>900.5"
      "</g:ele><g:time>2023-10-02T07:45:10Z</g:time></g:trkpt><g:trkpt lat=\"46.6\" lon=\"9.6\">"
      "<g:time>2023-10-02T07:45:11Z</g:time></g:trkpt></g:trkseg></g:trk></g:gpx>";
  expect_two(read_bytes(text, "x"));
}

TEST(Gpx, ReadsUtf16) {
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-16\"?><gpx>" + segment(kTwo) + "</gpx>";
  for (const bool is_big : {false, true}) {
    std::string wide = is_big ? "\xfe\xff" : "\xff\xfe";
    for (const char c : text) wide += is_big ? std::string{'\0', c} : std::string{c, '\0'};
    expect_two(read_bytes(wide, "x"));
  }
}

TEST(Gpx, ReadsLatin1ThatPromisesUtf8) {
  const std::string text = gpx("<trk><name>Z\xfcrich</name><trkseg>" + kTwo + "</trkseg></trk>");
  const Track track = read_bytes(text, "x");
  expect_two(track);
  EXPECT_EQ(track.name, "Z\xc3\xbcrich");
  EXPECT_TRUE(says(notes_of(track), "read as Latin-1"));
}

TEST(Gpx, LooksForTheEncodingOnlyAtTheBeginning) {
  // What looks like an encoding stands at every place around the end of what is looked at.
  for (std::size_t length = 150; length < 210; ++length) {
    const std::string text =
        "<gpx><!--" + std::string(length, ' ') + "encoding='-->" + segment(kTwo) + "</gpx>";
    expect_two(read_bytes(text, "x"));
  }
}

TEST(Gpx, TakesHeightsAndTimesOnlyFromThePointItself) {
  const std::string extension =
      "<extensions><ele>1</ele><time>2001-01-01T00:00:00Z</time></extensions>";
  expect_two(read_bytes(gpx(segment(point(46.5, 9.5, "<ele>900.5</ele>" + time(10) + extension) +
                                    point(46.6, 9.6, time(11)))),
                        "x"));
}

TEST(Gpx, LeavesHeightsOpenThatAreMissing) {
  const Track track = read_bytes(
      gpx(segment(point(46.5, 9.5, time(1)) + point(46.6, 9.6, "<ele/>" + time(2)))), "x");
  EXPECT_FALSE(track.segments[0][0].gnss_m);
  EXPECT_FALSE(track.segments[0][1].gnss_m);
}

TEST(Gpx, TakesZeroHeightsForUnknown) {
  const auto ele = [](const char* metres, int at) {
    return point(46.5 + 0.001 * at, 9.5, "<ele>" + std::string(metres) + "</ele>" + time(at));
  };
  const Track track = read_bytes(
      gpx(segment(ele("0", 1) + ele("900", 2) + ele("0.0", 3) + ele("901", 4) + ele("0", 5))), "x");
  const Segment& fixes = track.segments[0];
  EXPECT_FALSE(fixes[0].gnss_m || fixes[2].gnss_m || fixes[4].gnss_m);
  EXPECT_TRUE(fixes[1].gnss_m && fixes[3].gnss_m);
  EXPECT_TRUE(says(notes_of(track), "3 heights of 0 were taken for unknown"));
  const Track sea = read_bytes(gpx(segment(ele("3", 1) + ele("0", 2) + ele("-2", 3))), "x");
  EXPECT_EQ(sea.segments[0][1].gnss_m, 0.0);
  const Track all = read_bytes(gpx(segment(ele("0", 1) + ele("0", 2))), "x");
  EXPECT_FALSE(all.segments[0][0].gnss_m);
}

TEST(Gpx, TakesAbsurdHeightsForUnknown) {
  for (const char* height : {"1e300", "-99999", "1000001"}) {
    const std::string text =
        gpx(segment(point(46, 9, "<ele>" + std::string(height) + "</ele>" + time(1)) +
                    point(46.1, 9, "<ele>500</ele>" + time(2))));
    const Track track = read_bytes(text, "x");
    EXPECT_FALSE(track.segments[0][0].gnss_m) << height;
    EXPECT_EQ(track.segments[0][1].gnss_m, 500.0);
    EXPECT_TRUE(says(notes_of(track), "1 height was beyond all bounds"));
  }
}

TEST(Gpx, TakesTheLongestTrackOrTheOneAskedFor) {
  const std::string text =
      gpx("<trk/><trk><name>short</name><trkseg>" + kTwo + "</trkseg></trk>" +
          "<trk><name>long</name><trkseg/><trkseg>" + point(46, 9, time(1)) +
          point(46.5, 9, time(2)) + "</trkseg></trk>" + "<trk><name>wrong</name><trkseg>" +
          point(46, 9, time(1)) + point(-46, 99, time(2)) + "</trkseg></trk>");
  const Track track = read_bytes(text, "x");
  EXPECT_EQ(track.name, "long");
  EXPECT_TRUE(says(notes_of(track),
                   "The file has 3 tracks; number 1 (counted from 0), 'long', was taken, 55.6 km "
                   "long, the longest."));
  ReadOptions options;
  options.index = 0;
  EXPECT_EQ(read_bytes(text, "x", options).name, "short");
  options.index = 3;
  EXPECT_TRUE(says(complaint(text, options), "track 3 does not exist; the file has 3 tracks"));
}

TEST(Gpx, KeepsSegmentsApartAndInOrderOfTime) {
  const std::string text = gpx("<trk><trkseg>" + point(46, 9, time(30)) + point(46, 9.1, time(31)) +
                               "</trkseg><trkseg/><trkseg>" + point(46, 9.2, time(1)) +
                               point(46, 9.3, time(2)) + "</trkseg></trk>");
  const Track track = read_bytes(text, "x");
  ASSERT_EQ(track.segments.size(), 2u);
  EXPECT_NEAR(track.segments[0][0].place.longitude_deg, 9.2, 1e-9);
  EXPECT_TRUE(says(notes_of(track), "order of their times"));
}

TEST(Gpx, BearsSegmentsWithinSegments) {
  const std::string text = "<gpx><trk><trkseg><trkseg><trkseg>" + point(46, 9, time(1)) +
                           "</trkseg><trkseg>" + point(46, 9.1, time(2)) + "</trkseg></trk></gpx>";
  EXPECT_EQ(read_bytes(text, "x").segments.size(), 2u);
}

TEST(Gpx, FallsBackToRoutes) {
  const std::string text =
      gpx("<wpt lat=\"1\" lon=\"2\"/><rte><name>R</name><rtept lat=\"46.5\" "
          "lon=\"9.5\"/><rtept lat=\"46.6\" lon=\"9.5\"/></rte>");
  const Track track = read_bytes(text, "x");
  EXPECT_EQ(track.name, "R");
  EXPECT_EQ(track.fix_count(), 2u);
  EXPECT_EQ(track.clock, Clock::none);
  EXPECT_TRUE(says(notes_of(track), "its route was taken"));
  EXPECT_TRUE(says(notes_of(track), "has no times"));
}

TEST(Gpx, TakesTimesFromTheOptionsIfThereAreNone) {
  const std::string text = gpx(segment(point(46.5, 9.5, "") + point(46.6, 9.5, "")));
  ReadOptions options;
  options.start_s = kStart_s;
  options.interval_s = 2.5;
  const Track track = read_bytes(text, "x", options);
  EXPECT_EQ(track.clock, Clock::utc);
  EXPECT_EQ(track.segments[0][1].time_s, kStart_s + 2.5);
  options.start_s.reset();
  EXPECT_TRUE(says(complaint(text, options), "needs its start"));
  options.start_s = 5.0;
  EXPECT_TRUE(says(complaint(text, options), "1980"));
  options.start_s = kStart_s;
  options.interval_s = 0.0;
  EXPECT_TRUE(says(complaint(text, options), "interval of the track is 0 s"));
}

struct Fault {
  std::string text;
  const char* message;
};

TEST(Gpx, RefusesInWords) {
  std::string deep = "<gpx>";
  for (int i = 0; i < 200; ++i) deep += "<trk>";
  const std::string bomb =
      "<!DOCTYPE gpx [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]><gpx><trk><name>&b;"
      "</name><trkseg>" +
      kTwo + "</trkseg></trk></gpx>";
  const std::string thief = "<!DOCTYPE gpx [<!ENTITY f SYSTEM \"file:///etc/passwd\">]><gpx>" +
                            segment(kTwo + "&f;") + "</gpx>";
  const Fault rows[] = {
      {"", "expected the content of a GPX, IGC, KML or KMZ file"},
      {"<html><gpx/></html>", "expected the content of a GPX, IGC, KML or KMZ file"},
      {"{\"version\": 1}", "expected the content of a GPX, IGC, KML or KMZ file"},
      {gpx(""), "no fix with a usable place"},
      {gpx("<wpt lat=\"1\" lon=\"2\"/>"), "only waypoints"},
      {gpx(segment(point(0, 0, "") + point(91, 5, ""))), "no fix with a usable place"},
      {gpx(segment("<trkpt lat=\"46,5\" lon=\"9,5\"/>")), "no fix with a usable place"},
      {"<gpx><trk><trkseg>", "the XML is damaged at line 1"},
      {deep, "nested deeper than 100"},
      {bomb, "declares the entity 'a'"},
      {thief, "declares the entity 'f'"},
  };
  for (const Fault& row : rows)
    EXPECT_TRUE(says(complaint(row.text), row.message)) << row.text.substr(0, 80);
}

TEST(Gpx, KeepsWhatStandsBeforeADamage) {
  const Track track = read_bytes("<gpx><trk><trkseg>" + kTwo + "<trkpt lat=\"4", "x");
  expect_two(track);
  EXPECT_TRUE(says(notes_of(track), "The XML is damaged at line 1"));
  EXPECT_TRUE(says(notes_of(track), "What stands behind it is missing."));
}

TEST(Gpx, SaysWhatItCouldNotRead) {
  const Track track = read_bytes(gpx(segment("<trkpt lat=\"x\" lon=\"9\"/>" + kTwo +
                                             point(46.7, 9.7, "<time>2023-10-02T07:45:30</time>") +
                                             point(46.7, 9.7, "<time>noon</time>"))),
                                 "x");
  EXPECT_EQ(track.fix_count(), 3u);
  EXPECT_TRUE(says(notes_of(track), "1 point without a readable latitude"));
  EXPECT_TRUE(says(notes_of(track), "1 time without a zone taken for UTC"));
  EXPECT_TRUE(says(notes_of(track), "1 time not understood"));
  EXPECT_TRUE(says(notes_of(track), "1 fix was without a time left out"));
}

TEST(Gpx, BringsLongitudesBetween180Degrees) {
  const Track track =
      read_bytes(gpx(segment(point(46, 190, time(1)) + point(46, -180, time(2)))), "x");
  EXPECT_NEAR(track.segments[0][0].place.longitude_deg, -170.0, 1e-9);
  EXPECT_NEAR(track.segments[0][1].place.longitude_deg, 180.0, 1e-9);
}

}  // namespace
}  // namespace aerostat::track

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support.hpp"
#include "track/read.hpp"

namespace aerostat::track {
namespace {

constexpr double kDay_s = 1696204800.0;  // 2023-10-02

/// Returns the record of a fix at 46 degrees north, `east` thousandths of a minute behind 9 east.
std::string fix(const std::string& hhmmss, int east = 0, const std::string& heights = "0095000905",
                char validity = 'A') {
  const std::string digits = std::to_string(100000 + east).substr(1);
  return "B" + hhmmss + "4600000N009" + digits + "E" + validity + heights + "\r\n";
}

const std::string kHead = "AXXX001\r\nHFDTE021023\r\n";

const Segment& fixes_of(const Track& track) {
  EXPECT_EQ(track.segments.size(), 1u);
  return track.segments.at(0);
}

TEST(Igc, ReadsARecord) {
  const Track track =
      read_bytes("AXXX001\r\nHFDTE021023\r\nB0745104647347N00938282EA0244702644\r\n", "x");
  const Fix& fix = fixes_of(track)[0];
  EXPECT_EQ(track.format, Format::igc);
  EXPECT_NEAR(fix.place.latitude_deg, 46.0 + 47.347 / 60.0, 1e-12);
  EXPECT_NEAR(fix.place.longitude_deg, 9.0 + 38.282 / 60.0, 1e-12);
  EXPECT_EQ(fix.pressure_m, 2447.0);
  EXPECT_EQ(fix.gnss_m, 2644.0);
  EXPECT_EQ(fix.time_s, kDay_s + 7 * 3600 + 45 * 60 + 10);
  EXPECT_EQ(track.clock, Clock::utc);
  EXPECT_TRUE(track.notes.empty()) << notes_of(track);
}

TEST(Igc, ReadsTheSouthTheWestAndHeightsBelowTheSea) {
  const Track track = read_bytes(kHead + "B0745104647347S00938282WA-0012-0100\n", "x");
  const Fix& fix = fixes_of(track)[0];
  EXPECT_LT(fix.place.latitude_deg, -46.0);
  EXPECT_LT(fix.place.longitude_deg, -9.0);
  EXPECT_EQ(fix.pressure_m, -12.0);
  EXPECT_EQ(fix.gnss_m, -100.0);
}

TEST(Igc, ReadsMoreDigitsOfPlaceAndTime) {
  // The columns are counted from 1: FXA 36..38, SIU 39..40, LAD 41..42, LOD 43..44, TDS 45..46.
  const Track track = read_bytes(kHead +
                                     "I053638FXA3940SIU4142LAD4344LOD4546TDS\r\n"
                                     "B0745104647347N00938282EA024470264400610225507\r\n",
                                 "x");
  const Fix& fix = fixes_of(track)[0];
  EXPECT_NEAR(fix.place.latitude_deg, 46.0 + 47.34722 / 60.0, 1e-12);
  EXPECT_NEAR(fix.place.longitude_deg, 9.0 + 38.28255 / 60.0, 1e-12);
  EXPECT_NEAR(*fix.time_s, kDay_s + 27910.07, 1e-6);
}

TEST(Igc, BearsExtensionsThatAreMissingOrWrong) {
  for (const char* extensions : {"I013636LAD", "I019999LAD", "I01", "I013610LAD", "IXX36LAD"}) {
    const Track track = read_bytes(kHead + extensions + "\r\n" + fix("074510"), "x");
    EXPECT_NEAR(fixes_of(track)[0].place.latitude_deg, 46.0, 1e-12) << extensions;
  }
}

struct DateRow {
  const char* header;
  double day_s;  // 0: no date
};

TEST(Igc, ReadsEveryFormOfDate) {
  const DateRow rows[] = {
      {"HFDTE021023", kDay_s},      {"HFDTEDATE:021023,01", kDay_s},
      {"HFDTEDATE:021023", kDay_s}, {"HFDTEDATE: 021023,02", kDay_s},
      {"HODTE021023", kDay_s},      {"HPDTE021023", kDay_s},
      {"HFDTE:021023", kDay_s},     {"HFDTE02102023", kDay_s},
      {"HFDTE311299", 946598400.0}, {"HFDTE010170", 0.0},
      {"HFDTE010180", 0.0},         {"HFDTE000000", 0.0},
      {"HFDTE320123", 0.0},         {"HFDTE", 0.0},
      {"HFDTEDATE:,01", 0.0},
  };
  for (const DateRow& row : rows) {
    const Track track =
        read_bytes(std::string("AXXX\r\n") + row.header + "\r\n" + fix("000001"), "x");
    EXPECT_EQ(fixes_of(track)[0].time_s, row.day_s + 1.0) << row.header;
    EXPECT_EQ(track.clock, row.day_s == 0.0 ? Clock::of_day : Clock::utc) << row.header;
    EXPECT_EQ(notes_of(track).empty(), row.day_s != 0.0) << row.header << notes_of(track);
  }
}

TEST(Igc, TakesADateThatComesLate) {
  const std::string rows[] = {
      "AXXX\r\nI013636LAD\r\nJ010810DTE\r\nHFDTE021023\r\n" + fix("000001") + fix("000002", 9),
      "AXXX\r\n" + fix("000001") + "HFDTE021023\r\n" + fix("000002", 9),
      "AXXX\r\n" + fix("000001") + fix("000002", 9) + "HFDTE021023\r\n",
  };
  for (const std::string& row : rows) {
    const Track track = read_bytes(row, "x");
    ASSERT_EQ(fixes_of(track).size(), 2u);
    EXPECT_EQ(fixes_of(track)[0].time_s, kDay_s + 1.0);
    EXPECT_EQ(fixes_of(track)[1].time_s, kDay_s + 2.0);
  }
}

struct MidnightRow {
  const char* name;
  std::string text;
  std::vector<double> times_s;  // after the day of the header
};

TEST(Igc, PassesMidnight) {
  const std::string next = "HFDTE031023\r\n", same = "HFDTE021023\r\n";
  const MidnightRow rows[] = {
      {"without a new date", fix("235959") + fix("000001", 1), {86399, 86401}},
      {"with a new date", fix("235959") + next + fix("000001", 1), {86399, 86401}},
      {"with a late new date",
       fix("235959") + fix("000001", 1) + next + fix("000002", 2),
       {86399, 86401, 86402}},
      {"the old date again", fix("235959") + same + fix("000001", 1), {86399, 86401}},
      {"twice",
       fix("230000") + fix("010000", 1) + fix("120000", 2) + fix("230000", 3) + fix("010000", 4),
       {82800, 90000, 129600, 169200, 176400}},
      {"a wrong time at noon",
       fix("120000") + fix("235959", 1) + fix("120002", 2) + fix("120003", 3),
       {43200, 43202, 43203}},
      {"a step back",
       fix("115959") + fix("120000", 1) + fix("110000", 2) + fix("120001", 3),
       {43199, 43200, 43201}},
  };
  for (const MidnightRow& row : rows) {
    SCOPED_TRACE(row.name);
    const Track track = read_bytes(kHead + row.text, "x");
    ASSERT_EQ(track.fix_count(), row.times_s.size()) << notes_of(track);
    for (std::size_t i = 0; i < row.times_s.size(); ++i) {
      EXPECT_EQ(fixes_of(track)[i].time_s, kDay_s + row.times_s[i]);
    }
  }
}

TEST(Igc, SaysThatThereAreSeveralDates) {
  const Track track = read_bytes("AXXX\r\nHFDTE011023\r\nHFDTE021023\r\n" + fix("000001"), "x");
  EXPECT_EQ(fixes_of(track)[0].time_s, kDay_s + 1.0);
  EXPECT_TRUE(says(notes_of(track), "The header has several dates; the last was taken."));
}

TEST(Igc, LeavesOutTimesThatFallBackOrRepeat) {
  const Track track = read_bytes(kHead + fix("100000") + fix("100001", 1) + fix("100001", 2) +
                                     fix("095900", 3) + fix("100002", 4),
                                 "x");
  EXPECT_EQ(track.fix_count(), 3u);
  EXPECT_TRUE(says(notes_of(track), "1 fix was left out because the clock ran backwards"));
  EXPECT_TRUE(says(notes_of(track), "1 fix was left out because the one before has the same time"));
}

TEST(Igc, MarksDoubtfulFixes) {
  const Track track = read_bytes(
      kHead + fix("100000", 0, "0000000000", 'V') + fix("100001", 1) + fix("100002", 2), "x");
  EXPECT_FALSE(fixes_of(track)[0].valid);
  EXPECT_TRUE(fixes_of(track)[1].valid);
  EXPECT_TRUE(track.notes.empty()) << notes_of(track);
}

TEST(Igc, UsesDoubtfulFixesIfMostAreSuch) {
  const std::string nowhere = "B0959590000000N00000000EV0000000000\r\n";
  const Track track = read_bytes(kHead + nowhere + fix("100000", 0, "0095000905", 'V') +
                                     fix("100001", 1, "0095100000", 'V') + fix("100002", 2),
                                 "x");
  EXPECT_FALSE(fixes_of(track)[0].valid);
  EXPECT_TRUE(fixes_of(track)[1].valid);
  EXPECT_FALSE(fixes_of(track)[1].gnss_m);
  EXPECT_EQ(fixes_of(track)[1].pressure_m, 950.0);
  EXPECT_TRUE(says(notes_of(track), "3 fixes are marked V"));
}

TEST(Igc, KnowsNoHeightsThatAreOnlyZeros) {
  const Track pressure =
      read_bytes(kHead + fix("100000", 0, "0000000905") + fix("100001", 1, "0000000906"), "x");
  EXPECT_FALSE(fixes_of(pressure)[0].pressure_m);
  EXPECT_EQ(fixes_of(pressure)[0].gnss_m, 905.0);
  EXPECT_TRUE(says(notes_of(pressure), "no pressure heights, only zeros"));
  const Track gnss =
      read_bytes(kHead + fix("100000", 0, "0090500000") + fix("100001", 1, "0090500000"), "x");
  EXPECT_FALSE(fixes_of(gnss)[0].gnss_m);
  EXPECT_TRUE(says(notes_of(gnss), "no GNSS heights, only zeros"));
}

struct ReferenceRow {
  const char* header;
  HeightReference reference;
};

TEST(Igc, ReadsWhatTheHeightsAreMeasuredFrom) {
  const ReferenceRow rows[] = {
      {"", HeightReference::unknown},
      {"HFALGALTGPS:GEO", HeightReference::sea},
      {"HFALG:ELL", HeightReference::ellipsoid},
      {"HFALGALTGPS:ELL", HeightReference::ellipsoid},
      {"HFALGALTGPS:NIL", HeightReference::unknown},
  };
  for (const ReferenceRow& row : rows) {
    const Track track = read_bytes(kHead + row.header + "\r\n" + fix("100000"), "x");
    EXPECT_EQ(track.reference, row.reference) << row.header;
    const bool is_nil = std::string(row.header).find("NIL") != std::string::npos;
    EXPECT_EQ(fixes_of(track)[0].gnss_m.has_value(), !is_nil) << row.header;
  }
}

TEST(Igc, SkipsOtherRecordsAndSaysWhichFixesItCouldNotRead) {
  const std::string text =
      "\xef\xbb\xbf\r\n\r\nAXXX Balloon\r\n" +
      std::string(
          "HFDTE021023\r\nHFPLT:J\xfcrg\r\n"
          "HFGTYGLIDERTYPE:M\xfcnchen\r\nHFATS:1022\r\n\r\n"
          "LXXX alt unit=feet\r\nC0210230101010\r\nF100000030405\r\nE100000XX11525/8950,1500ft\r\n"
          "K10000012\r\nD10000\r\nD20000\r\n") +
      fix("100000") +
      "B1000\r\nB10000XXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXX\r\n"
      "b100001\r\n" +
      fix("100001", 1) + "G0123ABC\r\n";
  const Track track = read_bytes(text, "x");
  EXPECT_EQ(track.fix_count(), 2u);
  EXPECT_EQ(track.name, "M\xc3\xbcnchen");
  EXPECT_TRUE(says(notes_of(track), "2 lines of fixes could not be read"));
}

TEST(Igc, ReadsEveryLineEnd) {
  for (const std::string end : {"\n", "\r", "\r\n", "\r\r\n"}) {
    const std::string text = "AXXX" + end + "HFDTE021023" + end +
                             "B1000004600000N00900000EA0095000905" + end +
                             "B1000014600000N00900001EA0095000905";
    EXPECT_EQ(read_bytes(text, "x").fix_count(), 2u);
  }
}

TEST(Igc, RefusesFilesWithoutFixes) {
  EXPECT_TRUE(says(complaint("AXXX\r\nHFDTE021023\r\n"), "no fix with a usable place"));
  EXPECT_TRUE(
      says(complaint(kHead + "B1000000000000N00000000EV0000000000\r\n"), "no fix with a usable"));
  EXPECT_TRUE(
      says(complaint(kHead + "B1000009900000N00900000EA0000000000\r\n"), "no fix with a usable"));
  EXPECT_TRUE(
      says(complaint("A letter to nobody\n"), "expected the content of a GPX, IGC, KML or KMZ"));
}

}  // namespace
}  // namespace aerostat::track

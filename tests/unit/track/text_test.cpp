#include "track/text.hpp"

#include <gtest/gtest.h>

namespace aerostat::track {
namespace {

struct TimeRow {
  const char* text;
  double time_s;  // -1: no time
  bool has_zone = true;
};

TEST(TrackText, ReadsTimesInEveryForm) {
  const double base_s = 1696232710.0;  // 2023-10-02 07:45:10 UTC
  const TimeRow rows[] = {
      {"2023-10-02T07:45:10Z", base_s},
      {" 2023-10-02T07:45:10Z\n", base_s},
      {"2023-10-02t07:45:10z", base_s},
      {"2023-10-02 07:45:10Z", base_s},
      {"2023-10-02T07:45:10.250Z", base_s + 0.25},
      {"2023-10-02T07:45:10,5Z", base_s + 0.5},
      {"2023-10-02T09:45:10+02:00", base_s},
      {"2023-10-02T09:45:10+0200", base_s},
      {"2023-10-02T09:45:10+02", base_s},
      {"2023-10-02T02:15:10.5-05:30", base_s + 0.5},
      {"2023-10-02T07:45:10", base_s, false},
      {"2023-10-02T07:45Z", base_s - 10.0},
      {"1970-01-01T00:00:00Z", 0.0},
      {"2024-02-29T00:00:00Z", 1709164800.0},
      {"2016-12-31T23:59:60Z", 1483228800.0},
      {"2023-02-29T00:00:00Z", -1.0},
      {"2023-13-01T00:00:00Z", -1.0},
      {"2023-10-02", -1.0},
      {"2023-10-02T25:00:00Z", -1.0},
      {"2023-10-02T07:60:00Z", -1.0},
      {"2023-10-02T07:45:10Zulu", -1.0},
      {"", -1.0},
      {"yesterday", -1.0},
  };
  for (const TimeRow& row : rows) {
    const auto time = time_of(row.text);
    ASSERT_EQ(time.has_value(), row.time_s >= 0.0) << row.text;
    if (!time) continue;
    EXPECT_NEAR(time->time_s, row.time_s, 1e-6) << row.text;
    EXPECT_EQ(time->has_zone, row.has_zone) << row.text;
  }
}

TEST(TrackText, WritesTimes) {
  EXPECT_EQ(utc_text(1696232710.9), "2023-10-02 07:45:10 UTC");
  EXPECT_EQ(utc_text(-1.0), "1969-12-31 23:59:59 UTC");
  EXPECT_EQ(clock_text(86400.0 + 3661.0), "01:01:01");
  EXPECT_EQ(utc_text(1e300), "an unknown time");
}

TEST(TrackText, ReadsNumbersWithAPointInEveryLocale) {
  EXPECT_EQ(number_of(" 46.5 "), 46.5);
  EXPECT_EQ(number_of("+46.5"), 46.5);
  EXPECT_EQ(number_of("-1e2"), -100.0);
  for (const char* text : {"", "46,5", "nan", "inf", "1e999", "46.5x", "+-1", "0x10"}) {
    EXPECT_FALSE(number_of(text)) << text;
  }
}

TEST(TrackText, TurnsNamesIntoUtf8) {
  EXPECT_EQ(clean_text("Z\xc3\xbcrich"), "Z\xc3\xbcrich");
  EXPECT_EQ(clean_text("Z\xfcrich"), "Z\xc3\xbcrich");
  EXPECT_EQ(clean_text("a\nb"), "a b");
  EXPECT_LE(clean_text(std::string(100000, 'x')).size(), 200u);
  EXPECT_TRUE(is_utf8("\xf0\x9f\x8e\x88"));
  for (const char* text : {"\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\x80"}) {
    EXPECT_FALSE(is_utf8(text));
  }
}

}  // namespace
}  // namespace aerostat::track

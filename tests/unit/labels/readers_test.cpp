// Tests the readers of places: what they read, what they refuse, and that they take any bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "labels/places.hpp"

namespace aerostat::labels {
namespace {

constexpr const char* kGeoJson = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "Kesch", "ele": "3418"},
   "geometry": {"type": "Point", "coordinates": [9.8725, 46.6217, 5]}},
  {"type": "Feature", "properties": {"name": " Twins "},
   "geometry": {"type": "MultiPoint", "coordinates": [[9.1, 46.1, 1200.5], [9.2, 46.2]]}},
  {"type": "Feature", "properties": {"name": "a road"},
   "geometry": {"type": "LineString", "coordinates": [[9, 46], [9, 47]]}},
  {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [9, 46]}}
]})";
constexpr const char* kCsv =
    "id;Name;LAT;Longitude;ele\r\n1;\"Piz; \"\"Kesch\"\"\";46,6217;9.8725;3418\r\n\r\n"
    "2;;1;2;3\r\n3;Davos;46.80;9.83;\r\n";

std::string error_of(const std::string& text) {
  try {
    text.starts_with("{") ? places_of_geojson(text, "x") : places_of_csv(text, "x");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    return error.what();
  }
  return {};
}

TEST(Places, OfGeoJson) {
  const std::vector<NamedPlace> places = places_of_geojson(kGeoJson, "x");
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].name, "Kesch");
  EXPECT_EQ(places[0].place, (geo::Place{46.6217, 9.8725}));
  EXPECT_EQ(places[0].height_m, 3418.0);
  EXPECT_EQ(places[1].name, "Twins");
  EXPECT_EQ(places[1].height_m, 1200.5);
  EXPECT_EQ(places[2].place, (geo::Place{46.2, 9.2}));
  EXPECT_FALSE(places[2].height_m);
}

TEST(Places, OfCsv) {
  const std::vector<NamedPlace> places = places_of_csv(kCsv, "x");
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].name, "Piz; \"Kesch\"");
  EXPECT_EQ(places[0].place, (geo::Place{46.6217, 9.8725}));
  EXPECT_EQ(places[0].height_m, 3418.0);
  EXPECT_EQ(places[1].name, "Davos");
  EXPECT_FALSE(places[1].height_m);
  EXPECT_EQ(places_of_csv("lon,lat,name\n9,46,a", "x")[0].place, (geo::Place{46.0, 9.0}));
}

TEST(Places, FaultsAreToldWithTheirLine) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"name,lat,lon\na,1,2\nb,95,2\n", "x:3: found the latitude 95"},
      {"name,lat,lon\na,1,190\n", "x:2: found the longitude 190"},
      {"name,lat,lon\n\"a\n\",north,2\n", "x:2: found the latitude 'north'"},
      {"name,lat,lon\na,1\n", "x:2: found no latitude or no longitude"},
      {"name,lat,lon\n\"a,1,2\n", "x:2: found a quotation mark without its end"},
      {"a,b\n1,2\n", "x:1: found no header"},
      {"name,lat,lon\n", "x: found no place"},
      {"", "x:1: found no header"},
      {"{\"type\": 3}", "x:1:1: "},
      {"{\"type\": \"Feature\",\n\"properties\": {\"name\": \"a\"},\n\"geometry\": {\"type\": "
       "\"Point\",\n\"coordinates\": [9]}}",
       "x:4:1: /geometry/coordinates: found "},
      {"{\"type\": \"FeatureCollection\", \"features\": []}", "x: found no place"},
      {"{\n\"type\": ]", "x: line 2, column 9: syntax error"},
  };
  for (const auto& [text, message] : faults) {
    EXPECT_EQ(error_of(text).substr(0, message.size()), message) << text;
  }
}

TEST(Places, ControlCharactersDoNotReachNames) {
  EXPECT_EQ(places_of_csv("name,lat,lon\na\x01\x1b,1,2\n", "x")[0].name.find('\x1b'),
            std::string::npos);
}

// Tests damaged copies: whatever the bytes are, they are read or refused in words.
TEST(Places, AnyBytesAreReadOrRefused) {
  constexpr std::uint32_t kSeed = 15;
  std::mt19937 random(kSeed);
  const auto below = [&](std::size_t count) { return random() % count; };
  int read = 0, refused = 0;
  for (int i = 0; i < 6000; ++i) {
    std::string text = i % 2 == 0 ? kGeoJson : kCsv;
    for (std::size_t k = below(4) + 1; k > 0; --k) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, below(20) + 1);
          break;
        case 2:
          text.insert(at, text.substr(below(text.size()), below(30)));
          break;
        default:
          text.insert(at, 1, ",;\"\n{}[]-9e"[below(11)]);
      }
      if (text.empty()) text = "x";
    }
    try {
      const auto places = i % 2 == 0 ? places_of_geojson(text, "x") : places_of_csv(text, "x");
      EXPECT_FALSE(places.empty());
      for (const NamedPlace& place : places) EXPECT_LE(std::abs(place.place.latitude_deg), 90.0);
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_data) << "seed " << kSeed;
      ++refused;
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace aerostat::labels

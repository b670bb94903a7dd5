#include "land/cover_codes.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/error_of.hpp"

namespace aerostat::land {
namespace {

KnownCodes codes_in(const CoverCounts& found, CoverScheme scheme = CoverScheme::automatic,
                    const CoverCodes& own = {}) {
  return known_codes(scheme, own, found, "cover.tif");
}

TEST(CoverCodes, AreThoseOfTheSchemeThatKnowsAll) {
  const KnownCodes esa = codes_in({{10, 5}, {60, 1}, {80, 2}, {95, 1}});
  EXPECT_EQ(esa.classes.at(10), CoverClass::woods);
  EXPECT_EQ(esa.classes.at(80), CoverClass::water);
  EXPECT_NE(esa.note.find("WorldCover"), std::string::npos);
  const KnownCodes nlcd = codes_in({{11, 5}, {42, 1}, {82, 2}, {95, 1}});
  EXPECT_EQ(nlcd.classes.at(42), CoverClass::woods);
  EXPECT_EQ(nlcd.classes.at(82), CoverClass::crops);
  EXPECT_NE(nlcd.note.find("NLCD"), std::string::npos);
  const KnownCodes corine = codes_in({{112, 5}, {312, 1}, {335, 1}, {512, 2}});
  EXPECT_EQ(corine.classes.at(312), CoverClass::woods);
  EXPECT_EQ(corine.classes.at(335), CoverClass::snow);
  // The classes of CORINE are numbered in the order of their codes: 24 is 312, and 41 is 512.
  const KnownCodes numbered = codes_in({{2, 5}, {24, 1}, {34, 1}, {41, 2}});
  EXPECT_EQ(numbered.classes.at(24), CoverClass::woods);
  EXPECT_EQ(numbered.classes.at(34), CoverClass::snow);
  EXPECT_EQ(numbered.classes.at(41), CoverClass::water);
}

TEST(CoverCodes, OfTheUserWin) {
  const KnownCodes known =
      codes_in({{10, 5}, {7, 1}}, CoverScheme::worldcover, {{7, CoverClass::water}});
  EXPECT_EQ(known.classes.at(7), CoverClass::water);
  EXPECT_EQ(known.classes.at(10), CoverClass::woods);
  EXPECT_EQ(codes_in({{10, 5}}, CoverScheme::worldcover, {{10, CoverClass::bare}}).classes.at(10),
            CoverClass::bare);
  // They may be enough without any scheme.
  const KnownCodes own = codes_in({{1, 5}, {2, 1}}, CoverScheme::automatic,
                                  {{1, CoverClass::water}, {2, CoverClass::woods}});
  EXPECT_EQ(own.note, "");
  EXPECT_EQ(own.classes.at(2), CoverClass::woods);
}

TEST(CoverCodes, ThatAreUnknownAreListed) {
  const auto message = [](CoverScheme scheme) {
    return std::string(test::error_of([=] { codes_in({{10, 3}, {777, 1}}, scheme); }).what());
  };
  const std::string text = message(CoverScheme::worldcover);
  EXPECT_NE(text.find("cover.tif: 1 of the codes of land cover is unknown to ESA WorldCover"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("10 (75 %), 777 (25 %)"), std::string::npos) << text;
  EXPECT_NE(text.find("/terrain/cover/classes"), std::string::npos) << text;
  EXPECT_NE(message(CoverScheme::automatic).find("777 (25 %)"), std::string::npos);
}

}  // namespace
}  // namespace aerostat::land

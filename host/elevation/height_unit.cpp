#include "elevation/height_unit.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

constexpr double kSurveyFoot = 1200.0 / 3937.0;
struct Row {
  std::string_view words;  // each between bars
  HeightUnit unit;
};
constexpr std::array kRows{
    Row{"|m|metre|metres|meter|meters|metre(s)|meter(s)|mtr|", {1.0, "metre"}},
    Row{"|ft|foot|feet|foot(intl)|ift|internationalfoot|internationalfeet|foot_international|",
        {0.3048, "foot"}},
    Row{"|ftus|us-ft|usft|us_ft|ussurveyfoot|ussurveyfeet|us_survey_foot|foot_us|surveyfoot|"
        "surveyfeet|us_foot|usfoot|u.s.surveyfoot|",
        {kSurveyFoot, "US survey foot"}},
    Row{"|dm|decimetre|decimetres|decimeter|decimeters|", {0.1, "decimetre"}},
    Row{"|cm|centimetre|centimetres|centimeter|centimeters|", {0.01, "centimetre"}},
    Row{"|mm|millimetre|millimetres|millimeter|millimeters|", {0.001, "millimetre"}},
    Row{"|km|kilometre|kilometres|kilometer|kilometers|", {1000.0, "kilometre"}},
    Row{"|yd|yard|yards|", {0.9144, "yard"}},
    Row{"|fathom|fathoms|", {1.8288, "fathom"}}};

}  // namespace

std::optional<HeightUnit> height_unit_of(const std::string& name) {
  std::string word = "|";
  for (const char c : lower_case(name)) {
    if (c != ' ') word += c;
  }
  word += '|';
  if (word.size() < 3 || word.find('|', 1) != word.size() - 1) return std::nullopt;
  for (const Row& row : kRows) {
    if (row.words.find(word) != std::string_view::npos) return row.unit;
  }
  return std::nullopt;
}

std::optional<HeightUnit> height_unit_of(double metres) {
  for (const Row& row : kRows) {
    if (std::abs(row.unit.metres - metres) < 1e-9) return row.unit;
  }
  return std::nullopt;
}

}  // namespace aerostat::elevation

// Tests that no Russian text of the window is missing, and that each takes the arguments of its
// original.

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace aerostat {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> all_of(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) {
    found.push_back((*at)[1]);
  }
  return found;
}

/// Returns every "%1", "%n" and "[*]" in a text, each as often as it occurs.
std::vector<std::string> places_in(const std::string& text) {
  auto places = all_of(text, std::regex(R"((%[n0-9]|\[\*\]))"));
  std::sort(places.begin(), places.end());
  return places;
}

TEST(Translation, RussianIsComplete) {
  const std::string text =
      file_text(AEROSTAT_SOURCE_DIR "/host/viewer/translations/aerostat_ru.ts");
  EXPECT_EQ(text.find("unfinished"), std::string::npos);
  EXPECT_EQ(text.find("vanished"), std::string::npos);
  EXPECT_EQ(text.find("<translation />"), std::string::npos);
  EXPECT_EQ(text.find("<numerusform />"), std::string::npos);
  EXPECT_GE(all_of(text, std::regex("<(source)>")).size(), 300u);
}

TEST(Translation, RussianKeepsPlacesAndForms) {
  const std::string text =
      file_text(AEROSTAT_SOURCE_DIR "/host/viewer/translations/aerostat_ru.ts");
  // The messages are matched one by one, because std::regex fails on all of them at once.
  for (std::size_t at = 0; (at = text.find("<message", at)) != std::string::npos; ++at) {
    const std::string message = text.substr(at, text.find("</message>", at) - at);
    const auto source = all_of(message, std::regex("<source>([^<]*)</source>"));
    ASSERT_EQ(source.size(), 1u) << message;
    auto forms = all_of(message, std::regex("<numerusform>([^<]+)</numerusform>"));
    if (message.find("numerus=\"yes\"") != std::string::npos) {
      EXPECT_EQ(forms.size(), 3u) << source[0];
    } else {
      forms = all_of(message, std::regex("<translation>([^<]+)</translation>"));
      EXPECT_EQ(forms.size(), 1u) << source[0];
    }
    for (const std::string& form : forms) EXPECT_EQ(places_in(form), places_in(source[0])) << form;
  }
}

}  // namespace
}  // namespace aerostat

// Tests that films go through Open Image Denoise as they should. A fake library of the tests stands
// for the true one. Each test runs in a process of its own, so that each loads a library anew.
#include "denoise/denoise.hpp"

#include <cstdlib>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/error_of.hpp"

namespace aerostat::denoise {
namespace {

void use_fake(const char* fault = "") {
  ::setenv("AEROSTAT_OIDN_DIR", AEROSTAT_FAKE_OIDN_DIR, 1);
  ::setenv("FAKE_OIDN", fault, 1);
}

image::Film film_of(int width, int height) {
  image::Film film;
  film.width = width;
  film.height = height;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  film.radiance.resize(pixels);
  film.albedo.resize(pixels);
  film.normal_ws.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto value = static_cast<float>(i);
    film.radiance[i] = {value, 2.0f, 3.0f};
    film.albedo[i] = {0.25f, 0.5f, 0.75f};
    film.normal_ws[i] = {0.0f, 1.0f, 0.0f};
  }
  return film;
}

TEST(Denoise, GivesTheLibraryColorAlbedoAndNormal) {
  use_fake();
  image::Film film = film_of(5, 3);
  denoise(film);
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    EXPECT_EQ(film.radiance[i], vec3(static_cast<float>(i) + 2.5f, 107.0f, 10.5f)) << i;
  }
  EXPECT_EQ(film.albedo[7], vec3(0.25f, 0.5f, 0.75f));
}

TEST(Denoise, TellsItsProgress) {
  use_fake();
  image::Film film = film_of(4, 4);
  std::vector<double> shares;
  denoise(film, {.progress = [&](double share) { shares.push_back(share); }});
  EXPECT_EQ(shares, (std::vector<double>{0.0, 0.5, 1.0}));
}

TEST(Denoise, StopsWhenAsked) {
  use_fake();
  image::Film film = film_of(4, 4);
  std::stop_source source;
  const Options options{.stop = source.get_token(),
                        .progress = [&](double) { source.request_stop(); }};
  const Error error = test::error_of([&] { denoise(film, options); });
  EXPECT_EQ(error.kind(), ErrorKind::interrupted) << error.what();
  EXPECT_EQ(film.radiance[3], vec3(3.0f, 2.0f, 3.0f)) << "the film stays as it was";
}

TEST(Denoise, NeedsAllLayers) {
  use_fake();
  image::Film film = film_of(4, 4);
  film.albedo.clear();
  EXPECT_EQ(test::error_of([&] { denoise(film); }).kind(), ErrorKind::internal);
}

TEST(Denoise, PassesOnTheWordsOfTheLibrary) {
  use_fake("memory");
  image::Film film = film_of(4, 4);
  const Error error = test::error_of([&] { denoise(film); });
  EXPECT_EQ(error.kind(), ErrorKind::exhausted);
  EXPECT_NE(std::string(error.what()).find("no memory for the weights"), std::string::npos);
}

TEST(Denoise, RefusesAProcessorThatTheLibraryRefuses) {
  use_fake("unsupported");
  const Error error = test::error_of([] { require_library(); });
  EXPECT_NE(std::string(error.what()).find("this processor is too old"), std::string::npos);
}

TEST(Denoise, RefusesAnotherVersion) {
  use_fake("old");
  const Error error = test::error_of([] { require_library(); });
  EXPECT_EQ(error.kind(), ErrorKind::no_device);
  EXPECT_NE(std::string(error.what()).find("1.4.3"), std::string::npos) << error.what();
}

TEST(Denoise, SaysWhatToInstallIfThereIsNoLibrary) {
  ::setenv("AEROSTAT_OIDN_DIR", "/nowhere", 1);
  for (int i = 0; i < 2; ++i) {
    const Error error = test::error_of([] { require_library(); });
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    for (const char* word : {"libOpenImageDenoise.so.2", "/nowhere", "AEROSTAT_OIDN_DIR"}) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace aerostat::denoise

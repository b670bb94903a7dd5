#include "take_checkpoint.hpp"

#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "core/checksum.hpp"
#include "core/error.hpp"
#include "render/checkpoint.hpp"

namespace aerostat::test {
namespace {

constexpr const char* kName = "11/385/803.fuzz";
constexpr render::Crop kWindow{1, 2, 5, 5};
constexpr int kSamples = 64;
constexpr std::size_t kMagicBytes = 22;
constexpr std::size_t kHeadAt = kMagicBytes + 12;

const render::Traits& traits() {
  static const render::Traits all{{"scene", "0123456789abcdef"}, {"size", "4 x 3"}};
  return all;
}

template <typename T>
std::string bytes_of(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

/// Returns a file whose head are these bytes.
std::string with_head(const std::string& head) {
  return "aerostat checkpoint 1\n" + bytes_of(checksum(head)) +
         bytes_of(static_cast<std::uint32_t>(head.size())) + head +
         std::string(kWindow.pixels() * sizeof(AeroFilmPixel), '\0');
}

/// Returns what is wrong with sums that were accepted.
std::string fault_of(const render::FilmSums& sums) {
  try {
    render::require_fitting(sums, kWindow, kSamples, false);
  } catch (const Error& error) {
    return std::string("sums that do not fit were accepted: ") + error.what();
  }
  for (const AeroFilmPixel& pixel : sums.pixels) {
    const bool is_sound = pixel.samples <= kSamples && pixel.coverage >= 0.0f &&
                          pixel.coverage <= static_cast<float>(kSamples);
    if (!is_sound) return "impossible sums were accepted";
  }
  return {};
}

}  // namespace

std::string fault_of_checkpoint(std::span<const std::uint8_t> bytes, bool& is_read) {
  is_read = false;
  std::string file(bytes.begin(), bytes.end());
  if (!file.empty() && file[0] % 2 != 0) file = with_head(file.substr(1));
  try {
    const render::FilmSums sums =
        render::parse_checkpoint({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()},
                                 kName, traits(), kWindow, kSamples, false);
    is_read = true;
    return fault_of(sums);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) return error.what();
    const std::string message = error.what();
    return message.find(kName) != std::string::npos ? "" : "no file is named: " + message;
  } catch (const std::exception& error) {
    return std::string("not an error of aerostat's own: ") + error.what();
  }
}

std::string whole_checkpoint() {
  render::FilmSums sums;
  sums.window = kWindow;
  sums.samples_done = 16;
  sums.waiting = {{3, 4}};
  sums.pixels.resize(kWindow.pixels());
  for (AeroFilmPixel& pixel : sums.pixels) pixel = {};
  const auto path = std::filesystem::temp_directory_path() /
                    ("aerostat-checkpoint-" + std::to_string(::getpid()));
  render::write_checkpoint(path, traits(), sums);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  std::filesystem::remove(path);
  const std::size_t pixels = sums.pixels.size() * sizeof(AeroFilmPixel);
  return "\1" + bytes.substr(kHeadAt, bytes.size() - kHeadAt - pixels);
}

}  // namespace aerostat::test

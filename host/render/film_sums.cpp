#include "render/film_sums.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "core/error.hpp"
#include "render/film_buffer.hpp"

namespace aerostat::render {
namespace {

template <typename T>
void read_rows(const opencl::Buffer<T>& film, const FilmRows& rows, const Crop& window,
               Array<T>& sums) {
  const auto width = static_cast<std::size_t>(window.x1 - window.x0);
  const std::size_t first = static_cast<std::size_t>(rows.y0 - window.y0) * width;
  const std::size_t count = static_cast<std::size_t>(rows.y1 - rows.y0) * width;
  film.read(std::span(sums).subspan(first, count), first);
}

[[noreturn]] void refuse(const std::string& found, const std::string& expected) {
  throw Error(ErrorKind::usage, fmt::format("going on with a render: found sums of {}, expected {}",
                                            found, expected));
}

std::string text_of(const Crop& pixels) {
  return fmt::format("the pixels {},{},{},{}", pixels.x0, pixels.y0, pixels.x1, pixels.y1);
}

bool are_inside(const std::vector<RowRange>& rows, const Crop& window) {
  int end = window.y0;
  for (const RowRange& run : rows) {
    if (run.y0 < end || run.y1 <= run.y0 || run.y1 > window.y1) return false;
    end = run.y1;
  }
  return true;
}

}  // namespace

FilmSums read_sums(std::span<const FilmRows> parts, const Crop& window, bool with_guides) {
  FilmSums sums;
  sums.window = window;
  sums.pixels.resize(window.pixels());
  if (with_guides) sums.guides.resize(window.pixels());
  for (const FilmRows& rows : parts) {
    read_rows(rows.film->pixels, rows, window, sums.pixels);
    if (with_guides) read_rows(rows.film->guides, rows, window, sums.guides);
  }
  return sums;
}

void require_fitting(const FilmSums& sums, const Crop& window, int samples) {
  const Crop& has = sums.window;
  if (has.x0 != window.x0 || has.y0 != window.y0 || has.x1 != window.x1 || has.y1 != window.y1) {
    refuse(text_of(has), text_of(window));
  }
  if (sums.samples_done < 0 || sums.samples_done >= samples) {
    refuse(fmt::format("{} samples", sums.samples_done), fmt::format("0 to {}", samples - 1));
  }
  if (!are_inside(sums.waiting, window)) {
    refuse("waiting rows outside the picture", "rows inside it, from the top");
  }
}

void require_fitting(const FilmSums& sums, const Crop& window, int samples, bool with_guides) {
  require_fitting(sums, window, samples);
  const std::size_t pixels = window.pixels();
  if (sums.pixels.size() != pixels || sums.guides.size() != (with_guides ? pixels : 0)) {
    refuse(fmt::format("{} pixels and {} guides", sums.pixels.size(), sums.guides.size()),
           fmt::format("{} and {}", pixels, with_guides ? pixels : 0));
  }
}

}  // namespace aerostat::render

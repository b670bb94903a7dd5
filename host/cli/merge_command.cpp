#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/parse.hpp"
#include "cli/picture.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/stop_scope.hpp"
#include "film/frame_files.hpp"
#include "image/bands.hpp"
#include "image/glare.hpp"
#include "image/write.hpp"

namespace aerostat::cli {

namespace {

namespace fs = std::filesystem;

/// A file of a band, and what it tells without its pixels.
struct BandFile {
  fs::path file;
  std::string mark;
  glm::ivec2 whole{0};
  int first_row = 0, last_row = 0;
  bool is_as_wide = false;  // it has all columns of the picture
};

/// Reads the file of a band for its pixels. It was whole a moment ago.
image::Band pixels_of(const fs::path& file) {
  auto band = image::decode_band(film::bytes_of(file));
  if (!band) {
    throw Error(ErrorKind::bad_data, fmt::format("'{}' was changed meanwhile", file.string()));
  }
  return std::move(*band);
}

/// What is wrong with the files.
class Faults {
 public:
  void add(const std::string& fault) { text_ += (text_.empty() ? "" : "\naerostat: ") + fault; }

  /// Throws Error{bad_data} if there is any.
  void tell() const {
    if (!text_.empty()) throw Error(ErrorKind::bad_data, text_);
  }

 private:
  std::string text_;
};

std::vector<BandFile> survey(const std::vector<fs::path>& files, Faults& faults,
                             const std::stop_token& stop) {
  std::vector<BandFile> bands;
  for (const fs::path& file : files) {
    stop_if_asked(stop);
    const auto band = image::decode_band(film::bytes_of(file));
    if (!band) {
      faults.add(fmt::format("'{}' is damaged, or no band that 'aerostat render --shard' wrote",
                             file.string()));
      continue;
    }
    const image::Film& film = band->film;
    const bool is_as_wide = film.first.x == 0 && film.width == film.whole.x;
    bands.push_back(
        {file, band->mark, film.whole, film.first.y, film.first.y + film.height - 1, is_as_wide});
  }
  return bands;
}

/// Sorts the bands by their rows, and finds those of another picture and rows that are missing.
void check(std::vector<BandFile>& bands, Faults& faults) {
  if (bands.empty()) return;
  const BandFile first = bands.front();
  for (const BandFile& band : bands) {
    if (band.mark != first.mark || band.whole != first.whole || !band.is_as_wide) {
      faults.add(
          fmt::format("'{}' and '{}' were made from different scenes, sizes or qualities, "
                      "or by different versions",
                      band.file.string(), first.file.string()));
    }
  }
  std::stable_sort(bands.begin(), bands.end(),
                   [](const BandFile& a, const BandFile& b) { return a.first_row < b.first_row; });
  int next = 0;
  const auto miss = [&](int end) {
    if (end > next) faults.add(fmt::format("the rows {} to {} are missing", next, end - 1));
  };
  for (const BandFile& band : bands) {
    miss(band.first_row);
    next = std::max(next, band.last_row + 1);
  }
  miss(first.whole.y);
}

/// Returns the rows of a film from one row of the picture on.
image::Film rows_from(const image::Film& film, int row) {
  const int skipped = row - film.first.y;
  image::Film rest;
  rest.width = film.width;
  rest.height = film.height - skipped;
  rest.first = {film.first.x, row};
  rest.whole = film.whole;
  const auto from = static_cast<std::ptrdiff_t>(skipped) * film.width;
  const auto take = [from](const auto& values, auto& to) {
    if (!values.empty()) to.assign(values.begin() + from, values.end());
  };
  take(film.radiance, rest.radiance);
  take(film.alpha, rest.alpha);
  take(film.distance_m, rest.distance_m);
  take(film.albedo, rest.albedo);
  take(film.normal_ws, rest.normal_ws);
  take(film.object_id, rest.object_id);
  take(film.samples, rest.samples);
  return rest;
}

/// Calls `use` with the rows of the picture from the top to the bottom, each of them once, a band
/// at a time. Two bands with the same rows have the same bits.
template <typename Use>
void each_run(const std::vector<BandFile>& bands, const std::stop_token& stop, const Use& use) {
  int next = 0;
  for (const BandFile& band : bands) {
    if (band.last_row < next) continue;
    stop_if_asked(stop);
    image::Band read = pixels_of(band.file);
    if (read.film.first.y < next) read.film = rows_from(read.film, next);
    use(read);
    next = band.last_row + 1;
  }
}

std::vector<std::uint8_t> joined_exr(const std::vector<BandFile>& bands,
                                     const std::stop_token& stop) {
  std::unique_ptr<image::ExrWriter> writer;
  each_run(bands, stop, [&](const image::Band& band) {
    if (!writer) writer = std::make_unique<image::ExrWriter>(band.film, band.film.whole.y);
    writer->add(band.film);
  });
  return writer->take();
}

std::vector<std::uint8_t> joined_png(const std::vector<BandFile>& bands,
                                     const std::stop_token& stop) {
  image::Pixels pixels{bands.front().whole.x, bands.front().whole.y, {}};
  // Glare comes from all of the picture, so that the bands are read twice.
  std::optional<image::Glare> glare;
  each_run(bands, stop, [&](const image::Band& band) {
    if (!glare) glare.emplace(band.film.whole, band.development);
    glare->add(band.film);
  });
  glare->spread();
  each_run(bands, stop, [&](const image::Band& band) {
    const image::Pixels rows = image::develop(band.film, band.development, *glare);
    pixels.rgb.insert(pixels.rgb.end(), rows.rgb.begin(), rows.rgb.end());
  });
  return image::encode_png(pixels);
}

PictureFormat format_of(const MergeOptions& options) {
  const PictureFormat format = picture_format(options.output);
  if (is_standard(options.output) || format == PictureFormat::geotiff) {
    throw Error(ErrorKind::usage, fmt::format("--output: found '{}', expected a .png or .exr file",
                                              options.output.string()));
  }
  for (const fs::path& band : options.bands) {
    if (is_same_file(band, options.output)) {
      throw Error(ErrorKind::usage,
                  fmt::format("--output: '{}' is one of the bands", options.output.string()));
    }
  }
  require_writable(options.output);
  return format;
}

}  // namespace

int merge(const MergeOptions& options) {
  const PictureFormat format = format_of(options);
  const Interrupt interrupt;
  Faults faults;
  std::vector<BandFile> bands = survey(options.bands, faults, interrupt.token());
  check(bands, faults);
  faults.tell();
  const glm::ivec2 size = bands.front().whole;
  if (format == PictureFormat::png && !image::png_can_hold(size.x, size.y)) {
    throw Error(
        ErrorKind::usage,
        fmt::format("{} x {} pixels are too many for a PNG; write an .exr", size.x, size.y));
  }
  const auto bytes = format == PictureFormat::exr ? joined_exr(bands, interrupt.token())
                                                  : joined_png(bands, interrupt.token());
  stop_if_asked(interrupt.token());
  write_file(options.output, bytes);
  if (!options.quiet) {
    print_stderr(fmt::format("wrote {} ({} x {}) from {} bands\n", options.output.string(), size.x,
                             size.y, bands.size()));
  }
  return 0;
}

}  // namespace aerostat::cli

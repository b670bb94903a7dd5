#include "elevation/reading.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::elevation {

void refuse(const std::filesystem::path& path, const std::string& what) {
  throw Error(ErrorKind::bad_data, fmt::format("{}: {}", path.string(), what));
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string ending_of(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

std::optional<double> number_of(std::string_view text) {
  std::array<char, 64> copy{};
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() > copy.size()) return std::nullopt;
  std::transform(text.begin(), text.end(), copy.begin(), [](char c) {
    if (c == ',') return '.';
    return c == 'D' || c == 'd' ? 'e' : c;
  });
  double value = 0.0;
  const char* end = copy.data() + text.size();
  const auto [stop, code] = std::from_chars(copy.data(), end, value);
  if (code == std::errc::result_out_of_range && stop == end) {
    return text.find('-', 1) == std::string_view::npos ? HUGE_VAL : 0.0;
  }
  if (code != std::errc{} || stop != end) return std::nullopt;
  return value;
}

bool is_void_word(std::string_view word) {
  const std::string lower = lower_case(word);
  for (const char* known : {"nan", "-nan", "+nan", "null", "nodata", "na", "n/a", "inf", "-inf",
                            "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind", "1.#inf", "-1.#inf"}) {
    if (lower == known) return true;
  }
  return false;
}

void require_size(const std::filesystem::path& path, std::uint64_t width, std::uint64_t height,
                  bool windowed) {
  if (width < 2 || height < 2) {
    refuse(path,
           fmt::format("it has {} x {} samples, and at least 2 x 2 are needed", width, height));
  }
  constexpr std::uint64_t kSide = kMostSamplesASide;
  if (width > kSide || height > kSide) {
    refuse(path, fmt::format("it has {} x {} samples, and at most {} a side are read", width,
                             height, kSide));
  }
  const std::uint64_t most = windowed ? kMostSamples : kMostSamplesInMemory;
  if (width * height > most) {
    refuse(path,
           fmt::format("it has {} x {} samples, and at most {} can be read of this format{}", width,
                       height, most, windowed ? "" : "; a GeoTIFF with tiles may be larger"));
  }
}

void set_unit(RasterInfo& info, const OpenOptions& options, double metres_per_unit,
              const std::string& unit) {
  info.metres_per_unit = metres_per_unit;
  info.unit = unit;
  if (!options.metres_per_unit) return;
  const double factor = *options.metres_per_unit;
  if (!std::isfinite(factor) || factor == 0.0) {
    refuse(info.path, fmt::format("the heights cannot be in units of {} m", factor));
  }
  info.metres_per_unit = factor;
  info.unit = fmt::format("{} m", factor);
  struct Unit {
    double metres;
    const char* name;
  };
  constexpr Unit kUnits[] = {{1.0, "metre"},
                             {0.3048, "foot"},
                             {1200.0 / 3937.0, "US survey foot"},
                             {0.1, "decimetre"},
                             {0.01, "centimetre"}};
  for (const Unit& known : kUnits) {
    if (std::abs(factor - known.metres) < 1e-9) info.unit = known.name;
  }
}

Georeference place_without_earth(const RasterInfo& info, const OpenOptions& options) {
  const double cell = options.cell_m.value_or(1.0);
  if (!std::isfinite(cell) || cell <= 0.0) {
    refuse(info.path, fmt::format("the samples cannot be {} m apart", cell));
  }
  Georeference place;
  place.crs = options.crs;
  place.origin = dvec2(-0.5 * cell * (info.width - 1), 0.5 * cell * (info.height - 1));
  place.per_column = dvec2(cell, 0.0);
  place.per_row = dvec2(0.0, -cell);
  return place;
}

}  // namespace aerostat::elevation

#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "elevation/open.hpp"
#include "elevation/raster.hpp"

/// What the readers of several formats need.
namespace aerostat::elevation {

/// Throws Error{bad_data} with the name of the file. `what` says what was found and what was
/// expected.
[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what);

/// Returns the ending of a file's name in lower case, for example ".asc".
std::string ending_of(const std::filesystem::path& path);

/// Returns a text with its capital letters of ASCII made small.
std::string lower_case(std::string_view text);

/// Returns a number that fills the whole of a text, whatever the locale. A plus sign, a decimal
/// comma and the exponent letter D of Fortran are understood.
std::optional<double> number_of(std::string_view text);

/// Returns whether a word of a text stands for a missing height, such as "nan" or "null".
bool is_void_word(std::string_view word);

/// Throws Error{bad_data} unless a raster of this size can be read. A raster that is not `windowed`
/// is read as a whole.
void require_size(const std::filesystem::path& path, std::uint64_t width, std::uint64_t height,
                  bool windowed);

/// Sets the unit of the heights to what the user says or, without that, to what the file says.
/// Throws Error{bad_data} if the factor of the user makes no sense.
void set_unit(RasterInfo& info, const OpenOptions& options, double metres_per_unit,
              const std::string& unit);

/// Returns the place of a raster that has a distance of samples but no place on the Earth. Its
/// middle is at (0, 0). Throws Error{bad_data} if the distance makes no sense.
Georeference place_without_earth(const RasterInfo& info, const OpenOptions& options);

/// Returns whether a stored value is a void in every format: no number, infinite, or as large as
/// only the marks of voids are.
inline bool is_no_height(double stored) {
  return !(std::abs(stored) < 1e30);
}

/// Returns whether a stored value is the value that marks voids. A mark that was written as text is
/// not exactly the nearest float.
inline bool is_mark(double stored, double mark) {
  return stored == mark || static_cast<float>(stored) == static_cast<float>(mark);
}

}  // namespace aerostat::elevation

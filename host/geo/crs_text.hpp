#pragma once

#include <cstddef>
#include <string>

namespace aerostat::geo {

/// The longest text of a coordinate reference system that is read. The WKT of compound systems has
/// some 5000 characters.
inline constexpr std::size_t kLongestCrsText = 32768;

/// Returns a text from outside so short and plain that it fits into a message.
std::string shortened(const std::string& text);

/// Returns why PROJ must not see a text as a coordinate reference system, or an empty text if
/// it may. Texts that lead PROJ to files other than its own are refused: file names, URLs, names of
/// grids and lists of definitions. So are pipelines and other texts that describe no system.
std::string refusal_of_crs_text(const std::string& text);

}  // namespace aerostat::geo

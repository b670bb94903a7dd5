#pragma once

#include <string_view>

#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// The line and column of a character in a text, both counted from 1.
struct TextPlace {
  int line = 1;
  int column = 1;
};

/// Returns the line and column of the character after the first `bytes` bytes. Columns count
/// UTF-8 characters.
TextPlace place_of(std::string_view text, std::size_t bytes);

/// Returns the place that a pointer leads to in a text that parse_json has accepted. It is the
/// key of a member or the first character of an element. If that does not exist, it is the place
/// of the nearest parent that exists. Of a key that an object has twice, it is the last.
TextPlace locate(std::string_view text, const Pointer& pointer);

}  // namespace aerostat::scene::detail

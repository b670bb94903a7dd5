#pragma once

#include <string_view>

#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// A character of a text: line and column, both from 1.
struct TextPlace {
  int line = 1;
  int column = 1;
};

/// Of the character before which `bytes` bytes stand. Columns count characters of UTF-8.
TextPlace place_of(std::string_view text, std::size_t bytes);

/// Where a pointer leads in a text that parse_json has taken: the key of a member, the first
/// character of an element; of what is not there, the nearest parent that is. Of a key that is
/// there twice, the last.
TextPlace locate(std::string_view text, const Pointer& pointer);

}  // namespace aerostat::scene::detail

#pragma once

#include "asset/json_value.hpp"

namespace aerostat::asset {

/// Looks for a fault in those parts of a glTF file that are not read, such as animations and
/// cameras, and throws Error{bad_data} with its pointer if there is one. Files with something to
/// draw are not held to this: it says what may be wrong with a file without.
void check_unread(const JsonValue& root);

}  // namespace aerostat::asset

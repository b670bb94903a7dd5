#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace aerostat::scene::detail {

using OrderedJson = nlohmann::ordered_json;

/// The double whose shortest text is the shortest text of `value`: 0.35f gives 0.35. A negative
/// zero becomes zero.
double shortest(float value);

/// JSON text with two-space indent; arrays of plain values stay on one line, numbers are the
/// shortest that read back the same.
std::string print_json(const OrderedJson& value);

}  // namespace aerostat::scene::detail

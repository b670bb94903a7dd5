#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace aerostat::scene::detail {

using OrderedJson = nlohmann::ordered_json;

/// Returns the double whose shortest text is the shortest text of `value`, such as 0.35 for
/// 0.35f. A negative zero becomes zero.
double shortest(float value);

/// Returns JSON text that is indented by two spaces. Arrays of plain values stay on one line.
/// Numbers have the shortest text that reads back as the same value.
std::string print_json(const OrderedJson& value);

}  // namespace aerostat::scene::detail

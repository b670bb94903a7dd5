#pragma once

#include <string>
#include <string_view>

#include "scene/faults.hpp"
#include "scene/json_text.hpp"

/// These functions tell in words what a rule of the JSON Schema asks for.
namespace aerostat::scene::detail {

/// Returns the rule that a "$ref" into `schema` leads to. For an "anyOf", returns the alternative
/// for values of `type`, a name as Json::type_name gives it. For any other rule, returns `rule`.
/// The result is a part of `rule` or of `schema`.
const Json& resolve_rule(const Json& rule, const Json& schema, std::string_view type);

/// Returns the rule of a member or an element of a value that follows `rule`.
const Json& child_rule(const Json& rule, const std::string& token);

/// Returns what a rule asks for, such as "an integer from 1 to 32768".
std::string expected_by(const Json& rule);

/// Returns the word of `words` that `text` most likely stands for, or an empty text if none is
/// near.
std::string nearest_word(const std::string& text, const std::vector<std::string>& words);

/// Adds how `value` breaks the resolved `rule` to `faults`. For an object, tells all unknown and
/// missing keys, but nothing about the values of its members. Returns whether there was anything
/// to tell.
bool tell_by_rule(const Pointer& pointer, const Json& value, const Json& rule, Faults& faults);

}  // namespace aerostat::scene::detail

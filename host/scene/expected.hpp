#pragma once

#include <string>
#include <string_view>

#include "scene/faults.hpp"
#include "scene/json_text.hpp"

/// What a rule of the JSON Schema asks for, in words.
namespace aerostat::scene::detail {

/// The rule behind a "$ref" into `schema`, and of an "anyOf" the alternative for values of `type`,
/// a name as Json::type_name gives it. A part of `rule` or of `schema`.
const Json& resolve_rule(const Json& rule, const Json& schema, std::string_view type);

/// The rule of a member or an element.
const Json& child_rule(const Json& rule, const std::string& token);

/// Such as "an integer from 1 to 32768".
std::string expected_by(const Json& rule);

/// The word of `words` that `text` is most likely meant to be; empty if none is near.
std::string nearest_word(const std::string& text, const std::vector<std::string>& words);

/// Tells how `value` breaks `rule` (resolved): of an object all unknown and missing keys, but
/// nothing of its members. Whether there was anything to tell.
bool tell_by_rule(const Pointer& pointer, const Json& value, const Json& rule, Faults& faults);

}  // namespace aerostat::scene::detail

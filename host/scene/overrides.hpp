#pragma once

#include <string>
#include <vector>

#include "scene/faults.hpp"
#include "scene/io.hpp"
#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// Tokens of a JSON pointer (RFC 6901) that is not empty. Throws Error{usage} on bad syntax or on
/// more than kMaxDepth tokens.
Pointer parse_pointer(const std::string& text);

/// The short form "biome": "sand" as {"kind": "sand"}.
void expand_short_forms(Json& document);

/// Sets each override in turn. Missing objects on the way are created, missing arrays are taken
/// from the defaults of the document's biome and view; "-" appends to an array. Of the sun's
/// direction and angles the override replaces the other. Throws Error{bad_data} where a pointer
/// leads into a plain value or outside an array. `faults` learns what is not from the text any
/// more.
void apply_overrides(Json& document, const std::vector<Override>& overrides, Faults& faults);

/// The biome, the view and the quality that the document asks for, or the usual ones where it is
/// silent or wrong.
BiomeKind biome_of(const Json& document);
View view_of(const Json& document);
Quality quality_of(const Json& document);

}  // namespace aerostat::scene::detail

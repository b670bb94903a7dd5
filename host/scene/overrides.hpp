#pragma once

#include <string>
#include <vector>

#include "scene/faults.hpp"
#include "scene/io.hpp"
#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// Returns the tokens of a JSON pointer (RFC 6901) that is not empty. Throws Error{usage} on bad
/// syntax or on more than kMaxDepth tokens.
Pointer parse_pointer(const std::string& text);

/// Replaces the short form "biome": "sand" by "biome": {"kind": "sand"}, and that of a single file,
/// "source": "davos.tif", by a list.
void expand_short_forms(Json& document);

/// Sets each override in turn. Missing objects on the way are created. Missing arrays are taken
/// from the defaults of the document's biome and view. The token "-" appends to an array. An
/// override of one way of giving the sun's direction (vector, angles, date) removes the other
/// ways. Throws Error{bad_data} if a pointer leads into a plain value or outside an array.
/// `faults` notes which values no longer come from the text.
void apply_overrides(Json& document, const std::vector<Override>& overrides, Faults& faults);

/// Returns whether the document names files of elevation data.
bool has_source(const Json& document);

/// These functions return the biome, view and quality that the document asks for. They return the
/// defaults (snow, outside, standard) where the document gives no valid word.
BiomeKind biome_of(const Json& document);
Season season_of(const Json& document);
View view_of(const Json& document);
Mood mood_of(const Json& document);
Quality quality_of(const Json& document);

}  // namespace aerostat::scene::detail

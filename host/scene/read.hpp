#pragma once

#include <filesystem>
#include <string>

#include "scene/faults.hpp"
#include "scene/json_text.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// The bytes of a scene file, at most a little more than kMaxFileBytes. Throws Error{io}.
std::string read_bytes(const std::filesystem::path& path);

/// Text as JSON, short forms expanded. Throws Error{bad_data} if it is none; what else is wrong
/// with it is added to `faults`.
Json parse_document(const std::string& text, Faults& faults);

/// The scene that a document describes, whose numbers are normalised on the way. Throws BadScene if
/// there are faults, now or already: it is against the schema or makes no sense.
Scene read_document(Json& document, Faults& faults);

}  // namespace aerostat::scene::detail

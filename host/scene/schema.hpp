#pragma once

#include <string>
#include <vector>

#include "scene/faults.hpp"
#include "scene/json_print.hpp"
#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// Makes the JSON Schema of scenes from the tables of fields.
OrderedJson make_schema();

/// Returns the text of the JSON Schema. scenes/aerostat-scene.schema.json is a copy of it for text
/// editors.
std::string schema_text();

/// Returns the schema of scenes as a document.
const Json& schema_document();

/// Adds every place where the document breaks the schema to `faults`, and returns the pointers of
/// these places. For an unknown key, the fault names the known keys and the nearest one of them.
std::vector<Pointer> check_schema(const Json& document, Faults& faults);

}  // namespace aerostat::scene::detail

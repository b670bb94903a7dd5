#pragma once

#include <vector>

#include "scene/faults.hpp"
#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// The text of scenes/aerostat-scene.schema.json.
extern const char* const kSchemaText;

/// The same, parsed.
const Json& schema_document();

/// Tells every place where the document breaks the schema, and returns their pointers; of an
/// unknown key it names those that there are, and the nearest.
std::vector<Pointer> check_schema(const Json& document, Faults& faults);

}  // namespace aerostat::scene::detail

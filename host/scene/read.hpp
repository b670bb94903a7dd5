#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/faults.hpp"
#include "scene/json_text.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// Returns the bytes of a scene file, at most a little more than kMaxFileBytes. Throws Error{io}
/// if the file cannot be read.
std::string read_bytes(const std::filesystem::path& path);

/// Returns a text as JSON with short forms expanded. Throws Error{bad_data} if the text is not
/// JSON or is too long. All keys that an object has twice are added to `faults`.
Json parse_document(const std::string& text, Faults& faults);

/// Turns the names of files in a document, which count from `folder`, into absolute paths. An empty
/// folder is the current one, in which names stay as they are.
void name_files_from(const std::filesystem::path& folder, Json& document);

/// Makes the absolute paths of files in `folder` or below it relative to `folder`. All other paths
/// stay as they are. An empty folder is the current one.
void name_files_below(const std::filesystem::path& folder, Json& document);

/// Returns the names of files in a document that are absolute paths.
std::vector<std::string> absolute_files(Json& document);

/// Adds a fault for each name of a file in a document that is absolute or leads out of the folder
/// of the scene by "..". Links are not followed.
void require_files_below(Json& document, Faults& faults);

/// Returns the scene that a document describes, and normalises the numbers of the document.
/// Throws BadScene if `faults` is not empty, or if the document breaks the schema or makes no
/// sense.
Scene read_document(Json& document, Faults& faults);

/// Returns the values that hold where a document, which has passed the schema, gives none.
Scene usual_scene(const Json& document);

}  // namespace aerostat::scene::detail

#pragma once

#include <filesystem>

namespace aerostat::staging {

/// Throws Error{bad_data} if a file that is no elevation data of a known format does not look like
/// a scene either, and says what can be done. Files whose name ends in .json, and those that cannot
/// be read, pass.
void require_scene_text(const std::filesystem::path& file);

}  // namespace aerostat::staging

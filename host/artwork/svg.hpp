#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "artwork/picture.hpp"

namespace aerostat::artwork {

/// The id of the group with the guides in the template of the gores, which are not drawn when the
/// file is read.
inline constexpr const char* kGuidesId = "aerostat-guides";

/// Returns whether the content of a file is that of an SVG drawing.
bool is_svg(std::string_view bytes);

/// Returns the first file or address that a drawing refers to, beside its own parts and data in the
/// text, or nothing. It has at most 100 bytes.
std::optional<std::string> first_reference(std::string_view text);

/// Draws an SVG file. A child process does so that reaches neither other files nor the network, and
/// has limits of memory and time. `file` is the name for messages. Notes say what the drawing
/// refers to in vain. Throws Error{bad_data} if the drawing cannot be understood, takes too much or
/// too long, or if the program rsvg-convert is missing.
asset::Texture draw_svg(std::string_view bytes, const std::filesystem::path& file,
                        const DrawingSize& size, std::vector<std::string>& notes);

/// Decodes a PNG or JPEG picture. Throws Error{bad_data} with the name of the file.
asset::Texture decode_picture(std::string_view bytes, const std::filesystem::path& file);

}  // namespace aerostat::artwork

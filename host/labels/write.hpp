#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/math.hpp"
#include "labels/names_in_view.hpp"

namespace aerostat::labels {

/// The part of a picture that is written.
struct Part {
  dvec2 first{0.0};  // its first pixel in the whole picture
  dvec2 size{0.0};   // in pixels
};

/// Returns the picture as SVG with the names of the places that are in sight, each with a line from
/// its place. The PNG is a part of the SVG, because browsers and word processors that show an SVG
/// as an image load no other file for it.
std::string svg_text(const std::vector<NameInView>& names, const Part& part,
                     std::span<const std::uint8_t> png);

/// Returns all places as JSON: name, latitude, longitude, height, pixel x and y in the part of the
/// picture, distance_m, in_picture and hidden. x, y and the distance are null for places that lie
/// behind the camera.
std::string json_text(const std::vector<NameInView>& names, const Part& part);

}  // namespace aerostat::labels

#pragma once

#include "artwork/unrolled.hpp"
#include "asset/model.hpp"

namespace aerostat::artwork {

/// Returns a picture that was drawn on the template of the gores with each gore stretched to the
/// width of the widest place, so that neighbouring gores touch everywhere. What lies between the
/// gores of the template is left out. The size stays.
asset::Texture straightened(const asset::Texture& drawn, const Unrolled& cloth);

}  // namespace aerostat::artwork

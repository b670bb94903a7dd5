#pragma once

namespace aerostat::terrain {

/// The resolution at which water carves a relief. Coarse is for a first look and takes a sixth of
/// the time. It gives the same ranges and main valleys, but other branches of the valleys.
enum class Carving { fine, coarse };

}  // namespace aerostat::terrain

#pragma once

namespace aerostat::terrain {

/// How finely water carves a relief. Coarse takes a sixth of the time: the same ranges and main
/// valleys, whose branches are other ones. For a first look.
enum class Carving { fine, coarse };

}  // namespace aerostat::terrain

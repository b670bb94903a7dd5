#pragma once

namespace aerostat::scene {

/// The level that the y of a position counts from: the sea (absolute), the ground under it, or,
/// for cameras only, the floor of the balloon's basket.
enum class HeightReference { sea, ground, balloon };

}  // namespace aerostat::scene

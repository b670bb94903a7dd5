#pragma once

namespace aerostat::scene {

/// The axis of a file that points up.
enum class UpAxis { y, z };

}  // namespace aerostat::scene

#pragma once

#include "model/outline.hpp"

/// Sizes of a four-seat basket and its burner frame, in metres. y = 0 is the top of the floor, the
/// passengers look to -z, +x is on their right.
namespace aerostat::model {

inline constexpr double kWallBottom = -0.05;
inline constexpr double kWallTop = 1.07;
inline constexpr double kWallHalfThickness = 0.014;  // without the weave's relief
inline constexpr double kFloorThickness = 0.03;
inline constexpr double kRimHeight = 1.075;  // of the middle of the padding
inline constexpr double kFrameHeight = 2.08;
inline constexpr double kCylinderHeight = 0.80;
inline constexpr dvec2 kFrameHalf{0.40, 0.46};
inline constexpr dvec2 kCylinderPlace{0.41, 0.56};
inline constexpr dvec3 kEye{0.0, 1.62, 0.25};

/// Middle of the wall: 1.2 m by 1.5 m over all.
inline Outline wall_outline() {
  return {{0.575, 0.725}, 0.16};
}

inline const vec3 kLeather{0.088f, 0.047f, 0.028f};  // brown suede
inline const vec3 kCover{0.115f, 0.095f, 0.075f};    // taupe cloth over padding
inline const vec3 kSteel{0.42f, 0.43f, 0.45f};
inline const vec3 kBlackRubber{0.02f, 0.02f, 0.022f};

}  // namespace aerostat::model

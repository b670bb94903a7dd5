#pragma once

#include "model/outline.hpp"

/// Gives the sizes of a four-seat basket and its burner frame in metres. y = 0 is the top of the
/// floor. The passengers look to -z, and +x is on their right.
namespace aerostat::model {

inline constexpr double kWallBottom = -0.05;
inline constexpr double kWallTop = 1.07;
/// Half the thickness of the wall without the relief of the weave.
inline constexpr double kWallHalfThickness = 0.014;
inline constexpr double kFloorThickness = 0.03;
/// The height of the middle of the rim's padding.
inline constexpr double kRimHeight = 1.075;
inline constexpr double kFrameHeight = 2.08;
inline constexpr double kCylinderHeight = 0.80;
inline constexpr dvec2 kFrameHalf{0.40, 0.46};
inline constexpr dvec2 kCylinderPlace{0.41, 0.56};
inline constexpr dvec3 kEye{0.0, 1.62, 0.25};

/// Returns the outline of the middle of the wall. The wall is 1.2 m by 1.5 m over all.
inline Outline wall_outline() {
  return {{0.575, 0.725}, 0.16};
}

/// The albedo of brown suede.
inline const vec3 kLeather{0.088f, 0.047f, 0.028f};
/// The albedo of taupe cloth over padding.
inline const vec3 kCover{0.115f, 0.095f, 0.075f};
inline const vec3 kSteel{0.42f, 0.43f, 0.45f};
inline const vec3 kBlackRubber{0.02f, 0.02f, 0.022f};

}  // namespace aerostat::model

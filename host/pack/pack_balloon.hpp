#pragma once

#include "scene/scene.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Light in and about the balloon of a resolved scene that is nearest to its eye; all zero if there
/// is none. The others share the even light, not the burners'.
///
/// The envelope is taken as an integrating sphere: of what shines in through its cloth, evenly from
/// the sky and over a disc from the sun (a quarter of the surface), the cloth sends `reflected`
/// back in at every turn, so that the inner side receives transmitted / (1 - reflected) of it (R.
/// Ulbricht, "Die Bestimmung der mittleren raeumlichen Lichtintensitaet", 1900).
AeroBalloon pack_balloon(const scene::Scene& scene);

}  // namespace aerostat::pack

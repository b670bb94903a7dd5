#pragma once

#include "pack/pack_artwork.hpp"
#include "scene/resolved_scene.hpp"
#include "scene_params.h"

namespace aerostat::scene {
struct Balloon;
}

namespace aerostat::pack {

/// Returns the light in and around a balloon of a scene, with the pictures on its envelope.
///
/// The envelope is taken as an integrating sphere: of what shines in through its cloth, evenly from
/// the sky and over a disc from the sun (a quarter of the surface), the cloth sends `reflected`
/// back in at every turn, so that the inner side receives transmitted / (1 - reflected) of it (R.
/// Ulbricht, "Die Bestimmung der mittleren raeumlichen Lichtintensitaet", 1900).
AeroBalloon pack_balloon(const scene::ResolvedScene& scene, const scene::Balloon& balloon,
                         const PackedArtwork& artwork);

/// Returns the same for an envelope without pictures.
AeroBalloon pack_balloon(const scene::ResolvedScene& scene, const scene::Balloon& balloon);

}  // namespace aerostat::pack

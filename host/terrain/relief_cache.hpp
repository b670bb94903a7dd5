#pragma once

#include "core/last_made.hpp"
#include "land/cover.hpp"
#include "land/drape.hpp"
#include "scene/land.hpp"
#include "terrain/carving.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::terrain {

class Relief;

/// Keeps the relief that was made last for each carving. Placing the objects of a scene and
/// building its meshes need the same relief, and carving it takes longer than either of them. A
/// session or a command owns one. It may be used from any thread. A coarse relief can be had while
/// a fine one is made. The files of real land are kept
/// beside it, because other places of them make other reliefs.
struct ReliefCache {
  LastMade<scene::Terrain, Relief> fine, coarse;
  RealLandCache lands;
  LastMade<land::DrapeOptions, land::Drape> drapes;
  LastMade<land::CoverOptions, land::Cover> covers;

  LastMade<scene::Terrain, Relief>& of(Carving carving) {
    return carving == Carving::coarse ? coarse : fine;
  }
};

}  // namespace aerostat::terrain

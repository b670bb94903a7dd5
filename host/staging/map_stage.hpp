#pragma once

#include "staging/stage.hpp"

namespace aerostat::staging {

/// Returns a scene on real land as stage() does, but as a map where it gives no camera: seen from
/// straight above, over the whole area of the files or over /terrain/extent_m around its place.
/// What the scene gives always wins. Chosen are a picture as fine as the samples, cells as fine as
/// the samples as far as there may be so many, no added detail, no balloon and plants, an even
/// sky, and a sun in the north-west as maps have it. Unless a biome or a picture over the land is
/// given, the land has one colour and the exposure is fixed, so that neighbouring maps fit. Throws
/// Error{bad_data} if the picture would be too large, and the errors of stage().
Staged stage_map(const scene::SceneSource& source, terrain::ReliefCache& reliefs);

}  // namespace aerostat::staging

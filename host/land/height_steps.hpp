#pragma once

#include <vector>

namespace aerostat::land {

/// Returns the largest of some usual steps (a metre or foot, a decimetre...) of which all heights
/// are whole multiples, or 0 if there is none. `unit_m` is the unit of the file in metres. NaN are
/// passed over.
float step_of(const std::vector<float>& heights, float unit_m);

/// Smooths heights that were rounded to multiples of `step`, so that gentle slopes do not become
/// terraces. No height changes by more than half a step. Voids must be filled.
void smooth_steps(int width, int height, float step, std::vector<float>& heights);

}  // namespace aerostat::land

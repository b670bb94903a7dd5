#pragma once

#include <string>
#include <vector>

namespace aerostat::test {

/// Takes any text for a scene, changed by options --set, and writes and reads again what it makes
/// of them. Returns a description of a fault, or an empty string if everything was as promised.
std::string fault_of_scene(const std::string& text, const std::vector<std::string>& changes);

}  // namespace aerostat::test

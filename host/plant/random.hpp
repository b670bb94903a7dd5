#pragma once

#include "core/random.hpp"

namespace aerostat::plant {

using aerostat::Random;

}  // namespace aerostat::plant

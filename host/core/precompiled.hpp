#pragma once

// Large headers that many files of host read, compiled once. Each file includes what it uses all
// the same, because builds with a compiler cache go without.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/glm.hpp>

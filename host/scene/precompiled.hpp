#pragma once

// The headers of core and JSON, compiled once for this folder.
#include <nlohmann/json.hpp>

#include "core/precompiled.hpp"

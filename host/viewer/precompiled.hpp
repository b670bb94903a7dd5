#pragma once

// The headers of core and Qt, compiled once for this folder.
#include <QtWidgets>

#include "core/precompiled.hpp"

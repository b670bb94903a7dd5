#pragma once

// The headers of core and GoogleTest, compiled once for all tests.
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "core/precompiled.hpp"

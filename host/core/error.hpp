#pragma once

// The program has one exception type, and it is the one that users of the library catch.
#include "aerostat/error.hpp"

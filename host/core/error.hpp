#pragma once

// The program's one exception is the library's, which users of the library catch.
#include "aerostat/error.hpp"

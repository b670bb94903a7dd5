#pragma once

#include <string>

#include "opencl/program.hpp"

namespace aerostat::film {

/// Returns what tells programs apart whose pictures may differ: the version, and a checksum of the
/// host sources and of the kernels. The same sources give the same mark on every machine, whatever
/// compiler built them.
std::string program_mark(const opencl::SourceTree& kernels);

}  // namespace aerostat::film

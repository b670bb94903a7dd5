#pragma once

#include <span>
#include <string_view>

namespace aerostat::opencl {

/// A kernel file inside the binary, byte for byte as it was when the binary was built.
struct EmbeddedFile {
  std::string_view path;  // relative to the kernel folder, such as "device/core/lanes.clh"
  std::string_view text;
};

/// All of them, ordered by path. Generated: see cmake/EmbedKernels.cmake.
std::span<const EmbeddedFile> embedded_files();

}  // namespace aerostat::opencl

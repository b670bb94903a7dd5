#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "core/environment.hpp"
#include "core/error.hpp"
#include "opencl/embedded.hpp"
#include "opencl/program.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

bool is_kernel_file(const fs::path& path) {
  const auto extension = path.extension();
  return extension == ".h" || extension == ".clh" || extension == ".cl";
}

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream.is_open() || stream.bad()) {
    throw Error(ErrorKind::io, fmt::format("cannot read the kernel file {}", path.string()));
  }
  return text;
}

/// Reads all kernel files in a folder. Messages call the folder `name`.
SourceTree read_folder(const fs::path& root, const std::string& name) {
  SourceTree tree;
  try {
    for (const auto& item : fs::recursive_directory_iterator(root)) {
      if (!item.is_regular_file() || !is_kernel_file(item.path())) continue;
      tree.emplace(item.path().lexically_relative(root).generic_string(), read_text(item.path()));
    }
  } catch (const fs::filesystem_error& error) {
    throw Error(ErrorKind::io,
                fmt::format("cannot read the kernels from {}: {}", name, error.code().message()));
  }
  if (tree.empty()) {
    throw Error(ErrorKind::io, fmt::format("{} holds no kernel files (.cl, .clh, .h)", name));
  }
  return tree;
}

}  // namespace

SourceTree kernel_sources(const fs::path& folder) {
  return read_folder(folder, folder.string());
}

std::optional<fs::path> kernel_folder() {
  return environment_variable("AEROSTAT_KERNEL_DIR");
}

SourceTree kernel_sources() {
  if (const auto folder = kernel_folder()) {
    return read_folder(*folder, fmt::format("{} (AEROSTAT_KERNEL_DIR)", folder->string()));
  }
  SourceTree tree;
  for (const auto& file : embedded_files()) tree.emplace(file.path, file.text);
  return tree;
}

}  // namespace aerostat::opencl

#include "cli/render_traits.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/checksum.hpp"
#include "core/error.hpp"
#include "opencl/program.hpp"
#include "scene/io.hpp"
#include "scene/named_files.hpp"

namespace aerostat::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::streamoff kMostOfAnEnd = 1 << 20;

std::string hex(std::uint64_t number) {
  return fmt::format("{:016x}", number);
}

std::string text_of(const render::Crop& pixels) {
  return fmt::format("{},{},{},{}", pixels.x0, pixels.y0, pixels.x1, pixels.y1);
}

std::string kernels_text() {
  std::string all;
  for (const auto& [path, text] : opencl::kernel_sources()) all += path + '\0' + text + '\0';
  return hex(checksum(all));
}

/// Returns the size of a file and a checksum of its two ends.
std::string content_of_file(const fs::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  const std::streamoff first = std::min(size, kMostOfAnEnd);
  const std::streamoff last = std::min(size - first, kMostOfAnEnd);
  std::string ends(static_cast<std::size_t>(std::max<std::streamoff>(first + last, 0)), '\0');
  if (size >= 0) {
    file.seekg(0);
    file.read(ends.data(), first);
    file.seekg(size - last);
    file.read(ends.data() + first, last);
  }
  if (!file) {
    throw Error(ErrorKind::io, fmt::format("cannot read '{}': {}", path.string(),
                                           std::generic_category().message(errno)));
  }
  return fmt::format("{} {}", size, hex(checksum(ends)));
}

std::string content_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return content_of_file(path);
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator at(path, error), end; !error && at != end;
       at.increment(error)) {
    if (!at->is_regular_file(error)) continue;
    files.push_back(at->path().lexically_relative(path).string() + " " +
                    content_of_file(at->path()));
  }
  if (error) {
    throw Error(ErrorKind::io,
                fmt::format("cannot read the folder '{}': {}", path.string(), error.message()));
  }
  std::sort(files.begin(), files.end());
  std::string all;
  for (const std::string& one : files) all += one + '\n';
  return all;
}

/// Returns the checksum of the scene without what has a trait of its own. Files count by the last
/// part of their names.
std::string scene_text(scene::Scene scene) {
  for (std::string* name : scene::named_files(scene)) *name = fs::path(*name).filename().string();
  const scene::Image usual;
  scene.image.width = usual.width;
  scene.image.height = usual.height;
  scene.image.spp = usual.spp;
  scene.image.seed = usual.seed;
  scene.image.adaptive_threshold = usual.adaptive_threshold;
  scene.quality = scene::Quality::standard;
  scene.sun.soft_shadows = false;
  scene.sky.ambient_occlusion = false;
  return hex(checksum(scene::write_text(scene)));
}

std::string files_text(scene::Scene scene) {
  std::string all;
  for (const std::string* name : scene::named_files(scene)) all += content_of(*name) + '\n';
  return hex(checksum(all));
}

std::string quality_text(const scene::Scene& scene) {
  return fmt::format("{} samples, noise {}, {} shadows, {} ambient occlusion", scene.image.spp,
                     scene.image.adaptive_threshold, scene.sun.soft_shadows ? "soft" : "hard",
                     scene.sky.ambient_occlusion ? "with" : "without");
}

std::string layers_text(render::Contents contents, bool guides) {
  if (contents != render::Contents::picture) return "all layers";
  return guides ? "a picture to be denoised" : "a picture";
}

}  // namespace

render::Traits traits_of(const scene::Scene& scene, const render::Crop& part, int lanes,
                         render::Contents contents, bool guides) {
  return {
      {"version of aerostat", fmt::format("{} with kernels {}", AEROSTAT_VERSION, kernels_text())},
      {"scene", scene_text(scene)},
      {"content of the files that the scene names", files_text(scene)},
      {"size", fmt::format("{} x {}", scene.image.width, scene.image.height)},
      {"part of the picture", text_of(part)},
      {"quality", quality_text(scene)},
      {"seed", std::to_string(scene.image.seed)},
      {"width of packets (--lanes)", std::to_string(lanes)},
      {"kind of output", layers_text(contents, guides)}};
}

}  // namespace aerostat::cli

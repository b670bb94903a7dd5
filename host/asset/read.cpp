#include "asset/read.hpp"

#include <string>

#include <fmt/format.h>

#include "asset/files.hpp"
#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "core/error.hpp"

namespace aerostat::asset {
namespace {

void read_format(Reading& reading, Format format) {
  switch (format) {
    case Format::gltf:
      return read_gltf(reading);
    case Format::obj:
      return read_obj(reading);
    case Format::ply:
      return read_ply(reading);
    case Format::stl:
      return read_stl(reading);
  }
}

/// Rotates a model whose z axis points up so that its y axis does. +y becomes -z, which is north.
void turn_up(Model& model) {
  const glm::dmat4 turn({1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, -1.0, 0.0}, {0.0, 1.0, 0.0, 0.0},
                        {0.0, 0.0, 0.0, 1.0});
  model.origin = glm::dvec3(turn * glm::dvec4(model.origin, 1.0));
  for (Placement& placement : model.placements) placement.transform = turn * placement.transform;
}

}  // namespace

Model read(const std::filesystem::path& file, const ReadOptions& options) {
  const std::string bytes = bytes_of(file, options.limits.file_bytes);
  const std::optional<Format> format = format_of(bytes, file);
  if (!format) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found no model, expected a file in glTF 2.0 (.gltf or .glb), OBJ, "
                            "PLY or STL",
                            file.string()));
  }
  return read_bytes(bytes, *format, file, options);
}

Model read_bytes(std::string_view bytes, Format format, const std::filesystem::path& file,
                 const ReadOptions& options) {
  Reading reading{bytes, Files(file, options), Budget(options.limits), {}};
  try {
    read_format(reading, format);
    finish(reading.model);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", file.string(), error.what()));
  }
  if (options.up == Axis::z) turn_up(reading.model);
  return std::move(reading.model);
}

}  // namespace aerostat::asset

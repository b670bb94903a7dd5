#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "cli/options.hpp"
#include "cli/parse.hpp"
#include "core/math.hpp"
#include "image/film.hpp"
#include "labels/names_in_view.hpp"
#include "labels/places.hpp"
#include "map/map_frame.hpp"
#include "scene/resolved_scene.hpp"
#include "world/surface.hpp"

namespace aerostat::cli {

/// The files that --labels, --labels-json and --world-file write beside a picture.
class LabelFiles {
 public:
  /// Reads the places, if --labels is given. `output` is the picture. Throws Error{usage} if there
  /// is nothing to write, and the errors of labels::read_places and require_writable.
  LabelFiles(const RenderOptions& options, const std::filesystem::path& output,
             PictureFormat format);

  /// Finds the places in the picture and where it lies. Throws the errors of labels::names_in_view
  /// and map::map_frame.
  void find(const scene::ResolvedScene& scene, world::ReliefCache& reliefs);

  /// Writes the files. `bytes` are those of the picture's file.
  void write(const image::Film& film, std::span<const std::uint8_t> bytes) const;

 private:
  void name_world_files(const RenderOptions& options, const std::filesystem::path& output,
                        PictureFormat format);

  std::vector<labels::NamedPlace> places_;
  std::vector<labels::NameInView> names_;
  std::filesystem::path svg_, json_, world_, prj_;  // empty: not written
  dvec2 first_{0.0};                                // pixel of the picture's part
  map::MapFrame frame_;
};

}  // namespace aerostat::cli

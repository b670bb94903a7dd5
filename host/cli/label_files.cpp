#include "cli/label_files.hpp"

#include <string>

#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "labels/write.hpp"

namespace aerostat::cli {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace

LabelFiles::LabelFiles(const RenderOptions& options, const std::filesystem::path& output,
                       PictureFormat format) {
  if (options.world_file) name_world_files(options, output, format);
  if (options.labels.empty()) {
    if (options.labels_json.empty()) return;
    throw Error(ErrorKind::usage, "--labels-json: found no --labels, expected a file of places");
  }
  if (format == PictureFormat::png && !is_special_file(output)) {
    svg_ = std::filesystem::path(output).replace_extension(".svg");
    require_writable(svg_);
  }
  if (!options.labels_json.empty()) json_ = output_file(options.labels_json, options.input, false);
  if (svg_.empty() && json_.empty()) {
    throw Error(ErrorKind::usage,
                "--labels: the names are written beside a .png file, as .svg; give such an "
                "--output, or --labels-json");
  }
  if (is_same_file(json_, options.labels) || is_same_file(svg_, options.labels)) {
    throw Error(ErrorKind::usage,
                "--labels: the file of places would be written over; give another output");
  }
  places_ = labels::read_places(options.labels);
}

void LabelFiles::name_world_files(const RenderOptions& options, const std::filesystem::path& output,
                                  PictureFormat format) {
  if (format != PictureFormat::png || is_special_file(output)) {
    throw Error(ErrorKind::usage,
                "--world-file: it is written beside a .png file; give such an --output");
  }
  world_ = std::filesystem::path(output).replace_extension(".pgw");
  prj_ = std::filesystem::path(output).replace_extension(".prj");
  require_writable(world_);
  require_writable(prj_);
  if (options.crop) first_ = {options.crop->x0, options.crop->y0};
}

void LabelFiles::find(const scene::ResolvedScene& scene, world::ReliefCache& reliefs) {
  if (!world_.empty()) frame_ = map::map_frame(scene, first_, reliefs);
  if (!places_.empty()) names_ = labels::names_in_view(places_, scene, reliefs);
}

void LabelFiles::write(const image::Film& film, std::span<const std::uint8_t> bytes) const {
  const labels::Part part{dvec2(film.first), dvec2(film.width, film.height)};
  if (!svg_.empty()) write_text(svg_, labels::svg_text(names_, part, bytes));
  if (!json_.empty()) write_text(json_, labels::json_text(names_, part));
  if (!world_.empty()) write_text(world_, frame_.world_file);
  if (!prj_.empty()) write_text(prj_, frame_.crs);
}

}  // namespace aerostat::cli

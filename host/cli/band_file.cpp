#include "cli/band_file.hpp"

#include <cstdint>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "cli/picture.hpp"
#include "core/error.hpp"
#include "film/frame_files.hpp"
#include "film/scene_mark.hpp"
#include "image/bands.hpp"
#include "render/development.hpp"

namespace aerostat::cli {

void require_band(const RenderOptions& options, PictureFormat format) {
  if (!options.shard) return;
  if (format != PictureFormat::exr || is_standard(options.output)) {
    throw Error(
        ErrorKind::usage,
        "--shard: a band goes to an .exr file, which 'aerostat merge' joins with the others");
  }
  if (options.save_partial || options.time_limit_s > 0.0) {
    throw Error(
        ErrorKind::usage,
        "--shard: a band has all of its samples; leave out --save-partial and --time-limit, "
        "or take --checkpoint");
  }
  const char* const whole = options.denoise                ? "--denoise"
                            : options.world_file           ? "--world-file"
                            : !options.labels.empty()      ? "--labels"
                            : !options.labels_json.empty() ? "--labels-json"
                                                           : nullptr;
  if (whole != nullptr) {
    throw Error(ErrorKind::usage,
                fmt::format("--shard: {} needs the whole picture and not a band of it", whole));
  }
}

render::Crop band_crop(const film::Shard& shard, int width, int height) {
  if (shard.count > height) {
    throw Error(
        ErrorKind::usage,
        fmt::format("--shard: found {} bands, but the picture has {} rows", shard.count, height));
  }
  const auto cut = [&](int part) {
    return static_cast<int>(std::int64_t{height} * part / shard.count);
  };
  return {0, cut(shard.index - 1), width, cut(shard.index)};
}

bool is_kept_band(const std::filesystem::path& file, const scene::Scene& scene,
                  const render::Crop& band, bool is_quiet) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  const std::optional<image::Band> found = image::decode_band(film::bytes_of(file));
  const bool is_kept = found && found->mark == film::still_mark(scene) &&
                       found->film.first == glm::ivec2(band.x0, band.y0) &&
                       found->film.width == band.x1 - band.x0 &&
                       found->film.height == band.y1 - band.y0;
  if (is_kept && !is_quiet) print_stderr(fmt::format("kept {}\n", file.string()));
  return is_kept;
}

std::vector<std::uint8_t> encode_band(const image::Film& film, const scene::Scene& scene) {
  return image::encode_band(film, film::still_mark(scene),
                            render::development_of(scene.image, film));
}

}  // namespace aerostat::cli

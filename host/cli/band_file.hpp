#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "cli/options.hpp"
#include "cli/parse.hpp"
#include "image/film.hpp"
#include "scene/scene.hpp"

/// A picture in bands of rows, which 'render --shard' makes and 'merge' joins.
namespace aerostat::cli {

/// Throws Error{usage} if the options ask for a band in a way that 'merge' could not join.
void require_band(const RenderOptions& options, PictureFormat format);

/// Returns the band of a picture that a shard names. Bands are as high as each other, within a row,
/// and together they are all rows. Throws Error{usage} if there are more bands than rows.
render::Crop band_crop(const film::Shard& shard, int width, int height);

/// Returns whether a file is whole and holds this band of the scene's picture, and says so unless
/// `is_quiet`. Throws Error{io} if a file that is there cannot be read.
bool is_kept_band(const std::filesystem::path& file, const scene::Scene& scene,
                  const render::Crop& band, bool is_quiet);

/// Returns the bytes of the file of a band.
std::vector<std::uint8_t> encode_band(const image::Film& film, const scene::Scene& scene);

}  // namespace aerostat::cli

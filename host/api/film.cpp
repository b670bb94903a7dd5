#include "aerostat/film.hpp"

#include <fmt/format.h>

#include "aerostat/error.hpp"
#include "api/state.hpp"
#include "core/file.hpp"
#include "denoise/denoise.hpp"
#include "image/write.hpp"
#include "render/development.hpp"

namespace aerostat {
namespace {

static_assert(sizeof(vec3) == 3 * sizeof(float));

std::span<const float> floats_of(const Array<vec3>& vectors) {
  return {reinterpret_cast<const float*>(vectors.data()), 3 * vectors.size()};
}

}  // namespace

Film::Film() : state_(std::make_shared<State>()) {}
Film::Film(std::shared_ptr<const State> state) : state_(std::move(state)) {}

int Film::width() const {
  return state_->film.width;
}

int Film::height() const {
  return state_->film.height;
}

std::span<const float> Film::radiance() const {
  return floats_of(state_->film.radiance);
}

std::span<const float> Film::alpha() const {
  return {state_->film.alpha.data(), state_->film.alpha.size()};
}

std::span<const float> Film::distance_m() const {
  return {state_->film.distance_m.data(), state_->film.distance_m.size()};
}

std::span<const float> Film::albedo() const {
  return floats_of(state_->film.albedo);
}

std::span<const float> Film::normal() const {
  return floats_of(state_->film.normal_ws);
}

std::span<const std::uint32_t> Film::object_id() const {
  return {state_->film.object_id.data(), state_->film.object_id.size()};
}

Film Film::denoised() const {
  if (state_->film.albedo.empty() && !state_->film.radiance.empty()) {
    throw Error(
        ErrorKind::usage,
        "denoising: the film has no albedos and normals; SessionOptions::guides keeps them");
  }
  auto state = std::make_shared<State>(*state_);
  denoise::denoise(state->film);
  return Film(std::move(state));
}

std::vector<std::uint8_t> Film::to_rgb8() const {
  return image::develop(state_->film, render::development_of(state_->image, state_->film)).rgb;
}

std::vector<std::uint8_t> Film::to_png() const {
  if (!image::png_can_hold(width(), height())) {
    throw Error(ErrorKind::usage,
                fmt::format("{} x {} pixels are too many for a PNG; write an OpenEXR file", width(),
                            height()));
  }
  return image::encode_png(
      image::develop(state_->film, render::development_of(state_->image, state_->film)));
}

std::vector<std::uint8_t> Film::to_exr() const {
  return image::encode_exr(state_->film);
}

void Film::save(const std::filesystem::path& path) const {
  const std::string ending = path.extension().string();
  if (ending != ".png" && ending != ".exr") {
    throw Error(ErrorKind::usage, fmt::format("cannot write {}: a picture's name ends in .png or "
                                              ".exr, not in \"{}\"",
                                              path.string(), ending));
  }
  write_file(path, ending == ".png" ? to_png() : to_exr());
}

}  // namespace aerostat

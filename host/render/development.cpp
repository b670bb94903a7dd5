#include "render/development.hpp"

#include "image/white.hpp"

namespace aerostat::render {

image::Development development_of(const scene::Image& image, const image::Film& film) {
  image::Development development;
  development.exposure_ev = image.exposure_ev.value_or(film.metered_ev);
  development.white_balance = image.white_balance_k
                                  ? image::white_balance_for(*image.white_balance_k)
                                  : image::automatic_white_balance(dvec3(film.daylight));
  development.vignette = image.vignette;
  development.glare = image.glare;
  return development;
}

}  // namespace aerostat::render

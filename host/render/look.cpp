#include "render/look.hpp"

#include "image/white.hpp"

namespace aerostat::render {

image::Look look_of(const scene::Image& image, const image::Film& film) {
  image::Look look;
  look.exposure_ev = image.exposure_given ? image.exposure_ev : film.metered_ev;
  look.white_balance = image.white_balance_given
                           ? image::white_balance_for(image.white_balance_k)
                           : image::automatic_white_balance(dvec3(film.daylight));
  look.vignette = image.vignette;
  return look;
}

}  // namespace aerostat::render

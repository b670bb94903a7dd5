#include "render/look.hpp"

#include "image/white.hpp"

namespace aerostat::render {

image::Look look_of(const scene::Image& image, const image::Film& film,
                    const std::optional<Crop>& crop) {
  image::Look look;
  look.exposure_ev = image.exposure_given ? image.exposure_ev : image::automatic_exposure_ev(film);
  look.white_balance = image.white_balance_given
                           ? image::white_balance_for(image.white_balance_k)
                           : image::automatic_white_balance(dvec3(film.daylight));
  look.vignette = image.vignette;
  if (crop) {
    look.first = {crop->x0, crop->y0};
    look.whole = {image.width, image.height};
  }
  return look;
}

}  // namespace aerostat::render

#include "viewer/picture.hpp"

#include <cstring>

namespace aerostat::viewer {

QImage image_of(const image::Pixels& pixels) {
  QImage image(pixels.width, pixels.height, QImage::Format_RGB888);
  const std::size_t row = 3 * static_cast<std::size_t>(pixels.width);
  for (int y = 0; y < pixels.height; ++y) {
    std::memcpy(image.scanLine(y), pixels.rgb.data() + static_cast<std::size_t>(y) * row, row);
  }
  return image;
}

QImage picture_of(const render::Look& look) {
  const scene::Image& image = look.scene.image;
  const double ev =
      image.exposure_given ? image.exposure_ev : image::automatic_exposure_ev(look.film);
  return image_of(image::develop(look.film, ev));
}

}  // namespace aerostat::viewer

#include "viewer/picture.hpp"

#include <cstring>

#include "render/development.hpp"
#include "scene/scene.hpp"

namespace aerostat::viewer {

QImage image_of(const image::Pixels& pixels) {
  QImage image(pixels.width, pixels.height, QImage::Format_RGB888);
  const std::size_t row = 3 * static_cast<std::size_t>(pixels.width);
  for (int y = 0; y < pixels.height; ++y) {
    std::memcpy(image.scanLine(y), pixels.rgb.data() + static_cast<std::size_t>(y) * row, row);
  }
  return image;
}

QImage picture_of(const render::Preview& preview) {
  const scene::Image& image = preview.scene->image;
  return image_of(image::develop(preview.film, render::development_of(image, preview.film)));
}

}  // namespace aerostat::viewer

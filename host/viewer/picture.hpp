#pragma once

#include <QImage>

#include "image/write.hpp"
#include "render/progressive.hpp"

namespace aerostat::viewer {

/// Converts developed pixels to an image of Qt.
QImage image_of(const image::Pixels& pixels);

/// Develops a preview as its scene demands.
QImage picture_of(const render::Preview& preview);

}  // namespace aerostat::viewer

#pragma once

#include <QImage>

#include "image/write.hpp"
#include "render/progressive.hpp"

namespace aerostat::viewer {

/// Developed pixels as Qt's image.
QImage image_of(const image::Pixels& pixels);

/// A look, developed as its scene says.
QImage picture_of(const render::Look& look);

}  // namespace aerostat::viewer

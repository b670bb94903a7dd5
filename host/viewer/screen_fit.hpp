#pragma once

#include <QWidget>

namespace aerostat::viewer {

/// Resizes a window that is not shown yet to the size `wanted`, or to the part of it that fits the
/// screen beside desktop panels and the window's frame.
void resize_to_fit(QWidget& window, const QSize& wanted);

/// Moves a window wholly onto the screen after its geometry was restored, possibly from another
/// screen.
void move_onto_screen(QWidget& window);

}  // namespace aerostat::viewer

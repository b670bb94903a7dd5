#pragma once

#include <QWidget>

namespace aerostat::viewer {

/// Gives a window that is not shown yet the size `wanted`, or as much of it as its screen has room
/// for beside panels and the window's frame.
void resize_to_fit(QWidget& window, const QSize& wanted);

/// Brings a window whose geometry was restored from another time, and maybe another screen, onto
/// the screen as a whole.
void move_onto_screen(QWidget& window);

}  // namespace aerostat::viewer

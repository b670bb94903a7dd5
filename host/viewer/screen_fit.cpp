#include "viewer/screen_fit.hpp"

#include <QGuiApplication>
#include <QScreen>
#include <algorithm>

namespace aerostat::viewer {
namespace {

/// The sizes of the window's frame and title in pixels, which are not known before the window is
/// shown. Chosen by eye.
constexpr int kBorder = 4, kTitle = 32;

/// Returns the rectangle of the screen in which the inside of a window may be.
QRect room_for(const QWidget& window) {
  const QScreen* screen = QGuiApplication::screenAt(window.geometry().center());
  if (screen == nullptr) screen = window.screen();
  return screen->availableGeometry().adjusted(kBorder, kTitle, -kBorder, -kBorder);
}

}  // namespace

void resize_to_fit(QWidget& window, const QSize& wanted) {
  window.resize(wanted.boundedTo(room_for(window).size()));
}

void move_onto_screen(QWidget& window) {
  if (window.isMaximized() || window.isFullScreen()) return;
  const QRect room = room_for(window);
  QRect place = window.geometry();
  if (room.contains(place)) return;
  place.setSize(place.size().boundedTo(room.size()));
  place.moveLeft(std::clamp(place.left(), room.left(), room.right() + 1 - place.width()));
  place.moveTop(std::clamp(place.top(), room.top(), room.bottom() + 1 - place.height()));
  window.setGeometry(place);
}

}  // namespace aerostat::viewer

#include "viewer/picture_view.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace aerostat::viewer {
namespace {

constexpr int kFlightTick_ms = 33;
/// The turn for one press of an arrow key, as a share of the picture's height. Chosen by eye.
constexpr double kKeyTurn = 0.04;
/// The factor of the distance to the target for one notch of the wheel. Chosen by eye.
constexpr double kDollyPerNotch = 0.85;

/// The half width of the mark of a model in pixels, and the way in pixels by which the mouse may
/// move in a click. Chosen by eye.
constexpr double kMarkWidth = 14.0;
constexpr double kClickSlack = 4.0;

bool flies(int key) {
  switch (key) {
    case Qt::Key_W:
    case Qt::Key_A:
    case Qt::Key_S:
    case Qt::Key_D:
    case Qt::Key_Q:
    case Qt::Key_E:
      return true;
    default:
      return false;
  }
}

}  // namespace

PictureView::PictureView(QWidget* parent) : QAbstractScrollArea(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setFrameShape(QFrame::NoFrame);
  viewport()->setBackgroundRole(QPalette::Dark);
  viewport()->setAutoFillBackground(true);
  viewport()->setCursor(Qt::OpenHandCursor);
  setAccessibleName(tr("Picture"));
  flight_timer_.setInterval(kFlightTick_ms);
  connect(&flight_timer_, &QTimer::timeout, this, &PictureView::fly_on);
}

void PictureView::show_image(const QImage& image, const QSize& size) {
  image_ = image;
  if (size != size_) {
    size_ = size;
    update_scroll_bars();
  }
  viewport()->update();
}

void PictureView::set_fit(bool fit) {
  if (fit == fit_) return;
  fit_ = fit;
  update_scroll_bars();
  viewport()->update();
  Q_EMIT fit_changed(fit);
}

void PictureView::set_placing(bool placing) {
  if (placing == placing_) return;
  placing_ = placing;
  viewport()->setCursor(placing ? Qt::CrossCursor : Qt::OpenHandCursor);
  Q_EMIT placing_changed(placing);
}

/// Returns the size at which one pixel of the picture is one pixel of the screen, whatever the
/// scale of the desktop.
QSizeF PictureView::logical_size() const {
  return QSizeF(size_) / devicePixelRatioF();
}

QRectF PictureView::picture_rect() const {
  const QSizeF area = viewport()->size();
  QSizeF size = logical_size();
  if (size.isEmpty()) return {};
  if (fit_) size.scale(area, Qt::KeepAspectRatio);
  QPointF corner((area.width() - size.width()) / 2, (area.height() - size.height()) / 2);
  if (!fit_) {
    if (size.width() > area.width()) corner.setX(-horizontalScrollBar()->value());
    if (size.height() > area.height()) corner.setY(-verticalScrollBar()->value());
  }
  return {corner, size};
}

void PictureView::update_scroll_bars() {
  const QSize size = fit_ ? QSize(0, 0) : logical_size().toSize();
  const QSize area = viewport()->size();
  const auto set = [](QScrollBar* bar, int whole, int page) {
    bar->setPageStep(page);
    bar->setRange(0, std::max(0, whole - page));
  };
  set(horizontalScrollBar(), size.width(), area.width());
  set(verticalScrollBar(), size.height(), area.height());
}

std::optional<QPointF> PictureView::place_at(const QPointF& point) const {
  const QRectF rect = picture_rect();
  if (image_.isNull() || !rect.contains(point)) return std::nullopt;
  return QPointF((point.x() - rect.x()) / rect.width(), (point.y() - rect.y()) / rect.height());
}

void PictureView::paintEvent(QPaintEvent*) {
  if (image_.isNull()) return;
  QPainter painter(viewport());
  const QRectF rect = picture_rect();
  // The pixels of a coarse preview are interpolated. Those of a whole picture at 1:1 are shown as
  // they are.
  painter.setRenderHint(QPainter::SmoothPixmapTransform, fit_ || image_.size() != size_);
  painter.drawImage(rect, image_);
  paint_mark(painter, rect);
}

void PictureView::set_mark(const std::optional<QPointF>& place, const QString& name) {
  if (place == mark_ && name == mark_name_) return;
  mark_ = place;
  mark_name_ = name;
  viewport()->update();
}

void PictureView::paint_mark(QPainter& painter, const QRectF& picture) const {
  if (!mark_) return;
  const QPointF at =
      picture.topLeft() + QPointF(mark_->x() * picture.width(), mark_->y() * picture.height());
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF ring(at.x() - kMarkWidth, at.y() - 0.5 * kMarkWidth, 2.0 * kMarkWidth, kMarkWidth);
  const QPointF text = at + QPointF(kMarkWidth + 6.0, 5.0);
  // The dark lines below the bright ones are seen before any background.
  const std::pair<QColor, double> lines[] = {{QColor(0, 0, 0, 160), 4.0}, {Qt::white, 1.8}};
  for (const auto& [color, width] : lines) {
    painter.setPen(QPen(color, width));
    painter.drawEllipse(ring);
  }
  painter.setPen(QColor(0, 0, 0, 200));
  painter.drawText(text + QPointF(1.0, 1.0), mark_name_);
  painter.setPen(Qt::white);
  painter.drawText(text, mark_name_);
}

void PictureView::resizeEvent(QResizeEvent*) {
  update_scroll_bars();
}

void PictureView::mousePressEvent(QMouseEvent* event) {
  const bool place = placing_ || (event->modifiers() & Qt::ControlModifier) != 0;
  if (place && event->button() == Qt::LeftButton) {
    if (const auto at = place_at(event->position())) Q_EMIT placed(*at);
    return;
  }
  dragged_from_ = event->position();
  pressed_at_.reset();
  carries_ = false;
  if (event->button() == Qt::LeftButton) {
    pressed_at_ = event->position();
    const auto at = place_at(event->position());
    carries_ = at && grab_ && grab_(*at);
  }
  viewport()->setCursor(carries_ ? Qt::SizeAllCursor : Qt::ClosedHandCursor);
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
  if (!dragged_from_) return;
  // A hand that trembles does not drag.
  if (pressed_at_ && (event->position() - *pressed_at_).manhattanLength() < kClickSlack) return;
  pressed_at_.reset();
  drag(*event);
}

void PictureView::drag(const QMouseEvent& event) {
  const QPointF by = event.position() - *dragged_from_;
  dragged_from_ = event.position();
  if (event.buttons() & Qt::MiddleButton) {
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - static_cast<int>(by.x()));
    verticalScrollBar()->setValue(verticalScrollBar()->value() - static_cast<int>(by.y()));
    viewport()->update();
    return;
  }
  const double height = std::max(1.0, picture_rect().height());
  if (carries_) {
    if ((event.modifiers() & Qt::ShiftModifier) != 0) {
      Q_EMIT turned(by.x() / height);
    } else if (const auto at = place_at(event.position())) {
      Q_EMIT carried(*at);
    }
    return;
  }
  const bool looks =
      (event.buttons() & Qt::RightButton) != 0 || (event.modifiers() & Qt::ShiftModifier) != 0;
  if (looks) {
    Q_EMIT looked(by.x() / height, by.y() / height);
  } else {
    Q_EMIT orbited(by.x() / height, by.y() / height);
  }
}

void PictureView::mouseReleaseEvent(QMouseEvent*) {
  if (!dragged_from_) return;
  dragged_from_.reset();
  carries_ = false;
  if (pressed_at_) {
    if (const auto at = place_at(*pressed_at_)) Q_EMIT clicked(*at);
    pressed_at_.reset();
  }
  viewport()->setCursor(placing_ ? Qt::CrossCursor : Qt::OpenHandCursor);
  Q_EMIT gesture_ended();
}

void PictureView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const auto at = place_at(event->position())) Q_EMIT aimed(*at);
}

void PictureView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches != 0.0) Q_EMIT dollied(std::pow(kDollyPerNotch, notches));
  event->accept();
}

bool PictureView::turn_by_key(int key, Qt::KeyboardModifiers modifiers) {
  double right = 0.0, down = 0.0;
  switch (key) {
    case Qt::Key_Left:
      right = kKeyTurn;
      break;
    case Qt::Key_Right:
      right = -kKeyTurn;
      break;
    case Qt::Key_Up:
      down = kKeyTurn;
      break;
    case Qt::Key_Down:
      down = -kKeyTurn;
      break;
    case Qt::Key_PageUp:
      Q_EMIT dollied(kDollyPerNotch);
      return true;
    case Qt::Key_PageDown:
      Q_EMIT dollied(1.0 / kDollyPerNotch);
      return true;
    default:
      return false;
  }
  if ((modifiers & Qt::ShiftModifier) != 0) {
    Q_EMIT looked(right, down);
  } else {
    Q_EMIT orbited(right, down);
  }
  return true;
}

void PictureView::keyPressEvent(QKeyEvent* event) {
  fast_ = (event->modifiers() & Qt::ShiftModifier) != 0;
  const bool plain = (event->modifiers() & ~Qt::ShiftModifier) == 0;
  if (plain && flies(event->key())) {
    held_.insert(event->key());
    if (!flight_timer_.isActive()) {
      since_flight_.start();
      flight_timer_.start();
    }
    return;
  }
  if (event->key() == Qt::Key_Escape && placing_) {
    set_placing(false);
  } else if (event->key() == Qt::Key_Escape && mark_) {
    Q_EMIT mark_dropped();
  } else if (event->key() == Qt::Key_Delete && plain) {
    Q_EMIT removal_asked();
  } else if (!turn_by_key(event->key(), event->modifiers())) {
    QAbstractScrollArea::keyPressEvent(event);
  }
}

void PictureView::keyReleaseEvent(QKeyEvent* event) {
  fast_ = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (event->isAutoRepeat() || held_.erase(event->key()) == 0) return;
  if (held_.empty()) {
    flight_timer_.stop();
    Q_EMIT gesture_ended();
  }
}

void PictureView::focusOutEvent(QFocusEvent* event) {
  held_.clear();
  flight_timer_.stop();
  QAbstractScrollArea::focusOutEvent(event);
}

Flight PictureView::held_flight() const {
  const auto held = [this](int key) { return held_.contains(key) ? 1.0 : 0.0; };
  return {held(Qt::Key_W) - held(Qt::Key_S), held(Qt::Key_D) - held(Qt::Key_A),
          held(Qt::Key_E) - held(Qt::Key_Q)};
}

void PictureView::fly_on() {
  const double seconds = static_cast<double>(since_flight_.restart()) * 1e-3;
  const Flight flight = held_flight();
  if (!flight.is_still()) Q_EMIT flown(flight, std::min(seconds, 0.2), fast_);
}

}  // namespace aerostat::viewer

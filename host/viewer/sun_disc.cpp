#include "viewer/sun_disc.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>

namespace aerostat::viewer {
namespace {

/// The margin for the letters and for a sun that has set, in pixels. Chosen by eye.
constexpr double kMargin = 14.0;
constexpr double kDeepest_deg = -10.0;

}  // namespace

SunDisc::SunDisc(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setSizePolicy(policy);
  setAccessibleName(tr("Sun"));
  setToolTip(
      tr("Drag the sun: the rim is the horizon, the middle the zenith, north is up. "
         "Double-click for the default."));
}

void SunDisc::show_sun(double azimuth_deg, double elevation_deg) {
  azimuth_deg_ = azimuth_deg;
  elevation_deg_ = elevation_deg;
  update();
}

void SunDisc::show_view(double azimuth_deg, double width_deg) {
  view_deg_ = azimuth_deg;
  view_width_deg_ = width_deg;
  update();
}

double SunDisc::radius() const {
  return std::max(10.0, std::min(width(), height()) / 2.0 - kMargin);
}

QPointF SunDisc::point_of(double azimuth_deg, double elevation_deg) const {
  const double away = radius() * (90.0 - std::max(elevation_deg, kDeepest_deg)) / 90.0;
  const double angle = qDegreesToRadians(azimuth_deg);
  return QPointF(width() / 2.0 + away * std::sin(angle), height() / 2.0 - away * std::cos(angle));
}

void SunDisc::angles_at(const QPointF& point, double& azimuth_deg, double& elevation_deg) const {
  const double right = point.x() - width() / 2.0, up = height() / 2.0 - point.y();
  azimuth_deg = std::round(qRadiansToDegrees(std::atan2(right, up)) * 10.0) / 10.0;
  const double elevation = 90.0 * (1.0 - std::hypot(right, up) / radius());
  elevation_deg = std::round(std::max(elevation, kDeepest_deg) * 10.0) / 10.0;
}

void SunDisc::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF middle(width() / 2.0, height() / 2.0);
  const double r = radius();
  const QColor line = palette().color(QPalette::Mid);
  QRadialGradient sky(middle, r);
  const QColor base = palette().color(QPalette::Base);
  const bool dark = base.lightness() < 128;
  sky.setColorAt(0.0, dark ? QColor(36, 62, 98) : QColor(150, 190, 232));
  sky.setColorAt(1.0, dark ? QColor(66, 78, 96) : QColor(222, 232, 242));
  painter.setBrush(sky);
  painter.setPen(
      QPen(hasFocus() ? palette().color(QPalette::Highlight) : line, hasFocus() ? 2 : 1));
  painter.drawEllipse(middle, r, r);
  if (view_width_deg_ > 0.0) {
    QColor wedge = palette().color(QPalette::Text);
    wedge.setAlpha(40);
    painter.setPen(Qt::NoPen);
    painter.setBrush(wedge);
    const double from = 90.0 - view_deg_ - view_width_deg_ / 2.0;
    painter.drawPie(QRectF(middle.x() - r, middle.y() - r, 2 * r, 2 * r),
                    static_cast<int>(from * 16), static_cast<int>(view_width_deg_ * 16));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(line, 1, Qt::DotLine));
  for (const double elevation : {30.0, 60.0}) {
    painter.drawEllipse(middle, r * (90.0 - elevation) / 90.0, r * (90.0 - elevation) / 90.0);
  }
  painter.setPen(palette().color(QPalette::WindowText));
  const QString names[] = {tr("N", "north"), tr("E", "east"), tr("S", "south"), tr("W", "west")};
  for (int i = 0; i < 4; ++i) {
    const QPointF at = middle + (point_of(90.0 * i, 0.0) - middle) * ((r + 8.0) / r);
    painter.drawText(QRectF(at.x() - 10, at.y() - 10, 20, 20), Qt::AlignCenter, names[i]);
  }
  const QPointF sun = point_of(azimuth_deg_, elevation_deg_);
  painter.setPen(QPen(QColor(150, 90, 0), 1));
  painter.setBrush(elevation_deg_ < 0.0 ? QColor(150, 80, 50) : QColor(255, 205, 60));
  painter.drawEllipse(sun, 7.0, 7.0);
}

void SunDisc::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) mouseMoveEvent(event);
}

void SunDisc::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0) return;
  double azimuth = 0.0, elevation = 0.0;
  angles_at(event->position(), azimuth, elevation);
  Q_EMIT dragged(azimuth, elevation);
}

void SunDisc::mouseReleaseEvent(QMouseEvent*) {
  Q_EMIT released();
}

void SunDisc::mouseDoubleClickEvent(QMouseEvent*) {
  Q_EMIT reset_asked();
}

void SunDisc::keyPressEvent(QKeyEvent* event) {
  double azimuth = azimuth_deg_, elevation = elevation_deg_;
  const double step = (event->modifiers() & Qt::ShiftModifier) != 0 ? 10.0 : 1.0;
  switch (event->key()) {
    case Qt::Key_Left:
      azimuth -= step;
      break;
    case Qt::Key_Right:
      azimuth += step;
      break;
    case Qt::Key_Up:
      elevation += step;
      break;
    case Qt::Key_Down:
      elevation -= step;
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  azimuth = std::remainder(azimuth, 360.0);
  Q_EMIT dragged(azimuth, std::clamp(elevation, kDeepest_deg, 90.0));
}

}  // namespace aerostat::viewer

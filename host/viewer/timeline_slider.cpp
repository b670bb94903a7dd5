#include "viewer/timeline_slider.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QStyleOptionSlider>
#include <algorithm>
#include <cmath>
#include <utility>

namespace aerostat::viewer {
namespace {

/// The height of the row of marks below the slider, and half of a mark's width, in points.
constexpr int kMarks = 10;
constexpr double kHalfMark = 4.0;

}  // namespace

TimelineSlider::TimelineSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(1, 1);
  setPageStep(25);
  setContentsMargins(0, 0, 0, kMarks);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TimelineSlider::show_marks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  // The chosen ones are drawn over the others.
  std::stable_sort(marks_.begin(), marks_.end(),
                   [](const Mark& a, const Mark& b) { return a.is_chosen < b.is_chosen; });
  update();
}

QSize TimelineSlider::sizeHint() const {
  return QSlider::sizeHint() + QSize(0, 2 * kMarks);
}

double TimelineSlider::half_handle() const {
  return 0.5 * style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
}

double TimelineSlider::x_of(double frame) const {
  const double share = (frame - minimum()) / std::max(1, maximum() - minimum());
  return half_handle() + share * (width() - 2.0 * half_handle());
}

int TimelineSlider::frame_at(double x) const {
  const double share = (x - half_handle()) / std::max(1.0, width() - 2.0 * half_handle());
  return static_cast<int>(std::lround(minimum() + share * (maximum() - minimum())));
}

void TimelineSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Mark& mark : marks_) {
    const QPointF at(x_of(std::clamp(mark.frame, double(minimum()), double(maximum()))),
                     height() - kHalfMark - 1.0);
    const QPolygonF diamond{at + QPointF(0, -kHalfMark), at + QPointF(kHalfMark, 0),
                            at + QPointF(0, kHalfMark), at + QPointF(-kHalfMark, 0)};
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(mark.is_chosen ? palette().highlight() : QBrush(Qt::NoBrush));
    painter.drawPolygon(diamond);
  }
}

void TimelineSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    QSlider::mousePressEvent(event);
    return;
  }
  setSliderPosition(frame_at(event->position().x()));
  event->accept();
}

void TimelineSlider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) setSliderPosition(frame_at(event->position().x()));
}

}  // namespace aerostat::viewer

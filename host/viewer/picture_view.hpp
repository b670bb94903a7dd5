#pragma once

#include <QAbstractScrollArea>
#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "viewer/camera_motion.hpp"

namespace aerostat::viewer {

/// Shows the picture, either whole or with one of its pixels on one pixel of the screen. Reports
/// how mouse and keys move the camera.
class PictureView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  explicit PictureView(QWidget* parent = nullptr);

  /// Shows an image. `size` is the size of the whole picture, and the image may be coarser.
  void show_image(const QImage& image, const QSize& size);
  const QImage& image() const { return image_; }

  bool is_fit() const { return fit_; }
  void set_fit(bool fit);

  /// Sets whether the next click places the balloon. The mode stays until it is set again.
  void set_placing(bool placing);
  bool is_placing() const { return placing_; }

  /// Sets what tells whether a drag that begins at a place of the picture moves what is there,
  /// instead of the camera.
  void set_grab(std::function<bool(const QPointF& place)> grab) { grab_ = std::move(grab); }

  /// Draws a mark with a name at a place of the picture, or none.
  void set_mark(const std::optional<QPointF>& place, const QString& name);

  /// Returns the place of a point of the viewport in the picture, with both coordinates from 0 to
  /// 1. Returns nothing for a point outside the picture.
  std::optional<QPointF> place_at(const QPointF& point) const;

  QSize sizeHint() const override { return {960, 600}; }

 Q_SIGNALS:
  /// Reports that the mouse was dragged, in shares of the picture's height.
  void orbited(double right, double down);
  void looked(double right, double down);
  /// Reports that the distance to the target is to be multiplied by `factor`.
  void dollied(double factor);
  /// Reports that keys of a flight are held. `seconds` is the time since the last report.
  void flown(const Flight& flight, double seconds, bool fast);
  void gesture_ended();
  /// Reports a click at a place of the picture, with both coordinates from 0 to 1.
  void aimed(const QPointF& place);
  void placed(const QPointF& place);
  /// Reports a press and a release of the mouse without a drag.
  void clicked(const QPointF& place);
  /// Reports that what was grabbed was dragged to a place of the picture, or turned to the right by
  /// a share of the picture's height.
  void carried(const QPointF& place);
  void turned(double right);
  /// Reports the keys that remove what is marked and that take the mark away.
  void removal_asked();
  void mark_dropped();
  void placing_changed(bool placing);
  void fit_changed(bool fit);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QRectF picture_rect() const;
  QSizeF logical_size() const;
  void update_scroll_bars();
  Flight held_flight() const;
  void fly_on();
  bool turn_by_key(int key, Qt::KeyboardModifiers modifiers);

  void drag(const QMouseEvent& event);
  void paint_mark(class QPainter& painter, const QRectF& picture) const;

  QImage image_;
  QSize size_;
  bool fit_ = true;
  bool placing_ = false;
  std::optional<QPointF> dragged_from_;
  /// The point at which the left button was pressed, until the mouse moves away from it.
  std::optional<QPointF> pressed_at_;
  std::function<bool(const QPointF&)> grab_;
  bool carries_ = false;
  std::optional<QPointF> mark_;
  QString mark_name_;
  std::set<int> held_;
  bool fast_ = false;
  QTimer flight_timer_;
  QElapsedTimer since_flight_;
};

}  // namespace aerostat::viewer

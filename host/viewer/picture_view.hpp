#pragma once

#include <QAbstractScrollArea>
#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <optional>
#include <set>

#include "viewer/camera_motion.hpp"

namespace aerostat::viewer {

/// Shows the picture, whole or one of its pixels on one of the screen, and tells what mouse and
/// keys ask of the camera.
class PictureView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  explicit PictureView(QWidget* parent = nullptr);

  /// `size` is that of the whole picture; the image may be coarser.
  void show_image(const QImage& image, const QSize& size);
  const QImage& image() const { return image_; }

  bool is_fit() const { return fit_; }
  void set_fit(bool fit);

  /// The next click places the balloon, until told otherwise.
  void set_placing(bool placing);
  bool is_placing() const { return placing_; }

  /// The place of a point of the viewport in the picture, both 0 to 1; nothing outside it.
  std::optional<QPointF> place_at(const QPointF& point) const;

  QSize sizeHint() const override { return {960, 600}; }

 Q_SIGNALS:
  /// The mouse was dragged by shares of the picture's height.
  void orbited(double right, double down);
  void looked(double right, double down);
  /// The distance to the target is to become so many times what it is.
  void dollied(double factor);
  /// Keys are held that fly, and for so long since the last call.
  void flown(const Flight& flight, double seconds, bool fast);
  void gesture_ended();
  /// At shares of the picture.
  void aimed(const QPointF& place);
  void placed(const QPointF& place);
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

  QImage image_;
  QSize size_;
  bool fit_ = true;
  bool placing_ = false;
  std::optional<QPointF> dragged_from_;
  std::set<int> held_;
  bool fast_ = false;
  QTimer flight_timer_;
  QElapsedTimer since_flight_;
};

}  // namespace aerostat::viewer

#pragma once

#include <QWidget>

namespace aerostat::viewer {

/// The sky as a disc. North is up as on a map, the horizon is at the rim and the zenith in the
/// middle. The sun is moved by the mouse or the arrow keys. Below the horizon it lies outside the
/// rim.
class SunDisc : public QWidget {
  Q_OBJECT

 public:
  explicit SunDisc(QWidget* parent = nullptr);

  /// Shows the sun at two angles in degrees. Azimuth 0 is north, and 90 is east.
  void show_sun(double azimuth_deg, double elevation_deg);
  /// Shows the direction of the camera as a wedge. Both angles are in degrees.
  void show_view(double azimuth_deg, double width_deg);

  /// Returns the point at which a sun is drawn. Together with `angles_at`, which is the inverse, it
  /// is public for the tests.
  QPointF point_of(double azimuth_deg, double elevation_deg) const;
  void angles_at(const QPointF& point, double& azimuth_deg, double& elevation_deg) const;

  QSize sizeHint() const override { return {150, 150}; }
  QSize minimumSizeHint() const override { return {110, 110}; }

 Q_SIGNALS:
  void dragged(double azimuth_deg, double elevation_deg);
  void released();
  void reset_asked();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double radius() const;

  double azimuth_deg_ = 0.0, elevation_deg_ = 45.0;
  double view_deg_ = 0.0, view_width_deg_ = 0.0;
};

}  // namespace aerostat::viewer

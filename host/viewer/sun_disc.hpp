#pragma once

#include <QWidget>

namespace aerostat::viewer {

/// The sky as a disc, seen from below as on a map: north up, the horizon at the rim, the zenith in
/// the middle. The sun is dragged, or moved by the arrow keys; below the horizon it lies outside
/// the rim.
class SunDisc : public QWidget {
  Q_OBJECT

 public:
  explicit SunDisc(QWidget* parent = nullptr);

  /// Degrees; azimuth 0 is north, 90 east.
  void show_sun(double azimuth_deg, double elevation_deg);
  /// Where the camera looks, drawn as a wedge.
  void show_view(double azimuth_deg, double width_deg);

  /// Where a sun is drawn, and what a point means; for the tests too.
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

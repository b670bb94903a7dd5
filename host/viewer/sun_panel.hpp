#pragma once

#include <QWidget>

#include "viewer/document.hpp"

class QCheckBox;
class QDateEdit;
class QDoubleSpinBox;
class QTimeEdit;

namespace aerostat::viewer {

class SunDisc;

/// A panel that sets the sun on a disc of the sky, by its two angles, or by date, time and place.
class SunPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SunPanel(Document& document, QWidget* parent = nullptr);

  SunDisc& disc() { return *disc_; }
  /// Sets the angles of the sun as the disc does.
  void set_angles(double azimuth_deg, double elevation_deg);
  /// Sets the date, time and place that the editors show.
  void set_date();
  void reset();

 private:
  void build();
  void refresh();
  void show_date(bool dated);
  bool is_dated() const;

  Document& document_;
  SunDisc* disc_;
  QDoubleSpinBox* azimuth_;
  QDoubleSpinBox* elevation_;
  QCheckBox* by_date_;
  QWidget* date_box_;
  QDateEdit* date_;
  QTimeEdit* time_;
  QDoubleSpinBox* offset_;
  QDoubleSpinBox* latitude_;
  QDoubleSpinBox* longitude_;
  bool showing_ = false;
};

}  // namespace aerostat::viewer

#pragma once

#include <QWidget>

#include "viewer/document.hpp"

class QCheckBox;
class QDateEdit;
class QDoubleSpinBox;
class QTimeEdit;

namespace aerostat::viewer {

class SunDisc;

/// The sun: dragged on a disc of the sky, by its two angles, or by date, time and place.
class SunPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SunPanel(Document& document, QWidget* parent = nullptr);

  SunDisc& disc() { return *disc_; }
  /// Puts the sun there, as the disc does.
  void set_angles(double azimuth_deg, double elevation_deg);
  /// Puts it where it stood, by what the editors of date and place say.
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

#pragma once

#include <QWidget>
#include <array>

class QDoubleSpinBox;

namespace aerostat::viewer {

/// Three numbers side by side: a place, a direction, or an amount of red, green and blue.
class TripleEditor : public QWidget {
  Q_OBJECT

 public:
  TripleEditor(double least, double most, int decimals, QWidget* parent = nullptr);

  /// [x, y, z] as JSON; empty where there is none, which the first edit makes of zeros.
  void show_values(const QString& json);

 Q_SIGNALS:
  void edited(const QString& json);

 private:
  void tell();

  std::array<QDoubleSpinBox*, 3> boxes_;
};

}  // namespace aerostat::viewer

#pragma once

#include <QWidget>
#include <array>

class QDoubleSpinBox;

namespace aerostat::viewer {

/// An editor of three numbers side by side. They are a place, a direction, or amounts of red, green
/// and blue.
class TripleEditor : public QWidget {
  Q_OBJECT

 public:
  TripleEditor(double least, double most, int decimals, QWidget* parent = nullptr);

  /// Shows [x, y, z] given as JSON. An empty text shows no value, and the first edit then starts
  /// from zeros.
  void show_values(const QString& json);

 Q_SIGNALS:
  void edited(const QString& json);

 private:
  void tell();

  std::array<QDoubleSpinBox*, 3> boxes_;
};

}  // namespace aerostat::viewer

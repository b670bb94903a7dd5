#pragma once

#include <QString>
#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace aerostat::viewer {

/// A number as a slider over its usual range and a box for its whole one.
class NumberEditor : public QWidget {
  Q_OBJECT

 public:
  struct Range {
    double least, most;  // that can be typed
    double from, to;     // of the slider
    int decimals;
    bool logarithmic;
    QString unit;
    QString none = {};  // shown instead of the least value
  };
  explicit NumberEditor(const Range& range, QWidget* parent = nullptr);

  double value() const;
  void show_value(double value);
  /// There is no value; one comes with the first edit.
  void show_automatic();

 Q_SIGNALS:
  void edited(double value);
  /// The slider was let go.
  void finished();

 private:
  double value_at(int position) const;
  int position_of(double value) const;

  Range range_;
  QSlider* slider_;
  QDoubleSpinBox* box_;
};

}  // namespace aerostat::viewer

#pragma once

#include <QString>
#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace aerostat::viewer {

/// An editor of a number with a slider over its usual range and a box over its whole range.
class NumberEditor : public QWidget {
  Q_OBJECT

 public:
  struct Range {
    /// The range of the box.
    double least, most;
    /// The range of the slider.
    double from, to;
    int decimals;
    bool logarithmic;
    QString unit;
    /// The text that is shown instead of the least value.
    QString none = {};
  };
  explicit NumberEditor(const Range& range, QWidget* parent = nullptr);

  double value() const;
  void show_value(double value);
  /// Shows that there is no value yet. The first edit sets one.
  void show_automatic();

 Q_SIGNALS:
  void edited(double value);
  /// Reports that the slider was released.
  void finished();

 private:
  double value_at(int position) const;
  int position_of(double value) const;

  Range range_;
  QSlider* slider_;
  QDoubleSpinBox* box_;
};

}  // namespace aerostat::viewer

#pragma once

#include <QDoubleSpinBox>

namespace aerostat::viewer {

/// A number box that shows no more digits than its value has.
class NumberBox : public QDoubleSpinBox {
 public:
  QString textFromValue(double value) const override {
    QString text = locale().toString(value, 'f', decimals());
    const QString point = locale().decimalPoint();
    if (!text.contains(point)) return text;
    while (text.endsWith(locale().zeroDigit())) text.chop(1);
    if (text.endsWith(point)) text.chop(point.size());
    return text;
  }
};

}  // namespace aerostat::viewer

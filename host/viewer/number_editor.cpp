#include "viewer/number_editor.hpp"

#include <QHBoxLayout>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "viewer/number_box.hpp"

namespace aerostat::viewer {
namespace {

constexpr int kSteps = 1000;

/// Rounds `value` to a multiple of the highest power of ten that is at most `step`, so that a
/// slider gives round numbers.
double rounded_to(double value, double step) {
  if (step <= 0.0) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(step)));
  return std::round(value / unit) * unit;
}

}  // namespace

NumberEditor::NumberEditor(const Range& range, QWidget* parent)
    : QWidget(parent), range_(range), slider_(new QSlider(Qt::Horizontal)), box_(new NumberBox) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(slider_, 1);
  layout->addWidget(box_);
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 10);
  slider_->setSingleStep(kSteps / 100);
  slider_->setMinimumWidth(60);
  box_->setDecimals(range.decimals);
  box_->setRange(range.least, range.most);
  box_->setAccelerated(true);
  box_->setStepType(range.decimals == 0 || range.logarithmic
                        ? QAbstractSpinBox::AdaptiveDecimalStepType
                        : QAbstractSpinBox::DefaultStepType);
  if (range.decimals > 0) box_->setSingleStep(std::pow(10.0, -range.decimals) * 5.0);
  if (!range.unit.isEmpty()) box_->setSuffix(" " + range.unit);
  setFocusProxy(box_);
  // All boxes have the same width, so that the ends of the sliders are aligned.
  box_->setFixedWidth(box_->fontMetrics().horizontalAdvance(QStringLiteral("-000,000.0 px")) + 32);
  connect(box_, &QDoubleSpinBox::valueChanged, this, &NumberEditor::edited);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { Q_EMIT edited(value_at(position)); });
  connect(slider_, &QSlider::sliderReleased, this, &NumberEditor::finished);
}

double NumberEditor::value() const {
  return box_->value();
}

void NumberEditor::show_value(double value) {
  // A value outside the range widens the range, so that the value keeps its digits.
  box_->setRange(std::min(range_.least, value), std::max(range_.most, value));
  box_->setSpecialValueText(range_.none);
  box_->setValue(value);
  if (position_of(value) != slider_->value()) slider_->setValue(position_of(value));
}

void NumberEditor::show_automatic() {
  box_->setSpecialValueText(tr("automatic"));
  box_->setValue(box_->minimum());
  slider_->setValue(position_of(0.0));
}

double NumberEditor::value_at(int position) const {
  const double share = static_cast<double>(position) / kSteps;
  const double value = range_.logarithmic ? range_.from * std::pow(range_.to / range_.from, share)
                                          : range_.from + (range_.to - range_.from) * share;
  const double step = range_.logarithmic ? value * std::log(range_.to / range_.from) / kSteps
                                         : (range_.to - range_.from) / kSteps;
  const double finest = std::pow(10.0, -range_.decimals);
  const double near = rounded_to(value, std::max(step, finest));
  return std::clamp(near, range_.least, range_.most);
}

int NumberEditor::position_of(double value) const {
  const double inside = std::clamp(value, range_.from, range_.to);
  const double share = range_.logarithmic
                           ? std::log(inside / range_.from) / std::log(range_.to / range_.from)
                           : (inside - range_.from) / (range_.to - range_.from);
  return static_cast<int>(std::lround(share * kSteps));
}

}  // namespace aerostat::viewer

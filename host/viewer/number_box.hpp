#pragma once

#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolTip>
#include <type_traits>
#include <utility>

#include "viewer/number_text.hpp"

namespace aerostat::viewer {

/// Returns a text that says which numbers a box expects and which value it keeps until it gets one.
QString expected_text(const QString& least, const QString& most, const QString& kept,
                      NumberKind kind);

/// A spin box that reads numbers as read_number() does, in every locale. It shows them without
/// groups, as the locale writes them. A text that it cannot read stays in the box with a red frame,
/// and the value does not change.
template <typename Box>
class ReadingBox : public Box {
 public:
  using Value = decltype(std::declval<Box>().value());

  ReadingBox() {
    this->setKeyboardTracking(false);
    // The frame is redrawn whenever the text changes.
    QObject::connect(this->lineEdit(), &QLineEdit::textChanged, this, [this] { this->update(); });
  }

  /// Returns whether the text in the box is a number that the box accepts.
  bool is_readable() const { return number_in(this->text()).has_value(); }

  /// Returns the message for a user who typed a text that the box does not accept.
  QString expected() const {
    return expected_text(this->textFromValue(this->minimum()), this->textFromValue(this->maximum()),
                         this->textFromValue(this->value()), kind());
  }

 protected:
  QValidator::State validate(QString& text, int&) const override {
    return number_in(text) ? QValidator::Acceptable : QValidator::Intermediate;
  }

  Value valueFromText(const QString& text) const override {
    return number_in(text).value_or(this->value());
  }

  /// Notes the refused text. Qt calls it when a text should become the value and cannot.
  void fixup(QString& text) const override { refused_ = text; }

  bool event(QEvent* event) override {
    if (event->type() == QEvent::ToolTip && !is_readable()) {
      tell(static_cast<QHelpEvent*>(event)->globalPos());
      return true;
    }
    // Events nest: while Box sets another text, input methods ask for it.
    const QString outer = std::exchange(refused_, {});
    const bool taken = Box::event(event);
    const QString refused = std::exchange(refused_, outer);
    if (!refused.isEmpty()) show_refused(refused);
    return taken;
  }

  void paintEvent(QPaintEvent* event) override {
    Box::paintEvent(event);
    if (is_readable()) return;
    QPainter painter(this);
    painter.setPen(QPen(QColor(0xd3, 0x2f, 0x2f), 2));
    painter.drawRect(this->rect().adjusted(1, 1, -1, -1));
  }

 private:
  NumberKind kind() const {
    if constexpr (std::is_integral_v<Value>)
      return NumberKind::whole;
    else
      return this->decimals() > 0 ? NumberKind::decimal : NumberKind::whole;
  }

  std::optional<Value> number_in(QString text) const {
    const QString special = this->specialValueText();
    if (!special.isEmpty() && text == special) return this->minimum();
    if (text.startsWith(this->prefix())) text.remove(0, this->prefix().size());
    // If a unit was typed differently, the box appends its own unit to it.
    for (const QString& unit : {this->suffix(), this->suffix().trimmed()}) {
      if (text.endsWith(unit)) text.chop(unit.size());
    }
    const auto number = read_number(text, kind());
    if (!number || *number < this->minimum() || *number > this->maximum()) return {};
    return rounded(*number);
  }

  /// Returns the number with the decimals that the box shows.
  Value rounded(double number) const {
    if constexpr (std::is_integral_v<Value>)
      return static_cast<Value>(number);
    else
      return QString::number(number, 'f', this->decimals()).toDouble();
  }

  /// Shows the refused text again, because Box has replaced it with the old value.
  void show_refused(const QString& text) {
    const QSignalBlocker blocker(this->lineEdit());
    this->lineEdit()->setText(text);
    this->update();
    if (this->hasFocus()) tell(this->mapToGlobal(this->rect().bottomLeft()));
  }

  void tell(const QPoint& place) { QToolTip::showText(place, expected(), this); }

  mutable QString refused_;
};

/// A box for whole numbers.
using WholeBox = ReadingBox<QSpinBox>;

/// A box for numbers with decimals, and for whole numbers beyond an int. It shows no more digits
/// than its value has.
class NumberBox : public ReadingBox<QDoubleSpinBox> {
 public:
  QString textFromValue(double value) const override {
    QString text = QDoubleSpinBox::textFromValue(value);
    const QString point = locale().decimalPoint();
    if (!text.contains(point)) return text;
    while (text.endsWith(locale().zeroDigit())) text.chop(1);
    if (text.endsWith(point)) text.chop(point.size());
    return text;
  }
};

}  // namespace aerostat::viewer

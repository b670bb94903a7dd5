#pragma once

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <utility>

#include "viewer/number_text.hpp"

namespace aerostat::viewer {

/// A QDateEdit or QTimeEdit that shows the digits of scene files in every locale and accepts digits
/// of any script.
template <typename Edit>
class IsoEdit : public Edit {
 public:
  template <typename Value>
  explicit IsoEdit(const Value& value) : Edit(value) {
    this->setLocale(QLocale::c());
    // Without keyboard tracking, a year becomes the value only when its last digit is typed.
    this->setKeyboardTracking(false);
  }

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    const QString selected = this->lineEdit()->selectedText();
    // Text that is typed over the whole value begins with its first part, not with the part that
    // was used last.
    if (selected == this->text()) this->setSelectedSection(this->sectionAt(0));
    // Edit moves to the next part by itself once a part is full. If the mark between the parts is
    // typed then, it would move on once more and put the digits of the month into the day.
    const bool is_mark = event->text() == QLatin1String("-") || event->text() == QLatin1String(":");
    const bool is_there = selected == this->sectionText(this->currentSection());
    if (is_mark && is_there && this->currentSectionIndex() > 0) return;
    Edit::keyPressEvent(event);
  }

  QValidator::State validate(QString& text, int& cursor) const override {
    text = with_ascii_digits(std::move(text));
    return Edit::validate(text, cursor);
  }
};

}  // namespace aerostat::viewer

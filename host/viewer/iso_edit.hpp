#pragma once

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <utility>

#include "viewer/number_text.hpp"

namespace aerostat::viewer {

/// A QDateEdit or QTimeEdit with the digits that scene files have, in any locale. Takes digits of
/// any script.
template <typename Edit>
class IsoEdit : public Edit {
 public:
  template <typename Value>
  explicit IsoEdit(const Value& value) : Edit(value) {
    this->setLocale(QLocale::c());
    this->setKeyboardTracking(false);  // a year is one when its last digit is typed
  }

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    const QString selected = this->lineEdit()->selectedText();
    // What is typed over the whole begins with the first part, not with the last one used.
    if (selected == this->text()) this->setSelectedSection(this->sectionAt(0));
    // Edit goes on to the next part by itself once one is full; the mark between them, typed then,
    // would make it go on once more and put the month's digits into the day.
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

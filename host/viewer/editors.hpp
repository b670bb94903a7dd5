#pragma once

#include <QLabel>
#include <QObject>
#include <QWidget>
#include <memory>

#include "scene/field_rule.hpp"
#include "viewer/controls.hpp"
#include "viewer/document.hpp"

namespace aerostat::viewer {

/// One control as a row of a panel: its label and its editor, bound to the document. A double click
/// on the label, its menu, or Ctrl+Backspace in the editor gives the value back to its default.
class ControlRow : public QObject {
  Q_OBJECT

 public:
  /// The widgets belong to whoever lays them out; the row to `parent`.
  static ControlRow* make(const Control& control, Document& document, QObject* parent);

  const Control& control() const { return control_; }
  /// Where its value is.
  const QString& pointer() const { return pointer_; }
  /// Binds it to the like value of another object of its list; an empty one to none.
  void bind_to(const QString& pointer);
  QLabel* label() const { return label_; }
  QWidget* editor() const { return editor_; }

  /// Changes the document, as the editor does. `json` is the value's text.
  void set(const QString& json);
  void reset();
  /// Shows what the document has.
  void refresh();

 protected:
  ControlRow(const Control& control, Document& document, QObject* parent);
  /// To be called once the editor is made.
  void adopt(QWidget* editor);
  virtual void show(const QString& json) = 0;
  const scene::FieldRule& rule() const { return rule_; }
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const Control control_;
  QString pointer_;
  Document& document_;
  scene::FieldRule rule_;
  QLabel* label_;
  QWidget* editor_ = nullptr;
};

}  // namespace aerostat::viewer

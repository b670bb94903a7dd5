#pragma once

#include <QLabel>
#include <QObject>
#include <QWidget>
#include <memory>

#include "scene/field_rule.hpp"
#include "viewer/controls.hpp"
#include "viewer/document.hpp"

namespace aerostat::viewer {

/// One control as a row of a panel, with a label and an editor that is bound to the document. A
/// double click on the label, its menu, or Ctrl+Backspace in the editor resets the value to its
/// default.
class ControlRow : public QObject {
  Q_OBJECT

 public:
  /// Makes the row of a control. The widgets belong to the layout that they are put into, and the
  /// row belongs to `parent`.
  static ControlRow* make(const Control& control, Document& document, QObject* parent);

  const Control& control() const { return control_; }
  /// Returns the pointer of the value in the document.
  const QString& pointer() const { return pointer_; }
  /// Binds the row to the same value of another object in the list. An empty pointer binds it to
  /// nothing.
  void bind_to(const QString& pointer);
  QLabel* label() const { return label_; }
  QWidget* editor() const { return editor_; }

  /// Changes the document as the editor does. `json` is the text of the value.
  void set(const QString& json);
  void reset();
  /// Shows the value of the document.
  void refresh();

 protected:
  ControlRow(const Control& control, Document& document, QObject* parent);
  /// Adopts the editor. Subclasses call it once they have made the editor.
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

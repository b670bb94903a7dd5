#pragma once

#include <QWidget>
#include <functional>

#include "viewer/document.hpp"

class QComboBox;
class QToolButton;

namespace aerostat::viewer {

/// Chooses the object of a list that a panel's controls edit: a balloon, a model, a lamp or a
/// material.
class ItemPicker : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { balloon, model, lamp, material };

  /// Makes a picker for one kind of objects. `near` returns a place above the sea beside which a
  /// new object is put.
  ItemPicker(Kind kind, Document& document, std::function<dvec3()> near = {},
             QWidget* parent = nullptr);

  /// Returns the pointer of the chosen object, such as "/balloons/1", or an empty string if there
  /// is none.
  QString chosen() const;
  void choose(const QString& pointer);
  /// Appends an object of the kind near those that exist, and chooses it. A model needs a file, so
  /// that for models it only reports `file_asked`.
  void add();
  /// Removes the chosen object, unless it is the balloon that always exists.
  void remove();

  /// Returns the part of a control's pointer that is replaced by `chosen`. Returns an empty string
  /// if the control is not about an object of this kind.
  QString prefix_of(const QString& pointer) const;

 Q_SIGNALS:
  void chosen_changed(const QString& pointer);
  void file_asked();

 private:
  QString list() const;
  int count() const;
  int most() const;
  QString name_of(int index) const;
  void show_names();
  void refresh();

  Kind kind_;
  Document& document_;
  std::function<dvec3()> near_;
  QComboBox* items_;
  QToolButton* more_;
  QToolButton* fewer_;
  QString told_;
};

}  // namespace aerostat::viewer

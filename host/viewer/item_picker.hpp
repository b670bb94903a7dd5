#pragma once

#include <QWidget>
#include <functional>

#include "viewer/document.hpp"

class QComboBox;
class QToolButton;

namespace aerostat::viewer {

/// Chooses which object of a list a panel's controls are about: a balloon, a lamp, a material.
class ItemPicker : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { balloon, lamp, material };

  /// `near` is a place above the sea beside which a new one belongs.
  ItemPicker(Kind kind, Document& document, std::function<dvec3()> near = {},
             QWidget* parent = nullptr);

  /// The pointer of the chosen object, such as "/balloons/1"; empty if there is none.
  QString chosen() const;
  void choose(const QString& pointer);
  /// Appends one of the kind, near what there is, and chooses it.
  void add();
  /// Takes the chosen one away, unless it is the balloon that is always there.
  void remove();

  /// The part of a control's pointer that `chosen` takes the place of; empty if it is not of this
  /// kind.
  QString prefix_of(const QString& pointer) const;

 Q_SIGNALS:
  void chosen_changed(const QString& pointer);

 private:
  QString list() const;
  int count() const;
  int most() const;
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

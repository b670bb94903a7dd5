#pragma once

#include <QColor>
#include <QWidget>
#include <vector>

class QHBoxLayout;
class QToolButton;

namespace aerostat::viewer {

/// A list of colours, in which each colour is a button that opens the colour dialog. Values are
/// linear Rec. 709 as JSON, [[r, g, b], ...].
class ColorEditor : public QWidget {
  Q_OBJECT

 public:
  /// Makes an editor for `least` to `most` colours. `title` is the title of the colour dialog.
  ColorEditor(int least, int most, const QString& title, QWidget* parent = nullptr);

  void show_colors(const QString& json);

 Q_SIGNALS:
  void edited(const QString& json);

 private:
  void choose(int index);
  void tell();
  void arrange();

  int least_, most_;
  QString title_;
  std::vector<QColor> colors_;
  std::vector<QToolButton*> buttons_;
  QHBoxLayout* layout_;
  QToolButton* more_;
  QToolButton* fewer_;
};

}  // namespace aerostat::viewer

#pragma once

#include <QDialog>

class QMainWindow;

namespace aerostat::viewer {

/// All that mouse and keys do: the menus' shortcuts, and what works on the picture.
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutsDialog(QMainWindow& window);
};

}  // namespace aerostat::viewer

#pragma once

#include <QDialog>

class QMainWindow;

namespace aerostat::viewer {

/// A dialog that lists everything mouse and keys do: the shortcuts of the menus, and the actions on
/// the picture.
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutsDialog(QMainWindow& window);
};

}  // namespace aerostat::viewer

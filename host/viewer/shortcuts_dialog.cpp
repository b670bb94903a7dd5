#include "viewer/shortcuts_dialog.hpp"

#include <QAction>
#include <QDialogButtonBox>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "viewer/screen_fit.hpp"

namespace aerostat::viewer {
namespace {

QString row(const QString& keys, const QString& meaning) {
  return QStringLiteral(
             "<tr><td width='210'><b>%1</b></td><td style='padding-left:16px'>%2</td></tr>")
      .arg(keys.toHtmlEscaped(), meaning.toHtmlEscaped());
}

QString picture_rows() {
  return row(ShortcutsDialog::tr("Drag"),
             ShortcutsDialog::tr("turn around what is looked at; in the basket, look around")) +
         row(ShortcutsDialog::tr("Right drag, Shift+drag"), ShortcutsDialog::tr("look around")) +
         row(ShortcutsDialog::tr("Wheel, Page Up, Page Down"),
             ShortcutsDialog::tr("closer, away")) +
         row(ShortcutsDialog::tr("Double click"), ShortcutsDialog::tr("aim there")) +
         row(ShortcutsDialog::tr("Ctrl+click"), ShortcutsDialog::tr("put the balloon above it")) +
         row(ShortcutsDialog::tr("Click"), ShortcutsDialog::tr("pick a model")) +
         row(ShortcutsDialog::tr("Drag, Shift+drag on the picked model"),
             ShortcutsDialog::tr("move it, turn it")) +
         row(ShortcutsDialog::tr("Delete, Escape"),
             ShortcutsDialog::tr("remove the picked model, let it go")) +
         row(ShortcutsDialog::tr("W A S D"),
             ShortcutsDialog::tr("fly ahead, left, back, right (Shift: fast)")) +
         row(ShortcutsDialog::tr("Q, E"), ShortcutsDialog::tr("down, up")) +
         row(ShortcutsDialog::tr("Arrows, Shift+arrows"),
             ShortcutsDialog::tr("turn around it, look around")) +
         row(ShortcutsDialog::tr("Middle drag"), ShortcutsDialog::tr("shift the picture at 1:1"));
}

QString control_rows() {
  return row(ShortcutsDialog::tr("Double click on a name, Ctrl+Backspace"),
             ShortcutsDialog::tr("back to the default")) +
         row(ShortcutsDialog::tr("Arrows on the sun's disc"),
             ShortcutsDialog::tr("move the sun (Shift: by 10°)")) +
         row(ShortcutsDialog::tr("Ctrl+."), ShortcutsDialog::tr("dismiss a message"));
}

QString menu_rows(const QMenu& menu) {
  QString rows;
  for (const QAction* action : menu.actions()) {
    if (action->menu() != nullptr) {
      rows += menu_rows(*action->menu());
    } else if (!action->shortcut().isEmpty()) {
      const QString keys = action->shortcut().toString(QKeySequence::NativeText);
      rows += row(keys, QString(action->text()).remove(QLatin1Char('&')));
    }
  }
  return rows;
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(QMainWindow& window) : QDialog(&window) {
  setWindowTitle(tr("Mouse and Keys"));
  const auto table = [](const QString& title, const QString& rows) {
    return "<h4>" + title.toHtmlEscaped() + "</h4><table>" + rows + "</table>";
  };
  QString html =
      table(tr("On the picture"), picture_rows()) + table(tr("On the controls"), control_rows());
  for (const QAction* action : window.menuBar()->actions()) {
    const QString rows = action->menu() != nullptr ? menu_rows(*action->menu()) : QString();
    if (!rows.isEmpty()) html += table(QString(action->text()).remove(QLatin1Char('&')), rows);
  }
  auto* text = new QTextBrowser;
  text->setHtml(html);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text);
  layout->addWidget(buttons);
  resize_to_fit(*this, QSize(560, 620));
}

}  // namespace aerostat::viewer

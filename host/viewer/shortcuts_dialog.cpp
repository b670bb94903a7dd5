#include "viewer/shortcuts_dialog.hpp"

#include <QAction>
#include <QDialogButtonBox>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace aerostat::viewer {
namespace {

QString row(const QString& keys, const QString& meaning) {
  return QStringLiteral("<tr><td><b>%1</b></td><td style='padding-left:16px'>%2</td></tr>")
      .arg(keys.toHtmlEscaped(), meaning.toHtmlEscaped());
}

QString picture_rows() {
  const auto tr = [](const char* text) { return ShortcutsDialog::tr(text); };
  return row(tr("Drag"), tr("turn around what is looked at; in the basket, look around")) +
         row(tr("Right drag, Shift+drag"), tr("look around")) +
         row(tr("Wheel, Page Up, Page Down"), tr("closer, away")) +
         row(tr("Double click"), tr("aim there")) +
         row(tr("Ctrl+click"), tr("put the balloon above it")) +
         row(tr("W A S D"), tr("fly ahead, left, back, right (Shift: fast)")) +
         row(tr("Q, E"), tr("down, up")) +
         row(tr("Arrows, Shift+arrows"), tr("turn around it, look around")) +
         row(tr("Middle drag"), tr("shift the picture at 1:1"));
}

QString control_rows() {
  const auto tr = [](const char* text) { return ShortcutsDialog::tr(text); };
  return row(tr("Double click on a name, Ctrl+Backspace"), tr("back to the default")) +
         row(tr("Arrows on the sun's disc"), tr("move the sun (Shift: by 10°)")) +
         row(tr("Ctrl+."), tr("dismiss a message"));
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
  resize(560, 620);
}

}  // namespace aerostat::viewer

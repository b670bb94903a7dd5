#include "viewer/command_text.hpp"

#include <QFileInfo>
#include <QRegularExpression>
#include <filesystem>

namespace aerostat::viewer {
namespace {

QString device_option(const QString& device) {
  return device.isEmpty() ? QString() : " --device " + shell_word(device);
}

/// Returns the text of a scene on one line.
QString packed(const std::string& text) {
  QString line = QString::fromStdString(text);
  static const QRegularExpression kBreaks(QStringLiteral("\\s*\\n\\s*"));
  return line.replace(kBreaks, QStringLiteral(" ")).trimmed();
}

}  // namespace

QString shell_word(const QString& word) {
  static const QRegularExpression kPlain(QStringLiteral("^[A-Za-z0-9_./:=,+@%-]+$"));
  if (kPlain.match(word).hasMatch()) return word;
  QString quoted = word;
  quoted.replace(QLatin1String("'"), QLatin1String("'\\''"));
  return "'" + quoted + "'";
}

QString command_text(const Document& document, const QString& device) {
  const QString end = " -o " +
                      shell_word(document.path().isEmpty()
                                     ? QStringLiteral("aerostat.png")
                                     : QFileInfo(document.path()).completeBaseName() + ".png") +
                      device_option(device);
  const QString leave = QStringLiteral(" --allow-external-paths");
  if (!document.path().isEmpty()) {
    if (const auto changes = document.source().changes_from(document.saved())) {
      QString command = "aerostat render " + shell_word(document.path());
      const auto folder = std::filesystem::path(document.path().toStdString()).parent_path();
      if (!document.saved().files_outside(folder).empty()) command += leave;
      for (const scene::Override& one : *changes) {
        command += " --set " + shell_word(QString::fromStdString(one.pointer + "=" + one.value));
      }
      return command + end;
    }
  }
  return "printf %s " + shell_word(packed(document.source().text())) +
         " | aerostat render /dev/stdin" +
         (document.source().files_outside("/dev").empty() ? QString() : leave) + end;
}

}  // namespace aerostat::viewer

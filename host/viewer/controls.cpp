#include "viewer/controls.hpp"

#include <QCoreApplication>

#include "scene/field_rule.hpp"

namespace aerostat::viewer {
const std::vector<Control>& controls() {
  return scene::field_edits();
}

QString label_of(const Control& control) {
  return QCoreApplication::translate("Controls", control.label);
}

QString heading_of(const ControlGroup& group) {
  return group.heading == nullptr ? QString()
                                  : QCoreApplication::translate("Controls", group.heading);
}

QString unit_of(const Control& control) {
  return *control.unit == '\0' ? QString() : QCoreApplication::translate("Units", control.unit);
}

QString none_of(const Control& control) {
  return control.none == nullptr ? QString()
                                 : QCoreApplication::translate("Controls", control.none);
}

QString description_of(const Control& control) {
  const std::string text = scene::field_rule(control.pointer).description;
  return QCoreApplication::translate("Schema", text.c_str());
}

QString word_text(const QString& word) {
  QString text = QCoreApplication::translate("Words", word.toUtf8().constData());
  text.replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace aerostat::viewer

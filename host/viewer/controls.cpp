#include "viewer/controls.hpp"

#include <QCoreApplication>

#include "scene/field_rule.hpp"

namespace aerostat::viewer {
namespace {

/// Lists the words of enumerations for the translators.
[[maybe_unused]] constexpr const char* kWords[] = {
    QT_TRANSLATE_NOOP("Words", "pinhole"),   QT_TRANSLATE_NOOP("Words", "thin_lens"),
    QT_TRANSLATE_NOOP("Words", "panorama"),  QT_TRANSLATE_NOOP("Words", "orthographic"),
    QT_TRANSLATE_NOOP("Words", "ember"),     QT_TRANSLATE_NOOP("Words", "lagoon"),
    QT_TRANSLATE_NOOP("Words", "spectrum"),  QT_TRANSLATE_NOOP("Words", "glacier"),
    QT_TRANSLATE_NOOP("Words", "orchard"),   QT_TRANSLATE_NOOP("Words", "plum"),
    QT_TRANSLATE_NOOP("Words", "regatta"),   QT_TRANSLATE_NOOP("Words", "meadow"),
    QT_TRANSLATE_NOOP("Words", "snow"),      QT_TRANSLATE_NOOP("Words", "tropical"),
    QT_TRANSLATE_NOOP("Words", "sand"),      QT_TRANSLATE_NOOP("Words", "sea"),
    QT_TRANSLATE_NOOP("Words", "ground"),    QT_TRANSLATE_NOOP("Words", "balloon"),
    QT_TRANSLATE_NOOP("Words", "flat"),      QT_TRANSLATE_NOOP("Words", "gouraud"),
    QT_TRANSLATE_NOOP("Words", "phong"),     QT_TRANSLATE_NOOP("Words", "draft"),
    QT_TRANSLATE_NOOP("Words", "standard"),  QT_TRANSLATE_NOOP("Words", "final"),
    QT_TRANSLATE_NOOP("Words", "stripes"),   QT_TRANSLATE_NOOP("Words", "chevrons"),
    QT_TRANSLATE_NOOP("Words", "spiral"),    QT_TRANSLATE_NOOP("Words", "rainbow"),
    QT_TRANSLATE_NOOP("Words", "checker"),   QT_TRANSLATE_NOOP("Words", "box"),
    QT_TRANSLATE_NOOP("Words", "tent"),      QT_TRANSLATE_NOOP("Words", "gaussian"),
    QT_TRANSLATE_NOOP("Words", "mountains"), QT_TRANSLATE_NOOP("Words", "island"),
    QT_TRANSLATE_NOOP("Words", "dunes"),     QT_TRANSLATE_NOOP("Words", "fbm"),
    QT_TRANSLATE_NOOP("Words", "ridged"),    QT_TRANSLATE_NOOP("Words", "terrain"),
    QT_TRANSLATE_NOOP("Words", "water"),     QT_TRANSLATE_NOOP("Words", "envelope"),
    QT_TRANSLATE_NOOP("Words", "skirt"),     QT_TRANSLATE_NOOP("Words", "basket"),
    QT_TRANSLATE_NOOP("Words", "rim"),       QT_TRANSLATE_NOOP("Words", "frame"),
    QT_TRANSLATE_NOOP("Words", "cables"),    QT_TRANSLATE_NOOP("Words", "floor"),
    QT_TRANSLATE_NOOP("Words", "flame"),     QT_TRANSLATE_NOOP("Words", "plant"),
    QT_TRANSLATE_NOOP("Words", "stone"),
};

}  // namespace

QString label_of(const Control& control) {
  return QCoreApplication::translate("Controls", control.label);
}

QString group_of(const Control& control) {
  return control.group == nullptr ? QString()
                                  : QCoreApplication::translate("Controls", control.group);
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

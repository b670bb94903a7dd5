#include "viewer/controls.hpp"

#include <QCoreApplication>

#include "scene/field_rule.hpp"

namespace aerostat::viewer {
namespace {

constexpr const char* kMetres = QT_TRANSLATE_NOOP("Units", "m");
constexpr const char* kDegrees = QT_TRANSLATE_NOOP("Units", "°");
constexpr const char* kPixels = QT_TRANSLATE_NOOP("Units", "px");
constexpr const char* kStops = QT_TRANSLATE_NOOP("Units", "EV");

#define LABEL(text) QT_TRANSLATE_NOOP("Controls", text)

constexpr Control kControls[] = {
    {"/biome/kind", LABEL("Biome"), Editor::choice, Panel::land, LABEL("Land")},
    {"/terrain/seed", LABEL("Seed"), Editor::seed, Panel::land},
    {"/terrain/size_m", LABEL("Size"), Editor::number, Panel::land, nullptr, kMetres, 2000, 200000,
     0, true},
    {"/terrain/height_m", LABEL("Height"), Editor::number, Panel::land, nullptr, kMetres, 0, 6000},
    {"/terrain/fractal/gain", LABEL("Roughness"), Editor::number, Panel::land, nullptr, "", 0.2,
     0.8, 2},
    {"/terrain/sharpness", LABEL("Sharpness"), Editor::number, Panel::land, nullptr, "", 0.4, 3, 2},
    {"/terrain/cells", LABEL("Cells a side"), Editor::integer, Panel::land, nullptr, "", 64, 4096,
     0, true},
    {"/biome/ground/snow_line_m", LABEL("Snow line"), Editor::number, Panel::land,
     LABEL("Snow and water"), kMetres, -1000, 4000},
    {"/biome/water/enabled", LABEL("Sea"), Editor::toggle, Panel::land},
    {"/biome/water/level_m", LABEL("Sea level"), Editor::number, Panel::land, nullptr, kMetres,
     -200, 1000},
    {"/vegetation/enabled", LABEL("Plants"), Editor::toggle, Panel::land, LABEL("Plants")},
    {"/vegetation/density", LABEL("Density"), Editor::number, Panel::land, nullptr, "", 0, 2, 2},
    {"/vegetation/size", LABEL("Size of plants"), Editor::number, Panel::land, nullptr, "", 0.3, 3,
     2},

    {"/sun/irradiance", LABEL("Brightness"), Editor::number, Panel::light, nullptr, "", 0, 20, 1},
    {"/sun/soft_shadows", LABEL("Soft shadows"), Editor::toggle, Panel::light},
    {"/sky/cloud_cover", LABEL("High cloud"), Editor::number, Panel::light, LABEL("Air"), "", 0, 1,
     2},
    {"/haze/visibility_m", LABEL("Visibility"), Editor::number, Panel::light, nullptr, kMetres,
     1000, 300000, 0, true},
    {"/fog/enabled", LABEL("Valley fog"), Editor::toggle, Panel::light},
    {"/fog/top_m", LABEL("Top of the fog"), Editor::number, Panel::light, nullptr, kMetres, -200,
     2000},
    {"/fog/visibility_m", LABEL("Sight in the fog"), Editor::number, Panel::light, nullptr, kMetres,
     20, 5000, 0, true},

    {"/balloon/enabled", LABEL("Balloon"), Editor::toggle, Panel::balloon, LABEL("Balloon")},
    {"/balloon/position/0", LABEL("East"), Editor::number, Panel::balloon, nullptr, kMetres, -2000,
     2000, 1},
    {"/balloon/position/1", LABEL("Height"), Editor::number, Panel::balloon, nullptr, kMetres, 0,
     1500, 1},
    {"/balloon/position/2", LABEL("South"), Editor::number, Panel::balloon, nullptr, kMetres, -2000,
     2000, 1},
    {"/balloon/height_above", LABEL("Height counts from"), Editor::choice, Panel::balloon},
    {"/balloon/heading_deg", LABEL("Heading"), Editor::number, Panel::balloon, nullptr, kDegrees,
     -180, 180, 0},
    {"/balloon/diameter_m", LABEL("Diameter"), Editor::number, Panel::balloon, nullptr, kMetres, 10,
     40, 1},
    {"/balloon/gores", LABEL("Gores"), Editor::integer, Panel::balloon, LABEL("Envelope"), "", 8,
     48},
    {"/balloon/pattern", LABEL("Pattern"), Editor::choice, Panel::balloon},
    {"/balloon/colors", LABEL("Colours"), Editor::colors, Panel::balloon},

    {"/camera/fov_y_deg", LABEL("Angle of view"), Editor::number, Panel::view, nullptr, kDegrees, 8,
     110, 1},

    {"/shading", LABEL("Shading"), Editor::choice, Panel::picture, LABEL("Picture")},
    {"/quality", LABEL("Quality"), Editor::choice, Panel::picture},
    {"/image/spp", LABEL("Samples a pixel"), Editor::integer, Panel::picture, nullptr, "", 1, 256,
     0, true},
    {"/image/width", LABEL("Width"), Editor::integer, Panel::picture, LABEL("Size"), kPixels, 160,
     3840},
    {"/image/height", LABEL("Height"), Editor::integer, Panel::picture, nullptr, kPixels, 90, 2160},
    {"/image/exposure_ev", LABEL("Exposure"), Editor::number, Panel::picture, LABEL("Development"),
     kStops, -6, 6, 2},
    {"/image/filter", LABEL("Filter"), Editor::choice, Panel::picture},
};

#undef LABEL

/// Words of enumerations, for the translators.
[[maybe_unused]] constexpr const char* kWords[] = {
    QT_TRANSLATE_NOOP("Words", "snow"),     QT_TRANSLATE_NOOP("Words", "tropical"),
    QT_TRANSLATE_NOOP("Words", "sand"),     QT_TRANSLATE_NOOP("Words", "sea"),
    QT_TRANSLATE_NOOP("Words", "ground"),   QT_TRANSLATE_NOOP("Words", "balloon"),
    QT_TRANSLATE_NOOP("Words", "flat"),     QT_TRANSLATE_NOOP("Words", "gouraud"),
    QT_TRANSLATE_NOOP("Words", "phong"),    QT_TRANSLATE_NOOP("Words", "draft"),
    QT_TRANSLATE_NOOP("Words", "standard"), QT_TRANSLATE_NOOP("Words", "final"),
    QT_TRANSLATE_NOOP("Words", "stripes"),  QT_TRANSLATE_NOOP("Words", "chevrons"),
    QT_TRANSLATE_NOOP("Words", "spiral"),   QT_TRANSLATE_NOOP("Words", "rainbow"),
    QT_TRANSLATE_NOOP("Words", "checker"),  QT_TRANSLATE_NOOP("Words", "box"),
    QT_TRANSLATE_NOOP("Words", "tent"),     QT_TRANSLATE_NOOP("Words", "gaussian"),
};

}  // namespace

std::span<const Control> controls() {
  return kControls;
}

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

QString description_of(const Control& control) {
  const std::string text = scene::field_rule(control.pointer).description;
  return QCoreApplication::translate("Schema", text.c_str());
}

QString word_text(const QString& word) {
  QString text = QCoreApplication::translate("Words", word.toUtf8().constData());
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace aerostat::viewer

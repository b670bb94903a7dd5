#include "viewer/controls.hpp"

#include <QCoreApplication>

#include "scene/field_rule.hpp"

namespace aerostat::viewer {
namespace {

constexpr const char* kMetres = QT_TRANSLATE_NOOP("Units", "m");
constexpr const char* kDegrees = QT_TRANSLATE_NOOP("Units", "°");
constexpr const char* kPixels = QT_TRANSLATE_NOOP("Units", "px");
constexpr const char* kStops = QT_TRANSLATE_NOOP("Units", "EV");

constexpr Control kControls[] = {
    {"/biome/kind", QT_TRANSLATE_NOOP("Controls", "Biome"), Editor::choice, Panel::land,
     QT_TRANSLATE_NOOP("Controls", "Land")},
    {"/terrain/seed", QT_TRANSLATE_NOOP("Controls", "Seed"), Editor::seed, Panel::land},
    {"/terrain/size_m", QT_TRANSLATE_NOOP("Controls", "Size"), Editor::number, Panel::land, nullptr,
     kMetres, 2000, 200000, 0, true},
    {"/terrain/height_m", QT_TRANSLATE_NOOP("Controls", "Height"), Editor::number, Panel::land,
     nullptr, kMetres, 0, 6000},
    {"/terrain/fractal/gain", QT_TRANSLATE_NOOP("Controls", "Roughness"), Editor::number,
     Panel::land, nullptr, "", 0.2, 0.8, 2},
    {"/terrain/sharpness", QT_TRANSLATE_NOOP("Controls", "Sharpness"), Editor::number, Panel::land,
     nullptr, "", 0.4, 3, 2},
    {"/terrain/erosion", QT_TRANSLATE_NOOP("Controls", "Erosion"), Editor::number, Panel::land,
     nullptr, "", 0, 1, 2},
    {"/terrain/cells", QT_TRANSLATE_NOOP("Controls", "Cells a side"), Editor::integer, Panel::land,
     nullptr, "", 64, 4096, 0, true},
    {"/biome/ground/snow_line_m", QT_TRANSLATE_NOOP("Controls", "Snow line"), Editor::number,
     Panel::land, QT_TRANSLATE_NOOP("Controls", "Snow and water"), kMetres, -1000, 4000},
    {"/biome/water/enabled", QT_TRANSLATE_NOOP("Controls", "Sea"), Editor::toggle, Panel::land},
    {"/biome/water/level_m", QT_TRANSLATE_NOOP("Controls", "Sea level"), Editor::number,
     Panel::land, nullptr, kMetres, -200, 1000},
    {"/vegetation/enabled", QT_TRANSLATE_NOOP("Controls", "Plants"), Editor::toggle, Panel::land,
     QT_TRANSLATE_NOOP("Controls", "Plants")},
    {"/vegetation/density", QT_TRANSLATE_NOOP("Controls", "Density"), Editor::number, Panel::land,
     nullptr, "", 0, 2, 2},
    {"/vegetation/size", QT_TRANSLATE_NOOP("Controls", "Size of plants"), Editor::number,
     Panel::land, nullptr, "", 0.3, 3, 2},

    {"/sun/irradiance", QT_TRANSLATE_NOOP("Controls", "Brightness"), Editor::number, Panel::light,
     nullptr, "", 0, 20, 1},
    {"/sun/soft_shadows", QT_TRANSLATE_NOOP("Controls", "Soft shadows"), Editor::toggle,
     Panel::light},
    {"/sky/cloud_cover", QT_TRANSLATE_NOOP("Controls", "High cloud"), Editor::number, Panel::light,
     QT_TRANSLATE_NOOP("Controls", "Air"), "", 0, 1, 2},
    {"/sky/cumulus/cover", QT_TRANSLATE_NOOP("Controls", "Heaped clouds"), Editor::number,
     Panel::light, nullptr, "", 0, 1, 2},
    {"/sky/cumulus/base_m", QT_TRANSLATE_NOOP("Controls", "Base of the clouds"), Editor::number,
     Panel::light, nullptr, kMetres, 200, 5000},
    {"/haze/visibility_m", QT_TRANSLATE_NOOP("Controls", "Visibility"), Editor::number,
     Panel::light, nullptr, kMetres, 1000, 300000, 0, true},
    {"/fog/enabled", QT_TRANSLATE_NOOP("Controls", "Valley fog"), Editor::toggle, Panel::light},
    {"/fog/top_m", QT_TRANSLATE_NOOP("Controls", "Top of the fog"), Editor::number, Panel::light,
     nullptr, kMetres, -200, 2000},
    {"/fog/visibility_m", QT_TRANSLATE_NOOP("Controls", "Sight in the fog"), Editor::number,
     Panel::light, nullptr, kMetres, 20, 5000, 0, true},

    {"/balloon/enabled", QT_TRANSLATE_NOOP("Controls", "Balloon"), Editor::toggle, Panel::balloon,
     QT_TRANSLATE_NOOP("Controls", "Balloon")},
    {"/balloon/position/0", QT_TRANSLATE_NOOP("Controls", "East"), Editor::number, Panel::balloon,
     nullptr, kMetres, -2000, 2000, 1},
    {"/balloon/position/1", QT_TRANSLATE_NOOP("Controls", "Height"), Editor::number, Panel::balloon,
     nullptr, kMetres, 0, 1500, 1},
    {"/balloon/position/2", QT_TRANSLATE_NOOP("Controls", "South"), Editor::number, Panel::balloon,
     nullptr, kMetres, -2000, 2000, 1},
    {"/balloon/height_above", QT_TRANSLATE_NOOP("Controls", "Height counts from"), Editor::choice,
     Panel::balloon},
    {"/balloon/heading_deg", QT_TRANSLATE_NOOP("Controls", "Heading"), Editor::number,
     Panel::balloon, nullptr, kDegrees, -180, 180, 0},
    {"/balloon/diameter_m", QT_TRANSLATE_NOOP("Controls", "Diameter"), Editor::number,
     Panel::balloon, nullptr, kMetres, 10, 40, 1},
    {"/balloon/burner", QT_TRANSLATE_NOOP("Controls", "Burner"), Editor::number, Panel::balloon,
     nullptr, "", 0, 1, 2},
    {"/balloon/gores", QT_TRANSLATE_NOOP("Controls", "Gores"), Editor::integer, Panel::balloon,
     QT_TRANSLATE_NOOP("Controls", "Envelope"), "", 8, 48},
    {"/balloon/pattern", QT_TRANSLATE_NOOP("Controls", "Pattern"), Editor::choice, Panel::balloon},
    {"/balloon/palette", QT_TRANSLATE_NOOP("Controls", "Palette"), Editor::choice, Panel::balloon},
    {"/balloon/colors", QT_TRANSLATE_NOOP("Controls", "Colours"), Editor::colors, Panel::balloon},

    {"/camera/fov_y_deg", QT_TRANSLATE_NOOP("Controls", "Angle of view"), Editor::number,
     Panel::view, nullptr, kDegrees, 8, 110, 1},
    {"/camera/lens", QT_TRANSLATE_NOOP("Controls", "Lens"), Editor::choice, Panel::view},
    {"/camera/f_number", QT_TRANSLATE_NOOP("Controls", "F-number"), Editor::number, Panel::view,
     nullptr, "", 0.5, 22, 1, true},
    {"/camera/focus_m", QT_TRANSLATE_NOOP("Controls", "Sharp at"), Editor::number, Panel::view,
     nullptr, kMetres, 1, 5000, 1, true},
    {"/camera/view_height_m", QT_TRANSLATE_NOOP("Controls", "Height of parallel view"),
     Editor::number, Panel::view, nullptr, kMetres, 10, 5000, 0, true},

    {"/shading", QT_TRANSLATE_NOOP("Controls", "Shading"), Editor::choice, Panel::picture,
     QT_TRANSLATE_NOOP("Controls", "Picture")},
    {"/quality", QT_TRANSLATE_NOOP("Controls", "Quality"), Editor::choice, Panel::picture},
    {"/image/spp", QT_TRANSLATE_NOOP("Controls", "Samples a pixel"), Editor::integer,
     Panel::picture, nullptr, "", 1, 256, 0, true},
    {"/image/width", QT_TRANSLATE_NOOP("Controls", "Width"), Editor::integer, Panel::picture,
     QT_TRANSLATE_NOOP("Controls", "Size"), kPixels, 160, 3840},
    {"/image/height", QT_TRANSLATE_NOOP("Controls", "Height"), Editor::integer, Panel::picture,
     nullptr, kPixels, 90, 2160},
    {"/image/exposure_ev", QT_TRANSLATE_NOOP("Controls", "Exposure"), Editor::number,
     Panel::picture, QT_TRANSLATE_NOOP("Controls", "Development"), kStops, -6, 6, 2},
    {"/image/filter", QT_TRANSLATE_NOOP("Controls", "Filter"), Editor::choice, Panel::picture},
};

/// Words of enumerations, for the translators.
[[maybe_unused]] constexpr const char* kWords[] = {
    QT_TRANSLATE_NOOP("Words", "pinhole"),  QT_TRANSLATE_NOOP("Words", "thin_lens"),
    QT_TRANSLATE_NOOP("Words", "panorama"), QT_TRANSLATE_NOOP("Words", "orthographic"),
    QT_TRANSLATE_NOOP("Words", "ember"),    QT_TRANSLATE_NOOP("Words", "lagoon"),
    QT_TRANSLATE_NOOP("Words", "spectrum"), QT_TRANSLATE_NOOP("Words", "glacier"),
    QT_TRANSLATE_NOOP("Words", "orchard"),  QT_TRANSLATE_NOOP("Words", "plum"),
    QT_TRANSLATE_NOOP("Words", "regatta"),  QT_TRANSLATE_NOOP("Words", "meadow"),
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
  text.replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace aerostat::viewer

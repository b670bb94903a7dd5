// Tests that every value of a scene has a control, or a reason to have none.
#include <QtTest>

#include "scene/field_rule.hpp"
#include "scene/scene.hpp"
#include "viewer/controls.hpp"

namespace aerostat::viewer {

/// Returns whether a value is a part of a film, a place, a track or a layout of samples, which are
/// given in the scene file.
bool is_named_in_files(const QString& pointer) {
  static const QRegularExpression kParts(
      "^/film/|/(at|look_at|track|place|raw|objects|artwork|envelope|cover|clearings|species)/");
  return pointer.contains(kParts);
}

/// Returns the values that no control sets, and what does.
QMap<QString, QString> set_otherwise() {
  return {{"/$schema", "names the schema, for text editors"},
          {"/version", "of the format"},
          {"/camera/view", "the view's own box"},
          {"/sky/radiance", "for comparisons, in the file"},
          {"/sky/cloud_drift_m", "moved by films"},
          {"/sky/cumulus/drift_m", "moved by films"},
          {"/sky/cumulus/rise_m", "moved by films"},
          {"/sky/cloud_bend_m", "moved by films"},
          {"/biome/water/time_s", "moved by films"},
          {"/stars/year", "follows from the date"},
          {"/terrain/source", "the file that is opened"},
          {"/terrain/crs", "of that file"},
          {"/terrain/unit", "of that file"},
          {"/terrain/nodata", "of that file"},
          {"/terrain/image_heights_m", "of that file"},
          {"/terrain/cell_m", "of that file"},
          {"/terrain/encoding", "of that file"},
          {"/terrain/variable", "of that file"},
          {"/terrain/extent_m", "in the scene file"},
          {"/terrain/voids", "of that file"},
          {"/terrain/drape/file", "in the scene file"},
          {"/terrain/drape/crs", "of that file"},
          {"/terrain/drape/corners/north_west", "of that file"},
          {"/terrain/drape/corners/south_east", "of that file"},
          {"/sun/azimuth_deg", "the sun's panel"},
          {"/sun/elevation_deg", "the sun's panel"},
          {"/sun/direction", "the same as the two angles"},
          {"/sun/date", "the sun's panel"},
          {"/sun/time", "the sun's panel"},
          {"/sun/latitude_deg", "the sun's panel"},
          {"/sun/longitude_deg", "the sun's panel"}};
}

class ValuesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void every_value_of_a_scene_can_be_set();
};

void ValuesTest::every_value_of_a_scene_can_be_set() {
  QSet<QString> reached;
  for (const Control& control : controls()) {
    QString pointer = QString::fromStdString(control.pointer);
    // An element of an array stands for the whole array.
    static const QRegularExpression kElement("/[0-9]$");
    pointer.remove(kElement);
    reached << pointer;
    if (pointer.startsWith("/balloon/")) reached << "/balloons/0" + pointer.mid(8);
    for (std::size_t i = 0; i < scene::kMaterialCount; ++i) {
      const auto id = static_cast<scene::MaterialId>(i);
      const auto name = QString::fromStdString(scene::material_name(id));
      if (pointer.startsWith("/materials/envelope/")) {
        reached << "/materials/" + name + pointer.mid(19);
      }
    }
  }
  const QMap<QString, QString> otherwise = set_otherwise();
  for (const std::string& one : scene::field_pointers()) {
    const QString pointer = QString::fromStdString(one);
    QVERIFY2(reached.contains(pointer) || otherwise.contains(pointer) || is_named_in_files(pointer),
             qPrintable(pointer + " has no control"));
  }
  for (auto at = otherwise.begin(); at != otherwise.end(); ++at) {
    QVERIFY2(!reached.contains(at.key()), qPrintable(at.key() + " has a control"));
  }
}

}  // namespace aerostat::viewer

QTEST_GUILESS_MAIN(aerostat::viewer::ValuesTest)
#include "values_test.moc"

// Tests that every control changes the scene at its pointer, also in the file that is saved.
#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "scene/field_rule.hpp"
#include "scene/scene.hpp"
#include "viewer/camera_control.hpp"
#include "viewer/color_editor.hpp"
#include "viewer/command_text.hpp"
#include "viewer/panels.hpp"
#include "viewer/scene_presets.hpp"
#include "viewer/sun_disc.hpp"
#include "viewer/sun_panel.hpp"

namespace aerostat::viewer {
namespace {

QJsonValue parsed(const QString& json) {
  return QJsonDocument::fromJson(QString("[" + json + "]").toUtf8()).array().at(0);
}

/// Returns the scene of a document as it would be rendered.
QJsonObject dump(const Document& document) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(scene::write_text(document.scene())))
      .object();
}

QJsonValue at(const QJsonObject& scene, const QString& pointer) {
  QJsonValue value = scene;
  for (const QString& token : pointer.mid(1).split('/')) {
    value = value.isArray() ? value.toArray().at(token.toInt()) : value.toObject().value(token);
  }
  return value;
}

QString object_of(const QString& pointer) {
  return pointer.section('/', 0, pointer.startsWith("/balloon/") ? 1 : 2);
}

/// Changes the shown value to another one, with the widget that a user would use.
void change_by_hand(const ControlRow& row) {
  QWidget* editor = row.editor();
  switch (row.control().editor) {
    case Editor::number:
    case Editor::integer:
    case Editor::seed: {
      auto* box = editor->findChild<QDoubleSpinBox*>();
      const double up = box->value() + (box->decimals() > 0 ? 0.25 : 3.0);
      box->setValue(up <= box->maximum() ? up : box->value() - 1.0);
      break;
    }
    case Editor::toggle:
      qobject_cast<QAbstractButton*>(editor)->click();
      break;
    case Editor::choice: {
      auto* box = qobject_cast<QComboBox*>(editor);
      const int next = (box->currentIndex() + 1) % box->count();
      box->setCurrentIndex(next);
      Q_EMIT box->activated(next);
      break;
    }
    case Editor::color:
      Q_EMIT qobject_cast<ColorEditor*>(editor)->edited("[[0.25, 0.5, 0.125]]");
      break;
    case Editor::triple: {
      auto* box = editor->findChildren<QDoubleSpinBox*>().at(2);
      box->setValue(box->value() + 0.5);
      break;
    }
    case Editor::colors:
      for (auto* button : editor->findChildren<QAbstractButton*>()) {
        if (button->text() == "+") button->click();
      }
      break;
  }
}

}  // namespace

class ControlsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void every_control_data();
  void every_control();
  void lists_grow_and_shrink();
  void no_beach_is_said_in_words();
  void every_control_has_a_text_and_a_unit_that_fits();
  void sun_by_disc();
  void sun_by_date();
  void the_disc_means_what_it_shows();
  void views();
  void cameras_of_the_scenes();
  void dice_and_back();
  void undo_merges_a_gesture();
  void a_wrong_value_is_told_and_changes_nothing();
  void files();
  void command_lines();

 private:
  ControlRow* row(const QString& pointer) const;
  void fill_lists();

  std::unique_ptr<Document> document_;
  std::unique_ptr<CameraControl> camera_;
  std::unique_ptr<Panels> panels_;
  QTemporaryDir folder_;
};

void ControlsTest::init() {
  qputenv("AEROSTAT_SCENE_DIR", AEROSTAT_SOURCE_DIR "/scenes");
  panels_.reset();
  camera_.reset();
  document_ = std::make_unique<Document>();
  camera_ = std::make_unique<CameraControl>(*document_);
  panels_ = std::make_unique<Panels>(*document_, *camera_);
}

ControlRow* ControlsTest::row(const QString& pointer) const {
  for (ControlRow* one : panels_->rows()) {
    if (pointer == QString::fromStdString(one->control().pointer)) return one;
  }
  return nullptr;
}

void ControlsTest::every_control_data() {
  QTest::addColumn<QString>("pointer");
  QTest::addColumn<QString>("bound_to");
  for (const Control& control : controls()) {
    const QString own = QString::fromStdString(control.pointer);
    QTest::newRow(control.pointer.c_str()) << own << own;
    const std::pair<QString, QString> others[] = {{"/balloon/", "/balloons/1/"},
                                                  {"/objects/0/", "/objects/1/"},
                                                  {"/materials/envelope/", "/materials/rim/"},
                                                  {"/lights/0/", "/lights/1/"}};
    for (const auto& [first, other] : others) {
      if (!own.startsWith(first)) continue;
      const QString bound = other + own.mid(first.size());
      QTest::newRow(qPrintable(bound)) << own << bound;
    }
  }
}

void ControlsTest::fill_lists() {
  const QString model = "{\"file\": \"" + folder_.filePath("church.glb") + "\"}";
  QVERIFY(document_->set("models", "/objects", "[" + model + "," + model + "]"));
  for (int i = 0; i < 2; ++i) panels_->balloons().add();
  for (int i = 0; i < 2; ++i) panels_->lamps().add();
  panels_->balloons().choose("/balloon");
  panels_->models().choose("/objects/0");
  panels_->lamps().choose("/lights/0");
  document_->start(document_->source(), {});
}

void ControlsTest::every_control() {
  QFETCH(QString, pointer);
  QFETCH(QString, bound_to);
  fill_lists();
  ControlRow* control = row(pointer);
  QVERIFY(control != nullptr);
  for (ItemPicker* picker :
       {&panels_->balloons(), &panels_->models(), &panels_->lamps(), &panels_->materials()}) {
    if (!picker->prefix_of(pointer).isEmpty()) picker->choose(object_of(bound_to));
  }
  pointer = bound_to;
  control->reset();
  document_->start(document_->source(), {});
  const QJsonObject before = dump(*document_);
  change_by_hand(*control);
  const QJsonObject changed = dump(*document_);
  QVERIFY2(at(changed, pointer) != at(before, pointer), "the scene did not change there");
  QCOMPARE(at(changed, pointer), parsed(document_->value(pointer)));
  QVERIFY(control->label()->font().bold());

  const QString path = folder_.filePath("scene.json");
  QVERIFY(document_->save(path));
  Document opened;
  QVERIFY(opened.open(path));
  QCOMPARE(dump(opened), changed);

  QTest::mouseDClick(control->label(), Qt::LeftButton);
  QCOMPARE(dump(*document_), before);
  QVERIFY(!control->label()->font().bold());
  document_->undo_stack().undo();
  QCOMPARE(dump(*document_), changed);
  document_->undo_stack().undo();
  QCOMPARE(dump(*document_), before);
}

void ControlsTest::every_control_has_a_text_and_a_unit_that_fits() {
  for (const Control& control : controls()) {
    QVERIFY2(!description_of(control).isEmpty(), control.pointer.c_str());
    const QString pointer = QString::fromStdString(control.pointer);
    if (pointer.endsWith("_m") && !pointer.endsWith("_per_m"))
      QCOMPARE(unit_of(control), QString("m"));
    if (pointer.endsWith("_deg")) QCOMPARE(unit_of(control), QString("°"));
    const scene::FieldRule rule = scene::field_rule(control.pointer);
    const bool numeric = control.editor == Editor::number || control.editor == Editor::integer;
    QVERIFY2(!numeric || (control.from >= rule.minimum && control.to <= rule.maximum),
             control.pointer.c_str());
  }
}

void ControlsTest::lists_grow_and_shrink() {
  ItemPicker& balloons = panels_->balloons();
  ItemPicker& lamps = panels_->lamps();
  QCOMPARE(balloons.chosen(), QString("/balloon"));
  QVERIFY(lamps.chosen().isEmpty());
  QWidget* intensity = row("/lights/0/intensity")->editor();
  for (auto* fold : panels_->findChildren<QToolButton*>()) {
    if (fold->isCheckable()) fold->setChecked(true);
  }
  QVERIFY2(intensity->isHidden(), "of a lamp that is not there");
  for (int i = 0; i < 2; ++i) balloons.add();
  QCOMPARE(balloons.chosen(), QString("/balloons/1"));
  row("/balloon/gores")->set("12");
  QCOMPARE(document_->scene().balloons[1].gores, 12);
  QVERIFY(document_->scene().balloon.gores != 12);
  balloons.choose("/balloons/0");
  balloons.remove();
  QCOMPARE(document_->scene().balloons.size(), std::size_t{1});
  QCOMPARE(document_->scene().balloons[0].gores, 12);
  QCOMPARE(balloons.chosen(), QString("/balloons/0"));
  balloons.remove();
  QCOMPARE(balloons.chosen(), QString("/balloon"));
  QCOMPARE(document_->source().text(), scene::SceneSource().text());
  lamps.add();
  QVERIFY(intensity->isEnabled());
  QVERIFY(!intensity->isHidden());
  document_->undo_stack().undo();
  QVERIFY(lamps.chosen().isEmpty());
  QVERIFY(intensity->isHidden());
}

void ControlsTest::no_beach_is_said_in_words() {
  auto* box = row("/biome/ground/beach_top_m")->editor()->findChild<QDoubleSpinBox*>();
  QCOMPARE(box->text(), QString("no beach"));
  row("/biome/ground/beach_top_m")->set("2.5");
  QCOMPARE(box->text(), QString("2.5 m"));
  document_->undo_stack().undo();
  QCOMPARE(box->text(), QString("no beach"));
}

void ControlsTest::sun_by_disc() {
  SunDisc& disc = panels_->sun().disc();
  disc.resize(200, 200);
  QTest::mousePress(&disc, Qt::LeftButton, {}, disc.point_of(90.0, 45.0).toPoint());
  QTest::mouseRelease(&disc, Qt::LeftButton, {}, disc.point_of(90.0, 45.0).toPoint());
  const dvec3 direction = document_->scene().sun.direction;
  QVERIFY2(direction.x > 0.6 && std::abs(direction.z) < 0.03, "east");
  QVERIFY(std::abs(direction.y - 0.7071) < 0.03);
  QTest::mouseDClick(&disc, Qt::LeftButton, {}, QPoint(100, 100));
  QCOMPARE(document_->source().text(), scene::SceneSource().text());
}

void ControlsTest::sun_by_date() {
  panels_->sun().set_date();
  QCOMPARE(document_->value("/sun/date"), QString("\"2024-06-21\""));
  QCOMPARE(document_->value("/sun/time"), QString("\"06:30+02:00\""));
  const double elevation = document_->value("/sun/elevation_deg").toDouble();
  QVERIFY2(elevation > 5.0 && elevation < 15.0, "an early summer morning in the Alps");
  panels_->sun().set_angles(10.0, 20.0);
  QVERIFY(document_->value("/sun/date").isEmpty());
  QCOMPARE(document_->value("/sun/elevation_deg").toDouble(), 20.0);
}

void ControlsTest::the_disc_means_what_it_shows() {
  SunDisc disc;
  disc.resize(180, 150);
  for (const double azimuth : {-170.0, -45.0, 0.0, 90.0, 135.0}) {
    for (const double elevation : {-5.0, 0.0, 30.0, 80.0}) {
      double a = 0.0, e = 0.0;
      disc.angles_at(disc.point_of(azimuth, elevation), a, e);
      QVERIFY(std::abs(a - azimuth) < 0.2 && std::abs(e - elevation) < 0.2);
    }
  }
}

void ControlsTest::views() {
  QCOMPARE(camera_->kind(), ViewKind::outside);
  camera_->set_kind(ViewKind::basket);
  QCOMPARE(document_->scene().camera.view, scene::View::basket);
  QCOMPARE(camera_->kind(), ViewKind::basket);
  camera_->set_kind(ViewKind::outside);
  QCOMPARE(document_->source().text(), scene::SceneSource().text());
  for (int i = 0; i < CameraControl::preset_names().size(); ++i) {
    camera_->apply_preset(i);
    QCOMPARE(camera_->kind(), ViewKind::free);
  }
}

void ControlsTest::cameras_of_the_scenes() {
  const auto of_sand = scene_presets(scene::BiomeKind::sand);
  QCOMPARE(of_sand.size(), std::size_t{6});
  QVERIFY(document_->set("biome", "/biome/kind", "\"sand\""));
  QVERIFY(document_->set("seed", "/terrain/seed", "7"));
  QVERIFY(document_->set("up", "/camera/lens", "\"panorama\""));
  for (const ScenePreset& preset : of_sand) {
    camera_->take_camera_of(preset.name, preset.scene);
    QCOMPARE(
        at(dump(*document_), "/camera"),
        QJsonDocument::fromJson(QByteArray::fromStdString(scene::write_text(preset.scene.scene())))
            .object()
            .value("camera"));
    QCOMPARE(document_->scene().terrain.seed, 7u);
  }
  auto* box = panels_->findChild<QComboBox*>("presets");
  QVERIFY(box->findText("sand-empty") > 0);
  QCOMPARE(box->findText("snow"), -1);
  const int as_in_file = 1;
  Q_EMIT box->activated(as_in_file);
  QVERIFY(!document_->source().differs("/camera/lens"));
  QCOMPARE(camera_->kind(), ViewKind::outside);
}

void ControlsTest::dice_and_back() {
  QWidget* editor = row("/terrain/seed")->editor();
  const auto buttons = editor->findChildren<QAbstractButton*>();
  QCOMPARE(buttons.size(), 2);
  QVERIFY(!buttons[1]->isEnabled());
  buttons[0]->click();
  const auto thrown = document_->scene().terrain.seed;
  buttons[0]->click();
  buttons[1]->click();
  QCOMPARE(document_->scene().terrain.seed, thrown);
  buttons[1]->click();
  QCOMPARE(document_->scene().terrain.seed, 1u);
}

void ControlsTest::undo_merges_a_gesture() {
  for (int i = 0; i < 20; ++i) row("/haze/visibility_m")->set(QString::number(20000 + 100 * i));
  QCOMPARE(document_->undo_stack().count(), 1);
  document_->end_gesture();
  row("/haze/visibility_m")->set("9000");
  QCOMPARE(document_->undo_stack().count(), 2);
  document_->undo_stack().undo();
  QCOMPARE(document_->value("/haze/visibility_m").toDouble(), 21900.0);
  document_->undo_stack().undo();
  QCOMPARE(document_->source().text(), scene::SceneSource().text());
}

void ControlsTest::a_wrong_value_is_told_and_changes_nothing() {
  QSignalSpy failed(document_.get(), &Document::failed);
  QVERIFY(!document_->set("x", "/image/width", "-4"));
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed.at(0).at(0).toString().contains("/image/width"));
  QCOMPARE(document_->source().text(), scene::SceneSource().text());
}

void ControlsTest::files() {
  QVERIFY(!document_->is_modified());
  row("/terrain/seed")->set("9");
  QVERIFY(document_->is_modified());
  const QString path = folder_.filePath("files.json");
  QVERIFY(document_->save(path));
  QVERIFY(!document_->is_modified());
  QVERIFY(!document_->save("/no/such/folder/scene.json"));
  QCOMPARE(document_->path(), path);
  QFile broken(folder_.filePath("broken.json"));
  QVERIFY(broken.open(QIODevice::WriteOnly));
  broken.write("{\"version\": 1, \"terain\": {}}");
  broken.close();
  QSignalSpy failed(document_.get(), &Document::failed);
  QVERIFY(!document_->open(broken.fileName()));
  QVERIFY(failed.at(0).at(0).toString().contains("broken.json:1:16: /terain"));
  QVERIFY(!failed.at(0).at(0).toString().contains("Further"));
  QVERIFY(broken.open(QIODevice::WriteOnly));
  broken.write("{\"version\": 1, \"terain\": {}, \"ski\": {}, \"image\": 1}");
  broken.close();
  QVERIFY(!document_->open(broken.fileName()));
  QVERIFY(failed.at(1).at(0).toString().endsWith("Further faults: 2"));
  QCOMPARE(document_->path(), path);
}

void ControlsTest::command_lines() {
  row("/terrain/seed")->set("9");
  const QString piped = command_text(*document_, "0:1");
  QVERIFY2(piped.startsWith("printf %s '{ \"version\": 1"), qPrintable(piped));
  QVERIFY(piped.endsWith("| aerostat render /dev/stdin -o aerostat.png --device 0:1"));
  const QString path = folder_.filePath("it's.json");
  QVERIFY(document_->save(path));
  row("/balloon/pattern")->set("\"spiral\"");
  const QString command = command_text(*document_, {});
  QVERIFY2(command.contains("'\\''s.json' --set '/balloon/pattern=\"spiral\"' -o"),
           qPrintable(command));
  QVERIFY(!command.contains("seed"));
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::ControlsTest)
#include "controls_test.moc"

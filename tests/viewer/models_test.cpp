// Tests models and pictures that are dropped on the window, and how the mouse moves models.
#include <QAbstractButton>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QTemporaryDir>
#include <QtTest>

#include "scene/scene.hpp"
#include "small_window.hpp"
#include "viewer/command_text.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"
#include "viewer/panels.hpp"
#include "viewer/picture_view.hpp"

namespace aerostat::viewer {
namespace {

/// The longest wait in milliseconds. Kernels may have to be compiled first.
constexpr int kPatience_ms = 180000;
constexpr auto kModelId = static_cast<std::uint32_t>(scene::ObjectId::model);
constexpr auto kEnvelopeId = static_cast<std::uint32_t>(scene::ObjectId::envelope);
const QString kHouse =
    QStringLiteral(AEROSTAT_SOURCE_DIR "/tests/data/models/building-small-a.glb");
const QString kDrawing = QStringLiteral(AEROSTAT_SOURCE_DIR "/docs/gallery/viewer.png");

}  // namespace

class ModelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void a_dropped_model_stands_where_it_fell();
  void a_dropped_model_stands_on_real_land();
  void the_mouse_picks_moves_and_turns_a_model();
  void a_model_is_removed_and_comes_back();
  void a_model_that_falls_into_the_sky_is_told();
  void a_moved_model_forgets_its_place_on_the_earth();
  void a_picture_becomes_artwork();
  void a_picture_beside_the_envelope_is_told();
  void files_are_named_from_the_folder_of_the_scene();
  void a_lens_and_its_inverse_agree_data();
  void a_lens_and_its_inverse_agree();

 private:
  bool wait_until_done();
  void drop(const QString& path, const QPointF& place);
  QPoint point_of(const QPointF& place) const;
  /// Writes a scene around a file of heights by latitude and longitude, and returns its path.
  QString land_from(const QString& heights) const;
  void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers = {});
  /// Returns the middle of the pixels that show an object, or nothing.
  std::optional<QPointF> middle_of(std::uint32_t id) const;
  const scene::PlacedModel& model(std::size_t number = 0) const {
    return window_->document().scene().objects.at(number);
  }

  std::unique_ptr<MainWindow> window_;
  QTemporaryDir folder_;
};

void ModelsTest::initTestCase() {
  qputenv("AEROSTAT_SCENE_DIR", AEROSTAT_SOURCE_DIR "/scenes");
  begin_with_no_settings("aerostat-models-test");
}

void ModelsTest::init() {
  window_ = std::make_unique<MainWindow>();
  window_->document().start(small_scene(), {});
  window_->show();
}

bool ModelsTest::wait_until_done() {
  return QTest::qWaitFor(
      [this] {
        const auto& shown = window_->shown();
        return shown && shown->preview.complete && shown->request == window_->request();
      },
      kPatience_ms);
}

/// Returns the point of the viewport at a place of the picture.
QPoint ModelsTest::point_of(const QPointF& place) const {
  const PictureView& view = window_->view();
  const QRect area = view.viewport()->rect();
  // The corners of the picture follow from two points inside of it, because places are linear.
  const QPointF a = area.center(), b = a + QPointF(8.0, 8.0);
  const QPointF at_a = *view.place_at(a), at_b = *view.place_at(b);
  const QPointF step((b.x() - a.x()) / (at_b.x() - at_a.x()),
                     (b.y() - a.y()) / (at_b.y() - at_a.y()));
  return QPointF(a.x() + (place.x() - at_a.x()) * step.x(),
                 a.y() + (place.y() - at_a.y()) * step.y())
      .toPoint();
}

void ModelsTest::drop(const QString& path, const QPointF& place) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  const QPoint at = window_->view().viewport()->mapTo(window_.get(), point_of(place));
  QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &event);
}

QString ModelsTest::land_from(const QString& heights) const {
  const QString path = folder_.filePath("land.json");
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return {};
  file.write(R"({"version": 1, "terrain": {"crs": "EPSG:4326", "source": ")" + heights.toUtf8() +
             "\"}}");
  return path;
}

void ModelsTest::drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers) {
  QWidget* view = window_->view().viewport();
  QTest::mousePress(view, Qt::LeftButton, modifiers, point_of(from));
  for (const double share : {0.3, 0.6, 1.0}) {
    const QPoint at = point_of(from + share * (to - from));
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                     modifiers);
    QCoreApplication::sendEvent(view, &move);
  }
  QTest::mouseRelease(view, Qt::LeftButton, modifiers, point_of(to));
}

std::optional<QPointF> ModelsTest::middle_of(std::uint32_t id) const {
  const image::Film& film = window_->shown()->preview.film;
  QPointF sum;
  int count = 0;
  for (std::size_t i = 0; i < film.object_id.size(); ++i) {
    if (film.object_id[i] != id) continue;
    const auto width = static_cast<std::size_t>(film.width);
    sum += QPointF((static_cast<double>(i % width) + 0.5) / film.width,
                   (static_cast<double>(i / width) + 0.5) / film.height);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

void ModelsTest::a_dropped_model_stands_where_it_fell() {
  QVERIFY(wait_until_done());
  QVERIFY(!middle_of(kModelId));
  const QPointF place(0.3, 0.8);
  const auto& film = window_->shown()->preview.film;
  const auto pixel = static_cast<std::size_t>(0.8 * film.height) * film.width +
                     static_cast<std::size_t>(0.3 * film.width);
  QCOMPARE(film.object_id[pixel], static_cast<std::uint32_t>(scene::ObjectId::terrain));
  drop(kHouse, place);
  QCOMPARE(window_->document().scene().objects.size(), std::size_t{1});
  QCOMPARE(QString::fromStdString(model().file), kHouse);
  QVERIFY(model().height_above == scene::HeightReference::ground);
  QCOMPARE(model().position.y, 0.0);
  QCOMPARE(*window_->models().picked(), 0);
  QCOMPARE(window_->panels().models().chosen(), QString("/objects/0"));
  QVERIFY2(window_->messages().message().isEmpty(), qPrintable(window_->messages().message()));
  QVERIFY(window_->document().set("size", "/objects/0/height_m", "60"));
  QVERIFY(wait_until_done());
  // The foot is where the file fell, and the model is seen above it.
  const auto mark = window_->models().mark();
  QVERIFY(mark);
  QVERIFY(std::abs(mark->x() - place.x()) < 0.01 && std::abs(mark->y() - place.y()) < 0.02);
  const auto seen = middle_of(kModelId);
  QVERIFY(seen);
  QVERIFY(std::abs(seen->x() - place.x()) < 0.05);
  QVERIFY(seen->y() < place.y());
  QCOMPARE(*window_->models().model_at(*seen), 0);
  window_->document().undo_stack().undo();
  window_->document().undo_stack().undo();
  QVERIFY(window_->document().scene().objects.empty());
  QVERIFY(!window_->models().picked());
  QVERIFY(!window_->models().mark());
}

void ModelsTest::a_dropped_model_stands_on_real_land() {
  // A plane that rises to the east, in degrees of latitude and longitude.
  QFile file(folder_.filePath("slope.asc"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("ncols 24\nnrows 24\nxllcorner 10\nyllcorner 47\ncellsize 0.002\n");
  for (int row = 0; row < 24; ++row) {
    for (int column = 0; column < 24; ++column) {
      file.write(QByteArray::number(500 + 10 * column) + " ");
    }
    file.write("\n");
  }
  file.close();
  QVERIFY(window_->document().open(land_from("slope.asc")));
  QVERIFY(window_->document().change("small", {{"/terrain/cells", "96"},
                                               {"/vegetation/enabled", "false"},
                                               {"/image/width", "160"},
                                               {"/image/height", "90"}}));
  QVERIFY(wait_until_done());
  const QPointF place(0.4, 0.9);
  drop(kHouse, place);
  QCOMPARE(window_->document().scene().objects.size(), std::size_t{1});
  QVERIFY(window_->document().set("size", "/objects/0/height_m", "40"));
  QVERIFY(wait_until_done());
  const auto mark = window_->models().mark();
  QVERIFY(mark);
  QVERIFY(std::abs(mark->x() - place.x()) < 0.01 && std::abs(mark->y() - place.y()) < 0.02);
  QVERIFY(middle_of(kModelId));
}

void ModelsTest::the_mouse_picks_moves_and_turns_a_model() {
  QVERIFY(wait_until_done());
  drop(kHouse, QPointF(0.3, 0.8));
  QVERIFY(window_->document().set("size", "/objects/0/height_m", "8"));
  QVERIFY(wait_until_done());
  const QPointF house = *middle_of(kModelId);
  const QPoint point = point_of(house);
  QWidget* view = window_->view().viewport();
  // A click beside the model lets it go, and a drag on it then moves the camera.
  QTest::mouseClick(view, Qt::LeftButton, {}, point_of(QPointF(0.9, 0.95)));
  QVERIFY(!window_->models().picked());
  QTest::mouseClick(view, Qt::LeftButton, {}, point);
  QCOMPARE(*window_->models().picked(), 0);

  const dvec3 before = model().position;
  const auto pose = *window_->camera().pose();
  const int steps = window_->document().undo_stack().count();
  drag(house, QPointF(0.6, 0.85));
  QVERIFY(glm::distance(model().position, before) > 1.0);
  QCOMPARE(window_->camera().pose()->position.x, pose.position.x);
  QCOMPARE(window_->document().undo_stack().count(), steps + 1);
  QVERIFY(wait_until_done());
  const auto mark = *window_->models().mark();
  QVERIFY(std::abs(mark.x() - 0.6) < 0.01 && std::abs(mark.y() - 0.85) < 0.02);

  const QPointF moved = *middle_of(kModelId);
  drag(moved, moved + QPointF(0.1, 0.0), Qt::ShiftModifier);
  QVERIFY(model().heading_deg > 5.0);
  QCOMPARE(window_->document().undo_stack().count(), steps + 2);
  window_->document().undo_stack().undo();
  QCOMPARE(model().heading_deg, 0.0);
  window_->document().undo_stack().undo();
  QCOMPARE(model().position.x, before.x);
  QCOMPARE(*window_->models().picked(), 0);
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QVERIFY(!window_->models().picked());
}

void ModelsTest::a_model_is_removed_and_comes_back() {
  QVERIFY(wait_until_done());
  drop(kHouse, QPointF(0.3, 0.8));
  drop(kHouse, QPointF(0.7, 0.8));
  QCOMPARE(*window_->models().picked(), 1);
  const dvec3 second = model(1).position;
  window_->models().pick(0);
  QTest::keyClick(&window_->view(), Qt::Key_Delete);
  QCOMPARE(window_->document().scene().objects.size(), std::size_t{1});
  QCOMPARE(model().position.x, second.x);
  QVERIFY(!window_->models().picked());
  QTest::keyClick(&window_->view(), Qt::Key_Delete);
  QCOMPARE(window_->document().scene().objects.size(), std::size_t{1});
  window_->panels().models().choose("/objects/0");
  window_->panels().models().remove();
  QVERIFY(window_->document().scene().objects.empty());
  window_->document().undo_stack().undo();
  window_->document().undo_stack().undo();
  QCOMPARE(window_->document().scene().objects.size(), std::size_t{2});
}

void ModelsTest::a_model_that_falls_into_the_sky_is_told() {
  QVERIFY(wait_until_done());
  drop(kHouse, QPointF(0.02, 0.02));
  QVERIFY(window_->document().scene().objects.empty());
  QVERIFY(window_->messages().message().contains("sky"));
  window_->take_file(kHouse, std::nullopt);
  QVERIFY(window_->document().scene().objects.empty());
  QVERIFY(window_->messages().message().contains("on the picture"));
}

void ModelsTest::a_moved_model_forgets_its_place_on_the_earth() {
  Document& document = window_->document();
  QFile file(folder_.filePath("flat.asc"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("ncols 3\nnrows 3\nxllcorner 10\nyllcorner 47\ncellsize 0.02\n");
  file.write("500 500 500\n500 500 500\n500 500 500\n");
  file.close();
  QVERIFY(document.open(land_from("flat.asc")));
  QVERIFY(document.set("model", "/objects/0",
                       R"({"file": "house.glb", "at": {"latitude_deg": 47.03, "longitude_deg":
                       10.03}})"));
  QVERIFY(document.scene().objects[0].at.has_value());
  QVERIFY(document.set("move", "/objects/0/position/0", "12"));
  QVERIFY(!document.scene().objects[0].at.has_value());
  QCOMPARE(document.scene().objects[0].position.x, 12.0);
  document.undo_stack().undo();
  QVERIFY(document.scene().objects[0].at.has_value());
}

void ModelsTest::a_picture_becomes_artwork() {
  QVERIFY(wait_until_done());
  const auto envelope = middle_of(kEnvelopeId);
  QVERIFY(envelope);
  const QImage before = window_->shown()->image;
  drop(kDrawing, *envelope);
  const auto& artwork = window_->document().scene().balloon.artwork;
  QCOMPARE(artwork.size(), std::size_t{1});
  QCOMPARE(QString::fromStdString(artwork[0].file), kDrawing);
  QVERIFY(artwork[0].wrap == scene::ArtworkWrap::motif);
  QVERIFY(window_->messages().message().contains("viewer.png"));
  QVERIFY(wait_until_done());
  // The motif lies where the picture fell.
  const QImage& after = window_->shown()->image;
  const QPoint middle(static_cast<int>(envelope->x() * after.width()),
                      static_cast<int>(envelope->y() * after.height()));
  QVERIFY(before.pixel(middle) != after.pixel(middle));
  QAbstractButton* around = nullptr;
  for (auto* button : window_->messages().findChildren<QAbstractButton*>()) {
    if (button->text() == "All Around") around = button;
  }
  QVERIFY(around != nullptr);
  around->click();
  QVERIFY(window_->document().scene().balloon.artwork[0].wrap == scene::ArtworkWrap::whole);
  QVERIFY(!window_->document().scene().balloon.artwork[0].height_m);
  window_->document().undo_stack().undo();
  window_->document().undo_stack().undo();
  QVERIFY(window_->document().scene().balloon.artwork.empty());
}

void ModelsTest::a_picture_beside_the_envelope_is_told() {
  QVERIFY(wait_until_done());
  const std::string before = window_->document().source().text();
  drop(kDrawing, QPointF(0.02, 0.98));
  QCOMPARE(window_->document().source().text(), before);
  QVERIFY2(window_->messages().message().contains("on an envelope"),
           qPrintable(window_->messages().message()));
}

void ModelsTest::files_are_named_from_the_folder_of_the_scene() {
  QVERIFY(QDir(folder_.path()).mkpath("village/models"));
  const QString near = folder_.filePath("village/models/house.glb");
  QVERIFY(QFile::copy(kHouse, near));
  Document& document = window_->document();
  const auto add = [&](const char* pointer, const QString& file) {
    return document.set("add", pointer, "{\"file\": \"" + file + "\"}");
  };
  QVERIFY(add("/objects/0", near));
  QSignalSpy told(&document, &Document::saved_with);
  const QString scene = folder_.filePath("village/scene.json");
  QVERIFY(document.save(scene));
  QCOMPARE(told.count(), 0);
  QFile saved(scene);
  QVERIFY(saved.open(QIODevice::ReadOnly));
  QVERIFY(saved.readAll().contains("\"models/house.glb\""));
  QCOMPARE(QString::fromStdString(document.scene().objects[0].file), near);
  QVERIFY(!document.is_modified());
  QVERIFY(!command_text(document, {}).contains("--allow-external-paths"));

  QVERIFY(add("/objects/1", kHouse));
  QVERIFY(document.save(scene));
  QCOMPARE(told.count(), 1);
  QVERIFY(told.at(0).at(0).toString().contains(kHouse));
  QVERIFY(window_->messages().message().contains("--allow-external-paths"));
  QVERIFY(command_text(document, {}).contains("--allow-external-paths"));
  Document opened;
  QVERIFY(opened.open(scene));
  QVERIFY(opened.scene().objects == document.scene().objects);
}

void ModelsTest::a_lens_and_its_inverse_agree_data() {
  QTest::addColumn<int>("lens");
  for (const auto lens : {scene::Lens::pinhole, scene::Lens::thin_lens, scene::Lens::panorama,
                          scene::Lens::orthographic}) {
    QTest::newRow(qPrintable(QString::number(static_cast<int>(lens)))) << static_cast<int>(lens);
  }
}

void ModelsTest::a_lens_and_its_inverse_agree() {
  QFETCH(int, lens);
  scene::Camera camera;
  camera.lens = static_cast<scene::Lens>(lens);
  camera.position = dvec3(3.0, 20.0, -7.0);
  camera.target = dvec3(40.0, 5.0, 90.0);
  for (const dvec2& place : {dvec2(0.1, 0.2), dvec2(0.5, 0.5), dvec2(0.83, 0.97)}) {
    const Sight sight = sight_at(camera, 1.5, place.x, place.y);
    const auto found = place_in_picture(camera, 1.5, sight.origin + 37.0 * sight.direction);
    QVERIFY(found);
    QVERIFY(glm::distance(*found, place) < 1e-9);
  }
  if (camera.lens == scene::Lens::panorama) return;
  const Sight beside = sight_at(camera, 1.5, 1.2, 0.5);
  QVERIFY(!place_in_picture(camera, 1.5, beside.origin + 37.0 * beside.direction));
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::ModelsTest)
#include "models_test.moc"

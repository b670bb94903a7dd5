// Tests the timeline: keys, moving through a film, playing it, and its export.
#include <QDir>
#include <QDockWidget>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "scene/film_semantics.hpp"
#include "scene/scene.hpp"
#include "small_window.hpp"
#include "viewer/film_dialog.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"
#include "viewer/timeline_keys.hpp"
#include "viewer/timeline_panel.hpp"
#include "viewer/timeline_slider.hpp"

namespace aerostat::viewer {
namespace {

/// The longest wait in milliseconds. Kernels may have to be compiled first.
constexpr int kPatience_ms = 180000;

/// Returns a small film of 21 frames in two seconds, in which the balloon climbs.
scene::SceneSource small_film() {
  return small_scene().with({{"/film", R"({"duration_s": 2.1, "fps": 10, "wind": [], "keys": [
                     {"value": "/balloon/position/1", "ease": "linear",
                      "keys": [{"time_s": 0, "is": 20}, {"time_s": 2, "is": 60}]}]})"}});
}

}  // namespace

class TimelineTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { begin_with_no_settings("aerostat-viewer-timeline-test"); }
  void init() { QSettings().clear(); }
  void keys_are_set_in_order_and_removed();
  void values_of_every_kind_make_keys();
  void all_values_for_keys_can_move();
  void it_opens_for_scenes_with_a_film();
  void a_frame_shows_its_moment();
  void keys_are_edited_at_the_frame();
  void what_cannot_be_a_key_is_told();
  void the_slider_shows_keys_and_follows_clicks();
  void it_plays_to_the_end_and_pauses();
  void a_film_is_exported_and_goes_on();
  void a_film_is_cancelled();

 private:
  static bool wait_for_picture(MainWindow& window);
};

bool TimelineTest::wait_for_picture(MainWindow& window) {
  return QTest::qWaitFor(
      [&window] {
        const auto& shown = window.shown();
        return shown && shown->preview.complete && shown->request == window.request();
      },
      kPatience_ms);
}

void TimelineTest::keys_are_set_in_order_and_removed() {
  QString keys = with_key("[]", "/sun/elevation_deg", 2.0, "30");
  keys = with_key(keys, "/sun/elevation_deg", 0.5, "10");
  keys = with_key(keys, "/balloon/burner", 1.0, "0.5");
  keys = with_key(keys, "/sun/elevation_deg", 2.00001, "31");
  QCOMPARE(keys, QString(R"([{"keys":[{"is":10,"time_s":0.5},{"is":31,"time_s":2.00001}],)"
                         R"("value":"/sun/elevation_deg"},)"
                         R"({"keys":[{"is":0.5,"time_s":1}],"value":"/balloon/burner"}])"));
  keys = without_key(keys, "/sun/elevation_deg", 0.5);
  keys = without_key(keys, "/balloon/burner", 1.0);
  QCOMPARE(keys,
           QString(R"([{"keys":[{"is":31,"time_s":2.00001}],"value":"/sun/elevation_deg"}])"));
  QCOMPARE(without_key(keys, "/sun/elevation_deg", 0.7), keys);
  QCOMPARE(without_key(keys, "/seed", 0.5), keys);
  // The easing of a track stays.
  QVERIFY(with_key(R"([{"value": "/a", "ease": "hold", "keys": []}])", "/a", 1.0, "1")
              .contains(R"("ease":"hold")"));
}

void TimelineTest::values_of_every_kind_make_keys() {
  Document document;
  const std::pair<const char*, const char*> values[] = {{"/balloon/position", "[1, 2, 3.5]"},
                                                        {"/sun/time", "06:30"},
                                                        {"/image/spp", "4"},
                                                        {"/balloon/pattern", "\"spiral\""}};
  for (const auto& [pointer, value] : values) {
    QVERIFY2(document.set("key", "/film/keys",
                          with_key(document.value("/film/keys"), pointer, 1.0, value)),
             pointer);
    QVERIFY(has_key(document.scene().film.keys, pointer, 1.0));
    QVERIFY(!has_key(document.scene().film.keys, pointer, 1.5));
  }
}

void TimelineTest::all_values_for_keys_can_move() {
  const QStringList values = values_for_keys(small_film().scene().film.keys);
  QCOMPARE(values.front(), QString("/balloon/position/1"));
  QVERIFY(values.size() > 60);
  QCOMPARE(QSet<QString>(values.begin(), values.end()).size(), values.size());
  for (const QString& value : values) {
    QVERIFY2(scene::key_kind(value.toStdString()).has_value(), qPrintable(value));
  }
}

void TimelineTest::it_opens_for_scenes_with_a_film() {
  MainWindow window;
  window.show();
  auto* dock = window.findChild<QDockWidget*>("timeline");
  window.document().start(small_scene(), {});
  QVERIFY(!dock->isVisible());
  window.document().start(small_film(), {});
  QVERIFY(dock->isVisible());
  QCOMPARE(window.timeline().frames(), 21);
  QVERIFY(!window.timeline().shown_time());
  window.timeline().go_to(5);
  QVERIFY(window.timeline().shown_time());
  dock->toggleViewAction()->trigger();
  QVERIFY2(!window.timeline().shown_time(), "without it, the still picture is shown");
}

void TimelineTest::a_frame_shows_its_moment() {
  MainWindow window;
  window.document().start(small_film(), {});
  window.show();
  QVERIFY(wait_for_picture(window));
  const double still = window.shown()->preview.scene->balloon.position.y;
  const auto height_at = [&window, still](int frame) {
    window.timeline().go_to(frame);
    return wait_for_picture(window) ? window.shown()->preview.scene->balloon.position.y - still
                                    : -1.0;
  };
  const double first = height_at(1);
  QVERIFY(qAbs(height_at(11) - first - 20.0) < 1e-6);
  QVERIFY(qAbs(height_at(21) - first - 40.0) < 1e-6);
  QCOMPARE(window.shown()->image.size(), QSize(160, 90));
  // An edit changes the frame that is shown.
  QVERIFY(window.document().set("key", "/film/keys/0/keys/1/is", "100"));
  QVERIFY(wait_for_picture(window));
  QVERIFY(qAbs(window.shown()->preview.scene->balloon.position.y - still - first - 80.0) < 1e-6);
  window.timeline().show_still();
  QVERIFY(wait_for_picture(window));
  QCOMPARE(window.shown()->preview.scene->balloon.position.y, still);
  QVERIFY(window.messages().message().isEmpty());
}

void TimelineTest::keys_are_edited_at_the_frame() {
  Document document;
  document.start(small_film(), {});
  TimelinePanel timeline(document);
  timeline.go_to(11);
  QCOMPARE(timeline.value_text().toDouble(), 40.0);
  timeline.set_key("55");
  QCOMPARE(document.scene().film.keys[0].keys.size(), 3u);
  QCOMPARE(document.scene().film.keys[0].keys[1].time_s, 1.0);
  QCOMPARE(document.scene().film.keys[0].keys[1].is.numbers[0], 55.0);
  timeline.remove_key();
  QCOMPARE(document.scene().film.keys[0].keys.size(), 2u);
  document.undo_stack().undo();
  QCOMPARE(document.scene().film.keys[0].keys.size(), 3u);
  timeline.choose_value("/sun/elevation_deg");
  timeline.set_key("12");
  QCOMPARE(document.scene().film.keys.size(), 2u);
  QCOMPARE(timeline.value_text().toDouble(), 12.0);
  timeline.remove_key();
  QCOMPARE(document.scene().film.keys.size(), 1u);
}

void TimelineTest::what_cannot_be_a_key_is_told() {
  Document document;
  document.start(small_film(), {});
  TimelinePanel timeline(document);
  QStringList told;
  connect(&document, &Document::failed, [&told](const QString& message) { told << message; });
  timeline.set_key("\"high\"");
  timeline.choose_value("/biome/kind");
  timeline.set_key("\"snow\"");
  QCOMPARE(told.size(), 2);
  QVERIFY(told[0].contains("a number from"));
  QVERIFY(told[1].contains("/biome/kind"));
  QCOMPARE(document.scene().film.keys.size(), 1u);
  QCOMPARE(document.scene().film.keys[0].keys.size(), 2u);
}

void TimelineTest::the_slider_shows_keys_and_follows_clicks() {
  Document document;
  document.start(small_film(), {});
  TimelinePanel timeline(document);
  timeline.resize(600, 80);
  timeline.show();
  QCOMPARE(timeline.slider().marks().size(), 2u);
  QVERIFY(timeline.slider().marks()[0].is_chosen);
  QCOMPARE(timeline.slider().marks()[1].frame, 21.0);
  timeline.choose_value("/sun/elevation_deg");
  QVERIFY(!timeline.slider().marks()[0].is_chosen);
  TimelineSlider& slider = timeline.slider();
  QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(slider.width() - 3, slider.height() / 2));
  QCOMPARE(timeline.frame(), 21);
  QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(slider.width() / 2, slider.height() / 2));
  QCOMPARE(timeline.frame(), 11);
  QTest::keyClick(&slider, Qt::Key_Left);
  QCOMPARE(timeline.frame(), 10);
  QVERIFY(timeline.position_text().contains("10 of 21"));
}

void TimelineTest::it_plays_to_the_end_and_pauses() {
  MainWindow window;
  window.document().start(small_film(), {});
  window.show();
  QVERIFY(wait_for_picture(window));
  TimelinePanel& timeline = window.timeline();
  int last = 0, shown = 0;
  bool is_rising = true;
  connect(&timeline, &TimelinePanel::time_changed, this, [&] {
    is_rising = is_rising && timeline.frame() >= last;
    last = timeline.frame();
    ++shown;
  });
  timeline.play();
  QVERIFY(QTest::qWaitFor([&] { return !timeline.is_playing(); }, kPatience_ms));
  QCOMPARE(timeline.frame(), 21);
  QVERIFY(is_rising);
  QVERIFY(shown >= 2);
  // From the end, it plays from the beginning; a move of the slider pauses.
  last = 0;
  timeline.play();
  QVERIFY(timeline.frame() < 21);
  timeline.slider().setValue(7);
  QVERIFY(!timeline.is_playing());
  QCOMPARE(timeline.frame(), 7);
  QVERIFY(wait_for_picture(window));
  QVERIFY(window.messages().message().isEmpty());
}

void TimelineTest::a_film_is_exported_and_goes_on() {
  QTemporaryDir folder;
  Document document;
  document.start(small_film().with({{"/film/duration_s", "0.4"}}), {});
  FilmDialog dialog(document, {});
  dialog.set_path(folder.filePath("f/##.png"));
  dialog.set_quality("draft");
  for (const char* end : {"4 frames rendered, 0 kept", "0 frames rendered, 4 kept"}) {
    QSignalSpy ended(&dialog, &FilmDialog::ended);
    dialog.begin();
    QVERIFY(dialog.is_busy());
    QVERIFY(ended.wait(kPatience_ms));
    QVERIFY2(ended[0][0].toBool() && dialog.message().contains(end), qPrintable(dialog.message()));
  }
  QCOMPARE(QDir(folder.filePath("f")).entryList({"*.png"}, QDir::Files),
           QStringList({"01.png", "02.png", "03.png", "04.png", "contact-sheet.png"}));
  QCOMPARE(QImage(folder.filePath("f/03.png")).size(), QSize(160, 90));
  // Another name than that of a film is refused in words.
  dialog.set_path(folder.filePath("film.gif"));
  QSignalSpy ended(&dialog, &FilmDialog::ended);
  dialog.begin();
  QVERIFY(ended.wait(kPatience_ms));
  QVERIFY(dialog.message().contains(".webm"));
}

void TimelineTest::a_film_is_cancelled() {
  QTemporaryDir folder;
  Document document;
  document.start(small_film().with({{"/film/duration_s", "600"}}), {});
  FilmDialog dialog(document, {});
  dialog.show();
  dialog.set_path(folder.filePath("#.png"));
  QSignalSpy ended(&dialog, &FilmDialog::ended);
  dialog.begin();
  QVERIFY(QTest::qWaitFor([&] { return QFile::exists(folder.filePath("2.png")); }, kPatience_ms));
  dialog.reject();
  QVERIFY(ended.count() == 1 || ended.wait(kPatience_ms));
  QVERIFY(!ended[0][0].toBool());
  QVERIFY(dialog.message().contains("Cancelled"));
  QVERIFY(QFile::exists(folder.filePath("1.png")));
  QVERIFY(dialog.isVisible());
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::TimelineTest)
#include "timeline_test.moc"

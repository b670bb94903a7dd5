// Tests files that other programs change, remove or create while the window is open.
#include <QAbstractButton>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

#include "small_window.hpp"
#include "viewer/export_dialog.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"
#include "viewer/scene_files.hpp"

namespace aerostat::viewer {
namespace {

/// The longest wait in milliseconds. Kernels may have to be compiled first.
constexpr int kPatience_ms = 180000;

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(bytes), bytes.size());
}

const QByteArray kOther = "{\"version\": 1, \"biome\": \"sand\"}";

/// Presses the given button of the next question, and counts the questions.
class Answer {
 public:
  explicit Answer(const QString& text) {
    QObject::connect(&timer_, &QTimer::timeout, [this, text] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      for (QAbstractButton* button : box->buttons()) {
        if (button->text().remove('&') != text) continue;
        ++questions;
        button->click();
        return;
      }
    });
    timer_.start(20);
  }
  int questions = 0;

 private:
  QTimer timer_;
};

}  // namespace

class FilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { begin_with_no_settings("aerostat-viewer-files-test"); }
  void init();
  void a_save_asks_about_a_file_that_was_changed_data();
  void a_save_asks_about_a_file_that_was_changed();
  void a_save_does_not_ask_without_need();
  void a_save_goes_through_a_link();
  void a_change_on_disk_is_told();
  void a_removed_file_is_told_and_saved_anew();
  void an_export_spares_the_scene();
  void an_export_asks_about_an_older_file();
  void an_export_asks_about_a_file_that_appeared_data();
  void an_export_asks_about_a_file_that_appeared();

 private:
  QString path(const char* name) const { return folder_->filePath(QString::fromLatin1(name)); }
  std::unique_ptr<QTemporaryDir> folder_;
};

void FilesTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
}

void FilesTest::a_save_asks_about_a_file_that_was_changed_data() {
  QTest::addColumn<QString>("button");
  for (const char* button : {"Overwrite", "Reload", "Cancel"}) QTest::newRow(button) << button;
}

void FilesTest::a_save_asks_about_a_file_that_was_changed() {
  QFETCH(QString, button);
  QWidget window;
  Document document;
  SceneFiles files(document, &window);
  QVERIFY(document.save(path("scene.json")));
  QVERIFY(document.set("seed", "/terrain/seed", "5"));
  put(path("scene.json"), kOther);
  const Answer answer(button);
  QCOMPARE(files.save(), button == "Overwrite");
  QCOMPARE(answer.questions, 1);
  QCOMPARE(bytes_of(path("scene.json")) == kOther, button != "Overwrite");
  QCOMPARE(document.value("/biome/kind"), QString(button == "Reload" ? "\"sand\"" : "\"snow\""));
  QCOMPARE(document.is_modified(), button == "Cancel");
}

void FilesTest::a_save_does_not_ask_without_need() {
  QWidget window;
  Document document;
  SceneFiles files(document, &window);
  QVERIFY(document.save(path("scene.json")));
  const Answer answer("Cancel");
  for (const char* seed : {"5", "6"}) {
    QVERIFY(document.set("seed", "/terrain/seed", seed));
    QVERIFY(files.save());
  }
  QVERIFY(document.open(path("scene.json")));
  QVERIFY(files.save());
  QCOMPARE(answer.questions, 0);
}

void FilesTest::a_save_goes_through_a_link() {
  Document document;
  QVERIFY(QFile::link("real.json", path("link.json")));
  QVERIFY(document.save(path("link.json")));
  QVERIFY(QFileInfo(path("link.json")).isSymLink());
  QVERIFY(bytes_of(path("real.json")).contains("snow"));
}

void FilesTest::a_change_on_disk_is_told() {
  MainWindow window;
  window.document().start(small_scene(), {});
  QVERIFY(window.document().save(path("scene.json")));
  QTest::qWait(500);
  QVERIFY2(window.messages().message().isEmpty(), "of what it wrote itself");
  put(path("new.json"), kOther);
  QVERIFY(QFile::remove(path("scene.json")));
  QVERIFY(QFile::rename(path("new.json"), path("scene.json")));
  QTRY_VERIFY(window.messages().message().contains("changed scene.json"));
  for (auto* button : window.messages().findChildren<QPushButton*>()) {
    if (button->text() == "Reload") button->click();
  }
  QCOMPARE(window.document().source().value("/biome/kind"), std::string("\"sand\""));
  QVERIFY(!window.document().is_modified());
}

void FilesTest::a_removed_file_is_told_and_saved_anew() {
  QWidget window;
  Document document;
  SceneFiles files(document, &window);
  QSignalSpy told(&files, &SceneFiles::changed_elsewhere);
  QVERIFY(document.save(path("scene.json")));
  QVERIFY(QFile::remove(path("scene.json")));
  QTRY_COMPARE(told.count(), 1);
  QVERIFY(!told.at(0).at(1).toBool());
  QVERIFY(files.save());
  QVERIFY(QFile::exists(path("scene.json")));
}

void FilesTest::an_export_spares_the_scene() {
  Document document;
  QVERIFY(document.save(path("scene.json")));
  const QByteArray before = bytes_of(path("scene.json"));
  QVERIFY(QFile::link("scene.json", path("link.png")));
  for (const char* name : {"scene.json", "link.png"}) {
    ExportDialog dialog(document, {});
    dialog.set_path(path(name));
    dialog.begin();
    QVERIFY(!dialog.is_busy());
    QVERIFY(dialog.message().contains("scene file"));
  }
  QCOMPARE(bytes_of(path("scene.json")), before);
}

/// Tests that an export asks before it replaces an older file, because the user has not chosen the
/// suggested name.
void FilesTest::an_export_asks_about_an_older_file() {
  Document document;
  document.start(small_scene(), {});
  QVERIFY(document.save(path("scene.json")));
  put(path("scene.png"), "older");
  ExportDialog dialog(document, {});
  const Answer answer("No");
  dialog.begin();
  QCOMPARE(answer.questions, 1);
  QVERIFY(!dialog.is_busy());
  QCOMPARE(bytes_of(path("scene.png")), QByteArray("older"));
}

void FilesTest::an_export_asks_about_a_file_that_appeared_data() {
  QTest::addColumn<QString>("button");
  for (const char* button : {"Overwrite", "Discard"}) QTest::newRow(button) << button;
}

void FilesTest::an_export_asks_about_a_file_that_appeared() {
  QFETCH(QString, button);
  Document document;
  document.start(small_scene(), {});
  ExportDialog dialog(document, {});
  dialog.set_path(path("picture.png"));
  dialog.set_quality("draft");
  QSignalSpy ended(&dialog, &ExportDialog::ended);
  const Answer answer(button);
  dialog.begin();
  put(path("picture.png"), "of another");
  QVERIFY(ended.wait(kPatience_ms));
  QCOMPARE(answer.questions, 1);
  QCOMPARE(ended.at(0).at(0).toBool(), button == "Overwrite");
  QCOMPARE(bytes_of(path("picture.png")) == "of another", button == "Discard");
  QVERIFY(!dialog.is_busy());
}

}  // namespace aerostat::viewer

QTEST_MAIN(aerostat::viewer::FilesTest)
#include "files_test.moc"

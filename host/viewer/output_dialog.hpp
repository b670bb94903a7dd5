#pragma once

#include <QDialog>
#include <QString>

#include "scene/source.hpp"
#include "viewer/document.hpp"
#include "viewer/output_job.hpp"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace aerostat::viewer {

/// A dialog that asks for a file and a quality and makes the file. The work can be cancelled, and
/// it is given up if the device hangs.
class OutputDialog : public QDialog {
  Q_OBJECT

 public:
  void set_path(const QString& path);
  /// Sets the quality by its word, such as "draft", or by nothing for that of the scene.
  void set_quality(const QString& quality);
  void begin();
  bool is_busy() const { return job_ != nullptr; }
  QString message() const;

 public Q_SLOTS:
  /// Cancels the work if there is any, else closes the dialog.
  void reject() override;

 Q_SIGNALS:
  void ended(bool written);

 protected:
  /// The translated texts of a dialog.
  struct Words {
    QString title;
    QString suffix;     // which a name without one gets
    QString filter;     // of the dialog that asks for a file
    QString is_scene;   // the file is that of the scene itself
    QString cancelled;  // the work was cancelled
    QString silent;     // the device has not answered for %1 s
    QString given_up;   // the work was given up, because the device did not answer
  };

  OutputDialog(const Document& document, const QString& device, Words words, QWidget* parent);

  /// Adds a quality to the list.
  void add_quality(const QString& text, const QString& word);
  /// Adds the qualities of scenes, and that of the present scene.
  void add_scene_qualities();
  /// Returns the word of the quality.
  QString quality() const;
  /// Adds a row to the form.
  void add_row(const QString& label, QWidget* row);
  /// Puts all parts into their places, with a hint below the form.
  void lay_out(const QString& hint, int width);

  /// Returns whether all that was typed can be read. If not, it tells what is wrong.
  virtual bool is_ready() { return true; }
  /// Makes a job for a file, hands it to `follow` and starts it. Throws if it cannot be started.
  virtual void start(const QString& path) = 0;

  const Document& document() const { return document_; }
  const QString& device() const { return device_; }
  /// Returns a scene in the quality of the dialog. Samples and light come from the quality,
  /// whatever the scene says about them.
  scene::SceneSource in_quality(const scene::SceneSource& source) const;
  void tell(const QString& message);
  /// Shows the progress of a job that is about to start, and its end.
  void follow(OutputJob::Handle job);
  void end(bool written, const QString& message);

 private:
  void choose_path();
  bool may_write(const QString& path);
  void show_progress(double fraction, const QString& text);
  void set_busy(bool busy);

  const Document& document_;
  QString device_;
  Words words_;
  /// The path of a file that may be replaced without a question.
  QString agreed_path_;
  QWidget* inputs_;
  QFormLayout* form_;
  QLineEdit* path_;
  QComboBox* quality_;
  QProgressBar* progress_;
  QLabel* message_;
  QPushButton* export_;
  QPushButton* close_;
  OutputJob::Handle job_;
};

}  // namespace aerostat::viewer

#pragma once

#include <QDialog>

#include "viewer/document.hpp"
#include "viewer/export_job.hpp"
#include "viewer/number_box.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace aerostat::viewer {

/// A dialog that asks for the file, the size and the quality of a picture and renders it. The
/// render can be cancelled.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(const Document& document, const QString& device, QWidget* parent = nullptr);
  ~ExportDialog() override;

  void set_path(const QString& path);
  /// Sets the quality, which is "draft", "standard" or "final".
  void set_quality(const QString& quality);
  void begin();
  bool is_busy() const { return job_ != nullptr; }
  QString message() const;

 public Q_SLOTS:
  /// Cancels the export if one is running, else closes the dialog.
  void reject() override;

 Q_SIGNALS:
  void ended(bool written);

 private:
  void build();
  void choose_path();
  void show_progress(double fraction, const QString& stage);
  void show_silence(int seconds);
  void end(bool written, const QString& error);
  bool may_write(const QString& path);
  void ask_about_file(QString path);
  void set_busy(bool busy);
  std::vector<scene::Override> changes() const;

  const Document& document_;
  QString device_;
  /// The path of a file that may be replaced without a question.
  QString agreed_path_;
  QLineEdit* path_;
  QComboBox* quality_;
  WholeBox* width_;
  WholeBox* height_;
  QProgressBar* progress_;
  QLabel* message_;
  QPushButton* browse_;
  QPushButton* export_;
  QPushButton* close_;
  ExportJob::Handle job_;
};

}  // namespace aerostat::viewer
